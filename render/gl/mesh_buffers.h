#pragma once

#include "render/gl/object.h"
#include "render/scene/mesh.h"

namespace vitrine::render::gl {

/// A mesh on the graphics processor.
class MeshBuffers {
public:
    explicit MeshBuffers(const Mesh&);

    void draw(int instances) const;
    [[nodiscard]] GLsizei indexCount() const { return indexCount_; }
    void abandon();

private:
    BufferName vertices_, indices_;
    VertexArrayName array_;
    GLsizei indexCount_ = 0;
};

}  // namespace vitrine::render::gl
