#include "exhibits/stability/poison.h"

#include "exhibits/kit/exhibit_pass.h"

#include <cmath>
#include <limits>
#include <set>

namespace vitrine::stability {
namespace {

std::set<std::string> writtenBy(const render::FramePlan& plan)
{
    std::set<std::string> written;
    for (const render::Pass& pass : plan.passes())
        for (const std::string& name : outputsOf(pass)) written.insert(name);
    return written;
}

std::string at(const std::string& image, int x, int y, int channel, const std::string& what)
{
    return image + ": " + what + " at pixel " + std::to_string(x) + ',' + std::to_string(y) + ", channel " +
           std::to_string(channel);
}

/// Calls `fault(x, y, channel)` for every value. Returns the first result that is not empty.
template <typename Fault> std::string firstFault(const render::Image& image, const Fault& fault)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                if (std::string found = fault(x, y, c); !found.empty()) return found;
    return {};
}

std::string faultOfValue(const std::string& name, int x, int y, int c, float value)
{
    if (std::isnan(value)) return at(name, x, y, c, "NaN, or a texel that nobody wrote");
    if (std::isinf(value)) return at(name, x, y, c, "infinity");
    return {};
}

std::string faultOfLight(const std::string& name, const render::Image& image)
{
    return firstFault(image, [&](int x, int y, int c) {
        const float value = image.at(x, y, c);
        std::string fault = faultOfValue(name, x, y, c, value);
        return fault.empty() && value < -1e-3F ? at(name, x, y, c, "negative light") : fault;
    });
}

std::string faultOfDepth(const std::string& name, const render::Image& image, bool poisonedBefore)
{
    return firstFault(image, [&](int x, int y, int c) {
        const float value = image.at(x, y, c);
        if (poisonedBefore && value == spreadingPoison().depth) return at(name, x, y, c, "a texel that nobody wrote");
        return value >= 0 && value <= 1 ? std::string() : at(name, x, y, c, "a depth outside 0 to 1");
    });
}

std::string faultOfNormals(const std::string& name, const render::Image& image)
{
    return firstFault(image, [&](int x, int y, int c) {
        if (std::string fault = faultOfValue(name, x, y, c, image.at(x, y, c)); !fault.empty() || c != 2) return fault;
        const double length = std::hypot(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2));
        return length == 0 || std::abs(length - 1) < 1e-2
                   ? std::string()
                   : at(name, x, y, c, "a normal of length " + std::to_string(length));
    });
}

}  // namespace

std::string faultOfImages(const render::FramePlan& plan, render::RenderBackend& backend, const Channels& channels)
{
    if (std::string fault = faultOfLight("frame", backend.read("frame")); !fault.empty()) return fault;
    if (std::string fault = faultOfLight(radianceImage, backend.read(radianceImage)); !fault.empty()) return fault;
    if (std::string fault = faultOfDepth(depthImage, backend.read(depthImage), true); !fault.empty()) return fault;
    if (channels.normal) {
        if (std::string fault = faultOfNormals(normalImage, backend.read(normalImage)); !fault.empty()) return fault;
    }
    if (channels.evaluations) {
        if (std::string fault = faultOfLight(evaluationsImage, backend.read(evaluationsImage)); !fault.empty())
            return fault;
    }
    for (const std::string& name : writtenBy(plan)) {
        const auto info = plan.images().find(name);
        if (info == plan.images().end() || !info->second.persistent) continue;
        const render::Image image = backend.read(name);
        std::string fault = info->second.format == render::Format::depth32f
                                ? faultOfDepth(name, image, false)
                                : firstFault(image, [&](int x, int y, int c) {
                                      return faultOfValue(name, x, y, c, image.at(x, y, c));
                                  });
        if (!fault.empty()) return fault;
    }
    return {};
}

Poison spreadingPoison()
{
    return {glm::vec4(std::numeric_limits<float>::quiet_NaN()), 0.841471F};
}

render::FramePlan poisoned(const render::FramePlan& plan, const Poison& poison)
{
    std::vector<render::Pass> fills;
    const std::set<std::string> written = writtenBy(plan);
    for (const auto& [name, info] : plan.images()) {
        if (info.persistent || !written.contains(name)) continue;
        for (int level = 0; level < info.levels; ++level) {
            render::Pass fill;
            fill.name = "poison " + name + ' ' + std::to_string(level);
            fill.reason = "to see who reads what nobody wrote";
            fill.shader = meshDepth().shader;
            const bool depth = info.format == render::Format::depth32f;
            const render::Attachment target{.image = name,
                                            .load = render::Load::clear,
                                            .clear = depth ? glm::vec4(poison.depth) : poison.color,
                                            .level = level};
            if (depth)
                fill.depth = target;
            else
                fill.colors = {target};
            fills.push_back(std::move(fill));
        }
    }
    return plan.withPassesFirst(std::move(fills));
}

}  // namespace vitrine::stability
