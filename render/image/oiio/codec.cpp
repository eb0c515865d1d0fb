#include "render/image/oiio/guarded.h"
#include "render/image/oiio/pdf_reader.h"
#include "render/image/oiio/pdf_rows.h"
#include "render/image/oiio/read.h"
#include "render/image/oiio/row_reader.h"
#include "render/image/oiio/rows.h"
#include "render/image/oiio/write.h"

#include <OpenImageIO/imageio.h>

#include <dlfcn.h>

namespace vitrine::render {
namespace {

/// Silences libtiff, which writes errors to standard error besides returning them; with OpenImageIO 2.5 some of these
/// lines get through. libtiff is already loaded here; if it is not, nothing is done.
void silenceLibtiff()
{
    void* libtiff = ::dlopen("libtiff.so.6", RTLD_LAZY | RTLD_NOLOAD);
    if (!libtiff) return;
    using SetHandler = void* (*)(void*);
    for (const char* name : {"TIFFSetErrorHandler", "TIFFSetWarningHandler"})
        if (void* symbol = ::dlsym(libtiff, name)) reinterpret_cast<SetHandler>(symbol)(nullptr);
}

class Codec final : public OiioCodec {
public:
    Codec()
    {
        OIIO::attribute("try_all_readers", 0);  // Otherwise a .png may reach the DPX reader.
        OIIO::attribute("limits:imagesize_MB", 2048);
        OIIO::attribute("limits:channels", 1024);  // For the file; `ImageLimits` limits the channels that are read.
        OIIO::attribute("openexr:core", 0);        // The core reader raises SIGFPE on damaged files in 2.4.7.
        OIIO::attribute("plugin_searchpath", "");
        silenceLibtiff();
    }

    std::string decode(std::string_view bytes, ImageFormat format, const DecodeRequest& request,
                       StoredPicture& out) noexcept override
    {
        return guarded([&] { return decodeWithOiio(bytes, format, request, out); });
    }
    std::string write(const StoredPicture& picture, const OiioTarget& target) noexcept override
    {
        return guarded([&] { return writeWithOiio(picture, target); });
    }
    std::string openRows(const OiioRowTarget& target, std::unique_ptr<OiioRows>& out) noexcept override
    {
        return guarded([&] { return openRowsWithOiio(target, out); });
    }
    std::string openPdfRows(const OiioRowTarget& target, std::unique_ptr<OiioRows>& out) noexcept override
    {
        return guarded([&] { return openPdfRowsWithQpdf(target, out); });
    }
    std::string checkRows(const OiioRowTarget& target, const std::vector<WrittenRow>& rows) noexcept override
    {
        return guarded([&] { return checkRowsWithOiio(target, rows); });
    }
    std::string readProfile(std::string_view bytes, ImageFormat format, std::string& out) noexcept override
    {
        return guarded([&] { return readProfileWithOiio(bytes, format, out); });
    }
    std::string readText(std::string_view bytes, ImageFormat format, const std::string& key,
                         std::string& out) noexcept override
    {
        return guarded([&] { return readTextWithOiio(bytes, format, key, out); });
    }
    std::string openRowReader(const std::string& path, std::unique_ptr<OiioRowReader>& out) noexcept override
    {
        return guarded([&] { return openRowReaderWithOiio(path, out); });
    }
    std::string openPdfReader(const std::string& path, std::unique_ptr<OiioRowReader>& out) noexcept override
    {
        return guarded([&] { return openPdfReaderWithQpdf(path, out); });
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
