#include "ui/controllers/control_input.h"

#include "render/failure.h"
#include "render/files/module.h"

namespace vitrine::ui {

/// A function of its own for the reason that render/image/video_codec.cpp states.
static void* openControllersModule()
{
    return render::openModule({"libvitrine_controllers.so", VITRINE_CONTROLLERS_BUILT, "vitrineControllers",
                               message("reads OSC and MIDI controllers"), Message::verbatim("liblo, RtMidi")},
                              [](void* found) { return found; });
}

std::unique_ptr<ControlInput> openControlInput(ControlInputKind kind, int port)
{
    // A static initialization that throws is tried again by the next call.
    static void* const symbol = openControllersModule();
    std::unique_ptr<ControlInput> input(
        reinterpret_cast<decltype(&vitrineControllers)>(symbol)(vitrineControllersVersion, kind, port));
    if (!input)
        throw Failure(ErrorKind::file,
                      "libvitrine_controllers.so belongs to another version of Vitrine; build both together.");
    return input;
}

}  // namespace vitrine::ui
