#pragma once

#include <epoxy/gl.h>

#include <atomic>
#include <utility>

namespace vitrine::render::gl {

/// RAII owner of one GL object name. Movable, not copyable; deletes the object in the destructor.
template <auto Delete> class Object {
public:
    Object() = default;
    explicit Object(GLuint name) : name_(name) { live_ += name_ != 0 ? 1 : 0; }
    ~Object() { reset(); }
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Object& operator=(Object&& other) noexcept
    {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0);
        }
        return *this;
    }
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;

    [[nodiscard]] GLuint name() const { return name_; }
    [[nodiscard]] explicit operator bool() const { return name_ != 0; }
    /// Forgets the name without deleting the object, because the context is lost.
    void abandon()
    {
        live_ -= name_ != 0 ? 1 : 0;
        name_ = 0;
    }
    /// Number of objects of this kind that the program owns.
    [[nodiscard]] static int live() { return live_; }

private:
    void reset()
    {
        if (name_ != 0) Delete(name_);
        abandon();
    }

    static inline std::atomic<int> live_{0};

    GLuint name_ = 0;
};

inline void deleteTexture(GLuint name)
{
    glDeleteTextures(1, &name);
}
inline void deleteBuffer(GLuint name)
{
    glDeleteBuffers(1, &name);
}
inline void deleteVertexArray(GLuint name)
{
    glDeleteVertexArrays(1, &name);
}
inline void deleteFramebuffer(GLuint name)
{
    glDeleteFramebuffers(1, &name);
}
inline void deleteQuery(GLuint name)
{
    glDeleteQueries(1, &name);
}
inline void deleteProgram(GLuint name)
{
    glDeleteProgram(name);
}
inline void deleteShader(GLuint name)
{
    glDeleteShader(name);
}

using TextureName = Object<deleteTexture>;
using BufferName = Object<deleteBuffer>;
using VertexArrayName = Object<deleteVertexArray>;
using FramebufferName = Object<deleteFramebuffer>;
using QueryName = Object<deleteQuery>;
using ProgramName = Object<deleteProgram>;
using ShaderName = Object<deleteShader>;

}  // namespace vitrine::render::gl
