#include "render/image/oiio_codec.h"

#include "render/failure.h"

#include <dlfcn.h>

#include <array>
#include <atomic>
#include <filesystem>

namespace vitrine::render {
namespace {

namespace fs = std::filesystem;

std::atomic<bool> isOpen{false};

OiioCodec* openModule()
{
    const std::string file = "libvitrine_oiio.so";
    std::error_code error;
    const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
    const std::array<fs::path, 4> places = {here / file, here.parent_path() / file,
                                            here.parent_path() / "lib" / "vitrine" / file,
                                            fs::path(VITRINE_OIIO_BUILT)};
    std::string problems;
    for (const fs::path& place : places) {
        if (!fs::exists(place, error)) continue;
        // Never closed: OpenImageIO's threads and caches would outlive their code.
        void* module = ::dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
        void* symbol = module ? ::dlsym(module, "vitrineOiio") : nullptr;
        if (symbol) {
            if (OiioCodec* codec = reinterpret_cast<decltype(&vitrineOiio)>(symbol)(vitrineOiioVersion)) return codec;
            problems += place.string() + " belongs to another version; ";
        } else if (const char* why = ::dlerror()) {
            problems += std::string(why) + "; ";
        }
    }
    throw Failure(Blame::file, "Cannot open " + file + ", which reads and writes pictures: " +
                                   (problems.empty() ? "it is not beside the program; " : problems) +
                                   "install OpenImageIO or build Vitrine again.");
}

}  // namespace

OiioCodec& oiioCodec()
{
    static OiioCodec* const codec = openModule();  // Tried again when it throws.
    isOpen = true;
    return *codec;
}

bool oiioCodecIsOpen()
{
    return isOpen;
}

}  // namespace vitrine::render
