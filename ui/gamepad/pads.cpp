#include "ui/gamepad/pads.h"

#include "render/failure.h"
#include "render/files/module.h"

#include <QDir>
#include <QFile>

namespace vitrine::ui {
namespace {

/// Returns whether key capabilities, as given in /sys, contain buttons of a joystick or a gamepad.
bool hasPadButtons(const QByteArray& capabilities)
{
    // The capabilities are hexadecimal words of 64 bits, the lowest last. The buttons are 0x120 to 0x13f of
    // linux/input-event-codes.h.
    const QList<QByteArray> words = capabilities.simplified().split(' ');
    constexpr qsizetype word = 0x120 / 64;
    if (words.size() <= word) return false;
    const qulonglong bits = words[words.size() - 1 - word].toULongLong(nullptr, 16);
    return (bits >> (0x120 % 64)) & 0xffffffffULL;
}

}  // namespace

bool padIsPlugged()
{
    const QDir inputs(QStringLiteral("/sys/class/input"));
    for (const QString& name : inputs.entryList({QStringLiteral("event*")}, QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile file(inputs.filePath(name + QStringLiteral("/device/capabilities/key")));
        if (file.open(QIODevice::ReadOnly) && hasPadButtons(file.readAll())) return true;
    }
    return false;
}

/// A function of its own for the reason that render/image/video_codec.cpp states.
static void* openGamepadModule()
{
    return render::openModule({"libvitrine_gamepad.so", VITRINE_GAMEPAD_BUILT, "vitrinePads", message("reads gamepads"),
                               Message::verbatim("SDL")},
                              [](void* found) { return found; });
}

std::unique_ptr<Pads> openPads()
{
    // A static initialization that throws is tried again by the next call.
    static void* const symbol = openGamepadModule();
    std::unique_ptr<Pads> pads(reinterpret_cast<decltype(&vitrinePads)>(symbol)(vitrinePadsVersion));
    if (!pads)
        throw Failure(ErrorKind::file,
                      "libvitrine_gamepad.so belongs to another version of Vitrine; build both together.");
    return pads;
}

}  // namespace vitrine::ui
