#include "render/image/oiio/read.h"
#include "render/image/oiio/write.h"

#include <OpenImageIO/imageio.h>

#include <exception>

namespace vitrine::render {
namespace {

/// Calls `work` and turns what it throws into a half sentence.
template <typename Work> std::string guarded(const Work& work) noexcept
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return "memory is full";
    } catch (const std::exception& e) {
        return "OpenImageIO failed (" + std::string(e.what()) + ")";
    } catch (...) {
        return "OpenImageIO failed";
    }
}

class Codec final : public OiioCodec {
public:
    Codec()
    {
        OIIO::attribute("try_all_readers", 0);  // Otherwise a .png may reach the DPX reader.
        OIIO::attribute("limits:imagesize_MB", 2048);
        OIIO::attribute("limits:channels", 16);
        OIIO::attribute("openexr:core", 0);  // SIGFPE on damaged files in 2.4.7.
        OIIO::attribute("plugin_searchpath", "");
    }

    std::string decode(std::string_view bytes, ImageFormat format, const ImageLimits& limits,
                       const std::function<bool()>& cancelled, StoredPicture& out) noexcept override
    {
        return guarded([&] { return decodeWithOiio(bytes, format, limits, cancelled, out); });
    }
    std::string write(const StoredPicture& picture, const OiioTarget& target) noexcept override
    {
        return guarded([&] { return writeWithOiio(picture, target); });
    }
    std::string readText(std::string_view bytes, ImageFormat format, const std::string& key,
                         std::string& out) noexcept override
    {
        return guarded([&] { return readTextWithOiio(bytes, format, key, out); });
    }
    const char* libraryVersion() const noexcept override { return OIIO_VERSION_STRING; }
};

}  // namespace
}  // namespace vitrine::render

extern "C" __attribute__((visibility("default"))) vitrine::render::OiioCodec* vitrineOiio(int version)
{
    if (version != vitrineOiioVersion) return nullptr;
    try {
        static vitrine::render::Codec codec;
        return &codec;
    } catch (...) {
        return nullptr;
    }
}
