#include "render/scene/draco_codec.h"

#include "render/files/module.h"

namespace vitrine::render {
namespace {

/// A function of its own for the reason that `openVideo` has.
DracoCodec* openDraco()
{
    return static_cast<DracoCodec*>(openModule(
        {"libvitrine_draco.so", VITRINE_DRACO_BUILT, "vitrineDraco", message("reads meshes that Draco compressed"),
         message("Draco's library")},
        [](void* symbol) -> void* { return reinterpret_cast<decltype(&vitrineDraco)>(symbol)(vitrineDracoVersion); }));
}

}  // namespace

DracoCodec& dracoCodec()
{
    static DracoCodec* const codec = openDraco();  // If this throws, the next call tries again.
    return *codec;
}

}  // namespace vitrine::render
