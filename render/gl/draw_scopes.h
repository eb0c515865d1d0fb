#pragma once

#include "render/gl/object.h"

#include <epoxy/gl.h>

#include <cstdint>

namespace vitrine::render::gl {

/// Debug group: names all GL commands during its lifetime for debuggers. RAII: it also ends if an exception is thrown.
class DebugGroup {
public:
    explicit DebugGroup(const char* name) { glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name); }
    ~DebugGroup() { glPopDebugGroup(); }
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

/// Counts the samples that pass the depth test, in all draws from the constructor to `end`.
class SamplesQuery {
public:
    SamplesQuery()
    {
        GLuint name = 0;
        glCreateQueries(GL_SAMPLES_PASSED, 1, &name);
        query_ = QueryName(name);
        glBeginQuery(GL_SAMPLES_PASSED, name);
    }
    static void end() { glEndQuery(GL_SAMPLES_PASSED); }
    /// Returns the count; waits for the draws to finish.
    [[nodiscard]] std::int64_t result() const
    {
        GLint64 count = 0;
        glGetQueryObjecti64v(query_.name(), GL_QUERY_RESULT, &count);
        return count;
    }

private:
    QueryName query_;
};

}  // namespace vitrine::render::gl
