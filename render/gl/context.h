#pragma once

#include "render/gl/shared_context.h"
#include "render/text/message.h"

#include <memory>
#include <string>

namespace vitrine::render::gl {

/// Version, vendor and limits of an OpenGL context.
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

/// Describes the current context of this thread; version 0.0 if there is none.
[[nodiscard]] ContextInfo currentContextInfo();

/// Returns one sentence that says why the context cannot be used; empty if it can.
[[nodiscard]] Message whyUnusable(const ContextInfo&);

/// An OpenGL 4.5 core context without window or display: EGL on a device (hardware first), else Mesa's surfaceless
/// platform. It is current on the thread that created it. Throws Failure (ErrorKind::openGl).
class HeadlessContext {
public:
    explicit HeadlessContext(bool debug = false);
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    [[nodiscard]] const ContextInfo& info() const { return info_; }
    /// Creates another context that shares the objects of this one; not current on any thread. Throws Failure
    /// (ErrorKind::openGl).
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

    /// Messages so far of type error or of high severity, one per line.
    [[nodiscard]] const std::string& errors() const { return *errors_; }

private:
    std::unique_ptr<std::string> errors_;
};

}  // namespace vitrine::render::gl
