#include "render/image/video_codec.h"

#include "render/files/module.h"

namespace vitrine::render {

namespace {

/// A function of its own: clang 14 ends the life of temporaries of a local static's initializer before their
/// destructors run, which its address sanitizer reports.
VideoCodec* openVideo()
{
    return static_cast<VideoCodec*>(openModule(
        {"libvitrine_video.so", VITRINE_VIDEO_BUILT, "vitrineVideo", message("writes videos"),
         message("FFmpeg's libraries")},
        [](void* symbol) -> void* { return reinterpret_cast<decltype(&vitrineVideo)>(symbol)(vitrineVideoVersion); }));
}

}  // namespace

VideoCodec& videoCodec()
{
    static VideoCodec* const codec = openVideo();  // If this throws, the next call tries again.
    return *codec;
}

}  // namespace vitrine::render
