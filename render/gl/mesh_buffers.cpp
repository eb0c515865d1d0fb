#include "render/gl/mesh_buffers.h"

#include <cstddef>

namespace vitrine::render::gl {
namespace {

constexpr GLuint colorLocation = 5;

BufferName store(const void* data, std::size_t bytes)
{
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(bytes), data, 0);
    return BufferName(name);
}

void attribute(GLuint array, GLuint location, GLint components, std::size_t offset, GLuint binding = 0)
{
    glEnableVertexArrayAttrib(array, location);
    glVertexArrayAttribFormat(array, location, components, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(array, location, binding);
}

}  // namespace

MeshBuffers::MeshBuffers(const Mesh& mesh)
{
    if (mesh.indices.empty() || mesh.vertices.empty()) return;
    vertices_ = store(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
    indices_ = store(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
    indexCount_ = static_cast<GLsizei>(mesh.indices.size());
    bytes_ =
        static_cast<std::int64_t>(mesh.vertices.size() * sizeof(Vertex) + mesh.indices.size() * sizeof(std::uint32_t));
    GLuint array = 0;
    glCreateVertexArrays(1, &array);
    array_ = VertexArrayName(array);
    glVertexArrayVertexBuffer(array, 0, vertices_.name(), 0, sizeof(Vertex));
    glVertexArrayElementBuffer(array, indices_.name());
    attribute(array, 0, 3, offsetof(Vertex, position));
    attribute(array, 1, 3, offsetof(Vertex, normal));
    attribute(array, 2, 4, offsetof(Vertex, tangent));
    attribute(array, 3, 2, offsetof(Vertex, uv));
    attribute(array, 4, 2, offsetof(Vertex, extra));
    if (mesh.colors.size() != mesh.vertices.size()) return;
    const std::size_t colorBytes = mesh.colors.size() * sizeof(glm::vec4);
    colors_ = store(mesh.colors.data(), colorBytes);
    bytes_ += static_cast<std::int64_t>(colorBytes);
    glVertexArrayVertexBuffer(array, 1, colors_.name(), 0, sizeof(glm::vec4));
    attribute(array, colorLocation, 4, 0, 1);
}

void MeshBuffers::draw(int instances) const
{
    if (indexCount_ == 0 || instances < 1) return;
    glBindVertexArray(array_.name());
    // Vertex color for meshes without colors. It is state of the context, not of the vertex array.
    glVertexAttrib4f(colorLocation, 1, 1, 1, 1);
    glDrawElementsInstanced(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr, instances);
}

void MeshBuffers::abandon()
{
    vertices_.abandon();
    colors_.abandon();
    indices_.abandon();
    array_.abandon();
}

}  // namespace vitrine::render::gl
