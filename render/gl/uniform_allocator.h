#pragma once

#include "render/gl/object.h"
#include "render/plan/frame_plan.h"

namespace vitrine::render::gl {

/// All std140 blocks of one frame in one buffer: collected first, uploaded once, bound by range.
class UniformAllocator {
public:
    struct Range {
        GLintptr offset = 0;
        GLsizeiptr size = 0;
    };

    UniformAllocator();
    void clear() { bytes_.clear(); }
    [[nodiscard]] Range add(const Bytes& block);
    void upload();
    void bind(int binding, Range) const;
    void abandon() { buffer_.abandon(); }

private:
    BufferName buffer_;
    std::size_t alignment_ = 256;
    Bytes bytes_;
};

}  // namespace vitrine::render::gl
