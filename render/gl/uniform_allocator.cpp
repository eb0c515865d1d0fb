#include "render/gl/uniform_allocator.h"

#include <algorithm>

namespace vitrine::render::gl {

UniformAllocator::UniformAllocator()
{
    GLuint name = 0;
    glCreateBuffers(1, &name);
    buffer_ = BufferName(name);
    GLint alignment = 256;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    alignment_ = static_cast<std::size_t>(std::max(alignment, 16));
}

UniformAllocator::Range UniformAllocator::add(const Bytes& block)
{
    const std::size_t offset = (bytes_.size() + alignment_ - 1) / alignment_ * alignment_;
    // std140 blocks end on a multiple of 16 bytes; a shorter upload would leave the block's tail without storage.
    const std::size_t padded = (block.size() + 15) / 16 * 16;
    bytes_.resize(offset + padded);
    std::copy(block.begin(), block.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(offset));
    return {static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(padded)};
}

void UniformAllocator::upload()
{
    glNamedBufferData(buffer_.name(), static_cast<GLsizeiptr>(bytes_.size()), bytes_.data(), GL_STREAM_DRAW);
}

void UniformAllocator::bind(int binding, Range range) const
{
    if (range.size > 0)
        glBindBufferRange(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding), buffer_.name(), range.offset, range.size);
}

}  // namespace vitrine::render::gl
