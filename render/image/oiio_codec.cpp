#include "render/image/oiio_codec.h"

#include "render/files/module.h"

#include <atomic>

namespace vitrine::render {
namespace {

std::atomic<bool> isOpen{false};

OiioCodec* openOiio()
{
    return static_cast<OiioCodec*>(openModule(
        {"libvitrine_oiio.so", VITRINE_OIIO_BUILT, "vitrineOiio", message("reads and writes pictures"),
         Message::verbatim("OpenImageIO")},
        [](void* symbol) -> void* { return reinterpret_cast<decltype(&vitrineOiio)>(symbol)(vitrineOiioVersion); }));
}

}  // namespace

OiioCodec& oiioCodec()
{
    static OiioCodec* const codec = openOiio();  // If this throws, the next call tries again.
    isOpen = true;
    return *codec;
}

bool oiioCodecIsOpen()
{
    return isOpen;
}

}  // namespace vitrine::render
