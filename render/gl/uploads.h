#pragma once

#include "render/gl/mesh_buffers.h"
#include "render/gl/stored.h"
#include "render/gl/texture.h"
#include "render/plan/frame_plan.h"

#include <map>
#include <memory>
#include <vector>

namespace vitrine::render::gl {

/// Constant bytes on the GPU.
struct UploadedBytes {
    explicit UploadedBytes(const Bytes&);

    BufferName buffer;
    TextureName texels;  ///< The buffer as a buffer texture, once it was asked for.
    std::int64_t bytes = 0;
};

/// GPU copies of meshes, textures and constant buffers, by address. Created on first use, freed when the original is
/// deleted.
class Uploads {
public:
    [[nodiscard]] const Texture& texture(const std::shared_ptr<const render::Texture>&);
    [[nodiscard]] const MeshBuffers& mesh(const std::shared_ptr<const Mesh>&);
    [[nodiscard]] const UploadedBytes& bytes(const std::shared_ptr<const Bytes>&);
    /// Returns a buffer texture of the bytes, always of the same type for the same bytes. Throws Failure if they are
    /// more than the driver's buffer textures hold.
    [[nodiscard]] GLuint texels(const std::shared_ptr<const Bytes>&, Texels);
    /// Frees the copies whose originals were deleted.
    void sweep();
    [[nodiscard]] std::vector<Stored> stored() const;
    void abandon();

private:
    template <typename T, typename Buffers> struct Uploaded {
        std::weak_ptr<const T> source;
        Buffers buffers;
    };
    std::map<const render::Texture*, Uploaded<render::Texture, Texture>> textures_;
    std::map<const Mesh*, Uploaded<Mesh, MeshBuffers>> meshes_;
    std::map<const Bytes*, Uploaded<Bytes, UploadedBytes>> bytes_;
};

}  // namespace vitrine::render::gl
