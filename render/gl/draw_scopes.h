#pragma once

#include "render/gl/object.h"

#include <epoxy/gl.h>

#include <cstdint>

namespace vitrine::render::gl {

/// Names what is drawn while it lives, for debuggers; closed also when a program does not build.
class DebugGroup {
public:
    explicit DebugGroup(const char* name) { glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name); }
    ~DebugGroup() { glPopDebugGroup(); }
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

/// Counts the samples that the draws between its making and `end` let pass.
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
    /// Waits for the draws to finish.
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
