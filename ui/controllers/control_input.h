#pragma once

#include "ui/controllers/control.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::ui {

/// Source of messages of controllers: a network port for OSC, or the MIDI devices of the machine.
class ControlInput {
public:
    virtual ~ControlInput() = default;
    /// Descriptor that is readable while messages wait.
    [[nodiscard]] virtual int descriptor() const = 0;
    /// Takes the messages that wait, in their order; at most some hundred at once.
    [[nodiscard]] virtual std::vector<ControlMessage> read() = 0;
    /// Opens devices that were plugged in, closes those that were removed, and returns the names of the open ones.
    [[nodiscard]] virtual std::vector<std::string> devices() = 0;
};

enum class ControlInputKind : std::uint8_t { osc, midi };

/// Opens the module `vitrine_controllers`, the only one that uses liblo and RtMidi, and an input of it. `port`: UDP
/// port for OSC. Throws Failure if the module, the port or the MIDI system cannot be opened.
[[nodiscard]] std::unique_ptr<ControlInput> openControlInput(ControlInputKind, int port);

/// Entry point of the module; the caller owns the result. Returns null if `version` is not `vitrineControllersVersion`.
constexpr int vitrineControllersVersion = 1;
extern "C" vitrine::ui::ControlInput* vitrineControllers(int version, vitrine::ui::ControlInputKind, int port);

}  // namespace vitrine::ui
