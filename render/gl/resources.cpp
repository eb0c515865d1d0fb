#include "render/gl/resources.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace vitrine::render::gl {
namespace {

glm::ivec2 sizeOf(const ImageInfo& info, glm::ivec2 frameSize)
{
    if (info.size.x > 0 && info.size.y > 0) return info.size;
    const glm::dvec2 scaled = glm::ceil(glm::dvec2(frameSize) * info.scale);
    return glm::max(glm::ivec2(scaled), glm::ivec2(1));
}

bool sameStorage(const ImageInfo& a, const ImageInfo& b)
{
    return a.format == b.format && a.shape == b.shape && a.layers == b.layers && a.levels == b.levels &&
           a.comparison == b.comparison && a.repeat == b.repeat && a.nearest == b.nearest;
}

}  // namespace

std::vector<std::string> Resources::prepare(const FramePlan& plan, glm::ivec2 frameSize)
{
    std::set<std::string> used;
    for (const Pass& pass : plan.passes()) {
        for (std::string& name : inputsOf(pass)) used.insert(std::move(name));
        for (std::string& name : outputsOf(pass)) used.insert(std::move(name));
    }
    for (const auto& [name, info] : plan.images())
        if (info.kept) used.insert(name);
    std::vector<std::string> lost;
    std::erase_if(images_, [&](const auto& entry) {
        if (used.contains(entry.first)) return false;
        if (entry.second.info.kept) lost.push_back(entry.first);
        return true;
    });

    for (const auto& [name, info] : plan.images()) {
        if (!used.contains(name)) continue;
        const glm::ivec2 size = sizeOf(info, frameSize);
        const auto stored = images_.find(name);
        if (stored != images_.end() && sameStorage(stored->second.info, info) && stored->second.texture.size() == size) continue;
        if (stored != images_.end()) images_.erase(stored);
        images_.emplace(name, StoredImage{info, Texture(info, size)});
        if (info.kept) lost.push_back(name);
    }
    return lost;
}

const Texture& Resources::image(const std::string& name) const
{
    return images_.at(name).texture;
}

Stored Resources::stored() const
{
    Stored sum{"images"};
    for (const auto& [name, image] : images_) sum.add(image.texture.bytes());
    return sum;
}

void Resources::abandon()
{
    for (auto& [name, stored] : images_) stored.texture.abandon();
}

}  // namespace vitrine::render::gl
