#include "exhibits/study/study_picture.h"

#include "render/measure/distance.h"

#include <algorithm>
#include <cmath>

namespace vitrine::study {

render::Image colorsOf(const render::Image& from)
{
    render::Image to(from.width, from.height, 4);
    to.channelNames = {"R", "G", "B", "A"};
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x)
            for (int c = 0; c < 4; ++c) to.at(x, y, c) = from.at(x, y, c);
    return to;
}

render::Image resampled(const render::Image& from, glm::ivec2 size)
{
    render::Image to(size.x, size.y, 4);
    to.channelNames = {"R", "G", "B", "A"};
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec2 at =
                (glm::dvec2(x, y) + 0.5) * glm::dvec2(from.width, from.height) / glm::dvec2(size) - 0.5;
            const glm::ivec2 low = glm::ivec2(glm::floor(at));
            const glm::dvec2 t = at - glm::dvec2(low);
            for (int c = 0; c < 4; ++c) {
                const auto texel = [&](int dx, int dy) {
                    return static_cast<double>(from.at(std::clamp(low.x + dx, 0, from.width - 1),
                                                       std::clamp(low.y + dy, 0, from.height - 1), c));
                };
                to.at(x, y, c) = static_cast<float>(
                    glm::mix(glm::mix(texel(0, 0), texel(1, 0), t.x), glm::mix(texel(0, 1), texel(1, 1), t.x), t.y));
            }
        }
    }
    return to;
}

std::int64_t channelTotal(const render::Image& picture, std::string_view name)
{
    const int channel = render::channelNamed(picture, name);
    if (channel < 0) return 0;
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) sum += picture.at(x, y, channel);
    return std::llround(sum);
}

void eraseStateCounters(std::map<std::string, std::int64_t>& counters)
{
    for (const char* name : {"framebuffers made", "images", "programs"}) counters.erase(name);
}

}  // namespace vitrine::study
