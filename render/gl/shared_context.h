#pragma once

namespace vitrine::render::gl {

/// OpenGL context that shares its objects with another context and can be current on another thread. The owner of the
/// other context creates it.
class SharedContext {
public:
    virtual ~SharedContext() = default;
    virtual void makeCurrent() = 0;  ///< Makes it current on the calling thread.
    virtual void release() = 0;      ///< Releases it from the calling thread.
};

}  // namespace vitrine::render::gl
