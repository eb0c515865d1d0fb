#include "render/gl/context.h"

#include "render/failure.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace vitrine::render::gl {
namespace {

bool contains(const std::string& text, const char* part)
{
    return text.find(part) != std::string::npos;
}

std::string glString(GLenum name)
{
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

EGLDisplay deviceDisplay(EGLDeviceEXT device)
{
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
}

/// Returns the EGL displays to try, best first: hardware devices, surfaceless Mesa, software devices.
std::vector<EGLDisplay> candidateDisplays()
{
    std::vector<EGLDisplay> displays;
    std::vector<EGLDisplay> software;
    const char* clientText = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const std::string client = clientText ? clientText : "";
    if (contains(client, "EGL_EXT_device_enumeration") && contains(client, "EGL_EXT_platform_device")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count)) {
            for (EGLint i = 0; i < count; ++i) {
                const char* text = eglQueryDeviceStringEXT(devices[static_cast<std::size_t>(i)], EGL_EXTENSIONS);
                const bool soft = text && std::strstr(text, "EGL_MESA_device_software");
                (soft ? software : displays).push_back(deviceDisplay(devices[static_cast<std::size_t>(i)]));
            }
        }
    }
    if (contains(client, "EGL_MESA_platform_surfaceless"))
        displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    displays.insert(displays.end(), software.begin(), software.end());
    return displays;
}

EGLContext makeContext(EGLDisplay display, bool debug, EGLContext sharedWith = EGL_NO_CONTEXT)
{
    if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1) config = EGL_NO_CONFIG_KHR;
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 debug ? EGL_TRUE : EGL_FALSE,
                                 EGL_NONE};
    const EGLContext context = eglCreateContext(display, config, sharedWith, attributes);
    if (context == EGL_NO_CONTEXT || sharedWith != EGL_NO_CONTEXT) return context;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return context;
    eglDestroyContext(display, context);
    return EGL_NO_CONTEXT;
}

/// Returns what the display offers if no version is requested; used only for the error message.
ContextInfo anyContextInfo(EGLDisplay display)
{
    ContextInfo info;
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
    if (context == EGL_NO_CONTEXT) return info;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) info = currentContextInfo();
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    return info;
}

}  // namespace

struct HeadlessContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
};

ContextInfo currentContextInfo()
{
    ContextInfo info;
    info.version = glString(GL_VERSION);
    if (info.version.empty()) return info;
    info.vendor = glString(GL_VENDOR);
    info.renderer = glString(GL_RENDERER);
    info.shadingLanguage = glString(GL_SHADING_LANGUAGE_VERSION);
    glGetIntegerv(GL_MAJOR_VERSION, &info.major);
    glGetIntegerv(GL_MINOR_VERSION, &info.minor);
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    info.core = (profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0;
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
        info.software = info.software || contains(info.renderer, name);
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &info.maxTextureSize);
    glGetIntegerv(GL_MAX_SAMPLES, &info.maxSamples);
    glGetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &info.maxUniformBlockSize);
    return info;
}

Message whyUnusable(const ContextInfo& info)
{
    if (info.version.empty())
        return message("No OpenGL was found; OpenGL 4.5 is needed: install a graphics driver, or Mesa's software one "
                       "(libgl1-mesa-dri).");
    if (info.major * 10 + info.minor >= 45) return {};
    return message("OpenGL {1} found ({2}), OpenGL 4.5 needed: update the graphics driver, or set "
                   "LIBGL_ALWAYS_SOFTWARE=1 to draw with Mesa's software renderer.",
                   std::to_string(info.major) + '.' + std::to_string(info.minor), info.renderer);
}

HeadlessContext::HeadlessContext(bool debug) : state_(std::make_unique<State>())
{
    Message found;
    for (const EGLDisplay display : candidateDisplays()) {
        EGLint major = 0;
        EGLint minor = 0;
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor)) continue;
        const EGLContext context = makeContext(display, debug);
        if (context == EGL_NO_CONTEXT) {
            const ContextInfo offered = anyContextInfo(display);
            if (found.empty() && !offered.version.empty()) found = whyUnusable(offered);
            continue;
        }
        info_ = currentContextInfo();
        found = whyUnusable(info_);
        if (found.empty()) {
            state_->display = display;
            state_->context = context;
            return;
        }
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }
    throw Failure(ErrorKind::openGl, found.empty() ? whyUnusable({}) : found);
}

namespace {

class SharedEglContext final : public SharedContext {
public:
    SharedEglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
    ~SharedEglContext() override { eglDestroyContext(display_, context_); }
    SharedEglContext(const SharedEglContext&) = delete;
    SharedEglContext& operator=(const SharedEglContext&) = delete;

    void makeCurrent() override
    {
        eglBindAPI(EGL_OPENGL_API);  // Each thread starts with OpenGL ES.
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
    }
    void release() override { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

private:
    EGLDisplay display_;
    EGLContext context_;
};

}  // namespace

std::shared_ptr<SharedContext> HeadlessContext::shared() const
{
    const EGLContext context = makeContext(state_->display, false, state_->context);
    if (context == EGL_NO_CONTEXT)
        throw Failure(ErrorKind::openGl,
                      message("The graphics driver makes no second context that shares with the first."));
    return std::make_shared<SharedEglContext>(state_->display, context);
}

HeadlessContext::~HeadlessContext()
{
    eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(state_->display, state_->context);
}

DebugLog::DebugLog() : errors_(std::make_unique<std::string>())
{
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(
        [](GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* message, const void* user) {
            if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
            auto& errors = *static_cast<std::string*>(const_cast<void*>(user));
            errors.append(message, static_cast<std::size_t>(std::max(length, 0))) += '\n';
        },
        errors_.get());
}

DebugLog::~DebugLog()
{
    glDebugMessageCallback(nullptr, nullptr);
    glDisable(GL_DEBUG_OUTPUT);
}

}  // namespace vitrine::render::gl
