#pragma once

#include "render/gl/stored.h"
#include "render/gl/texture.h"
#include "render/plan/frame_plan.h"

#include <map>
#include <string>

namespace vitrine::render::gl {

/// The images that plans name. What the last frame did not declare or use is freed.
class Resources {
public:
    /// Makes the images that the plan's passes use and frees the others. Returns the names of kept images that
    /// are new, and hence hold nothing yet, or gone: what was kept in them must be made again.
    std::vector<std::string> prepare(const FramePlan&, glm::ivec2 frameSize);

    [[nodiscard]] const Texture& image(const std::string& name) const;  ///< std::out_of_range when unknown.
    [[nodiscard]] bool has(const std::string& name) const { return images_.contains(name); }
    [[nodiscard]] std::size_t imageCount() const { return images_.size(); }
    [[nodiscard]] Stored stored() const;
    void abandon();

private:
    struct StoredImage {
        ImageInfo info;
        Texture texture;
    };
    std::map<std::string, StoredImage> images_;
};

}  // namespace vitrine::render::gl
