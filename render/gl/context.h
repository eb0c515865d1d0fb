#pragma once

#include "render/gl/shared_context.h"

#include <memory>
#include <string>

namespace vitrine::render::gl {

/// What the current context is and can do.
struct ContextInfo {
    std::string vendor, renderer, version, shadingLanguage;
    int major = 0;
    int minor = 0;
    bool core = false;
    bool software = false;  ///< llvmpipe, softpipe, lavapipe below zink, SwiftShader.
    int maxTextureSize = 0;
    int maxSamples = 0;
    int maxUniformBlockSize = 0;
};

/// Of the context that is current; version 0.0 when there is none.
[[nodiscard]] ContextInfo currentContextInfo();

/// One sentence when the context cannot draw this program's pictures; empty when it can.
[[nodiscard]] std::string whyUnusable(const ContextInfo&);

/// An OpenGL 4.5 core context without window or display: EGL on a device, hardware first, else Mesa's
/// surfaceless platform. Current on the thread that made it. Throws Failure (Blame::openGl).
class HeadlessContext {
public:
    explicit HeadlessContext(bool debug = false);
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    [[nodiscard]] const ContextInfo& info() const { return info_; }
    /// Another context with the same objects, current nowhere. Throws Failure (Blame::openGl).
    [[nodiscard]] std::shared_ptr<SharedContext> shared() const;

private:
    struct State;
    std::unique_ptr<State> state_;
    ContextInfo info_;
};

/// Collects KHR_debug messages of the current context; tests fail on those of type error or high severity.
class DebugLog {
public:
    DebugLog();
    ~DebugLog();
    DebugLog(const DebugLog&) = delete;
    DebugLog& operator=(const DebugLog&) = delete;

    /// Errors and messages of high severity so far, a line each.
    [[nodiscard]] const std::string& errors() const { return *errors_; }

private:
    std::unique_ptr<std::string> errors_;
};

}  // namespace vitrine::render::gl
