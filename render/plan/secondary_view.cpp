#include "render/plan/secondary_view.h"

#include <algorithm>
#include <bit>
#include <set>
#include <utility>

namespace vitrine::render {
namespace {

/// Returns whether another view changes the content of the images that the pass writes.
bool dependsOnView(const Pass& pass)
{
    if (pass.phase == PassPhase::simulate || pass.phase == PassPhase::shadow || pass.phase == PassPhase::probe)
        return false;
    return !pass.contentHash && !(pass.colors.empty() && !pass.depth && pass.storage.empty());
}

/// Images of a secondary view: maps the names of the original images to those of the copies.
class Renamed {
public:
    Renamed(const FramePlan& seen, const SecondaryView& elsewhere) : seen_(seen), elsewhere_(elsewhere) {}

    void add(const std::string& image) { names_.emplace(image, elsewhere_.name + '.' + image); }
    void rename(std::string& image) const
    {
        if (const auto found = names_.find(image); found != names_.end()) image = found->second;
        for (const auto& [name, state] : seen_.histories())
            if (image == previous(name) && names_.contains(name)) image = previous(names_.at(name));
    }
    void rename(std::vector<SampledTexture>& inputs) const
    {
        for (SampledTexture& input : inputs)
            if (auto* image = std::get_if<std::string>(&input.source)) rename(*image);
    }
    void declareIn(FramePlan& plan) const
    {
        for (const auto& [old, name] : names_) {
            const auto declared = seen_.images().find(old);
            if (declared == seen_.images().end()) continue;
            ImageInfo info = declared->second;
            info.ownPixels = info.hasOwnPixels();
            info.size = sizeOf(info, elsewhere_.view.raster);
            info.divisor = 0;
            info.levels = std::min(info.levels, static_cast<int>(std::bit_width(
                                                    static_cast<unsigned>(std::max({info.size.x, info.size.y, 1})))));
            info.name = name;
            const auto history = seen_.histories().find(old);
            if (history == seen_.histories().end()) {
                plan.image(std::move(info));
                continue;
            }
            History copy = history->second.history;
            copy.image = std::move(info);
            copy.view = elsewhere_.view;
            plan.history(std::move(copy));
        }
    }
    [[nodiscard]] const std::map<std::string, std::string>& names() const { return names_; }

private:
    const FramePlan& seen_;
    const SecondaryView& elsewhere_;
    std::map<std::string, std::string> names_;
};

View viewOf(const Pass& pass, const FramePlan& seen, const SecondaryView& elsewhere)
{
    if (pass.view) return *pass.view;
    for (const std::string& image : outputsOf(pass))
        if (const auto info = seen.images().find(image); info != seen.images().end() && info->second.hasOwnPixels())
            return viewOfOwnPixels(elsewhere.view, info->second);
    return elsewhere.view;
}

/// Reduces the pass to its depth. Returns false if it writes no depth.
bool keepDepth(Pass& pass)
{
    const bool writes = pass.depth && (pass.state.depthWrite || pass.depth->load == Load::clear);
    if (!writes || pass.phase > PassPhase::opaque) return false;
    pass.colors.clear();
    pass.triangleSamples = nullptr;
    if (!pass.depthOnly) return true;
    pass.shader = pass.depthOnly->shader;
    pass.inputs = pass.depthOnly->inputs;
    for (Draw& draw : pass.draws) draw.inputs.clear();
    return true;
}

/// Keeps the passes that write depth and those that prepare something for them. `passes` are in drawing order.
std::vector<Pass> depthOf(std::vector<Pass> passes)
{
    std::vector<Pass> kept;
    std::set<std::string> read;
    for (auto pass = passes.rbegin(); pass != passes.rend(); ++pass) {
        const std::vector<std::string> outputs = outputsOf(*pass);
        const bool prepares =
            pass->phase == PassPhase::prepare &&
            std::any_of(outputs.begin(), outputs.end(), [&](const std::string& name) { return read.contains(name); });
        if (!keepDepth(*pass) && !prepares) continue;
        for (const std::string& name : inputsOf(*pass)) read.insert(name);
        kept.insert(kept.begin(), std::move(*pass));
    }
    return kept;
}

}  // namespace

std::map<std::string, std::string> addSecondaryView(FramePlan& plan, const FramePlan& seen,
                                                    const SecondaryView& elsewhere)
{
    std::vector<Pass> passes;
    for (const Pass& pass : seen.passes()) {
        Pass copy = pass;
        if (dependsOnView(pass) && (!elsewhere.take || elsewhere.take(copy))) passes.push_back(std::move(copy));
    }
    std::stable_sort(passes.begin(), passes.end(), [](const Pass& a, const Pass& b) { return a.phase < b.phase; });
    if (elsewhere.depthOnly) passes = depthOf(std::move(passes));
    Renamed renamed(seen, elsewhere);
    for (const Pass& pass : passes)
        for (const std::string& image : outputsOf(pass))
            if (!seen.buffers().contains(image)) renamed.add(image);
    for (Pass& pass : passes) {
        pass.view = viewOf(pass, seen, elsewhere);
        pass.name = elsewhere.name + '/' + pass.name;
        pass.reason = elsewhere.reason;
        pass.phase = elsewhere.phase;
        for (Attachment& color : pass.colors) renamed.rename(color.image);
        if (pass.depth) renamed.rename(pass.depth->image);
        for (Attachment& storage : pass.storage) renamed.rename(storage.image);
        for (std::string& image : pass.mipmaps) renamed.rename(image);
        renamed.rename(pass.inputs);
        for (Draw& draw : pass.draws) renamed.rename(draw.inputs);
    }
    renamed.declareIn(plan);
    for (Pass& pass : passes) plan.add(std::move(pass));
    return renamed.names();
}

}  // namespace vitrine::render
