#pragma once

#include "render/gl/mesh_buffers.h"
#include "render/gl/texture.h"
#include "render/plan/frame_plan.h"

#include <map>
#include <memory>
#include <string>

namespace vitrine::render::gl {

/// The GL side of what plans name: images by name, meshes and pictures by address. What the last frame
/// did not declare or use is freed.
class Resources {
public:
    /// Makes the images that the plan's passes use and frees the others. Returns the names of kept images that
    /// are new, and hence hold nothing yet, or gone: what was kept in them must be made again.
    std::vector<std::string> prepare(const FramePlan&, glm::ivec2 frameSize);

    [[nodiscard]] const Texture& image(const std::string& name) const;  ///< std::out_of_range when unknown.
    [[nodiscard]] bool has(const std::string& name) const { return images_.contains(name); }
    [[nodiscard]] const Texture& texture(const std::shared_ptr<const render::Texture>&);
    [[nodiscard]] const MeshBuffers& mesh(const std::shared_ptr<const Mesh>&);
    /// Frees GL copies of meshes and pictures that nobody else holds any more.
    void sweep();
    [[nodiscard]] std::size_t imageCount() const { return images_.size(); }
    void abandon();

private:
    struct StoredImage {
        ImageInfo info;
        Texture texture;
    };
    template <typename T, typename Buffers> struct Uploaded {
        std::weak_ptr<const T> source;
        Buffers buffers;
    };
    std::map<std::string, StoredImage> images_;
    std::map<const render::Texture*, Uploaded<render::Texture, Texture>> textures_;
    std::map<const Mesh*, Uploaded<Mesh, MeshBuffers>> meshes_;
};

}  // namespace vitrine::render::gl
