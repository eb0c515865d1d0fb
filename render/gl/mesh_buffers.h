#pragma once

#include "render/gl/object.h"
#include "render/scene/mesh.h"

#include <cstdint>

namespace vitrine::render::gl {

/// Vertex and index buffers of a mesh on the GPU.
class MeshBuffers {
public:
    explicit MeshBuffers(const Mesh&);

    void draw(int instances) const;
    [[nodiscard]] std::int64_t bytes() const { return bytes_; }
    void abandon();

private:
    BufferName vertices_, indices_, colors_;
    VertexArrayName array_;
    GLsizei indexCount_ = 0;
    std::int64_t bytes_ = 0;
};

}  // namespace vitrine::render::gl
