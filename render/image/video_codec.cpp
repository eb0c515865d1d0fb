#include "render/image/video_codec.h"

#include "render/files/module.h"

namespace vitrine::render {

VideoCodec& videoCodec()
{
    // If this throws, the next call tries again.
    static VideoCodec* const codec = static_cast<VideoCodec*>(openModule(
        {"libvitrine_video.so", VITRINE_VIDEO_BUILT, "vitrineVideo", message("writes videos"),
         message("FFmpeg's libraries")},
        [](void* symbol) -> void* { return reinterpret_cast<decltype(&vitrineVideo)>(symbol)(vitrineVideoVersion); }));
    return *codec;
}

}  // namespace vitrine::render
