#pragma once

namespace vitrine::render::gl {

/// A context that shares its objects with another and can be current on a thread of its own; made by whoever owns the
/// other one.
class SharedContext {
public:
    virtual ~SharedContext() = default;
    virtual void makeCurrent() = 0;  ///< On the calling thread.
    virtual void release() = 0;      ///< From the calling thread.
};

}  // namespace vitrine::render::gl
