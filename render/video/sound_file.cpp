#include "render/video/sound_file.h"

#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/image/video_codec.h"

namespace vitrine::render {

Sound readSound(const std::filesystem::path& path)
{
    // Says what is wrong with files that cannot be opened, as for all others.
    static_cast<void>(readFile(path, std::size_t{1} << 29U));
    Sound sound;
    if (const std::string why = videoCodec().readSound(path.string(), sound); !why.empty())
        throw Failure(ErrorKind::file, message("Cannot read {1}: {2}; choose a WAV or FLAC file.", path, why));
    return sound;
}

}  // namespace vitrine::render
