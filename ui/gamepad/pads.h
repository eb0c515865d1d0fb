#pragma once

#include <array>
#include <cstddef>
#include <memory>

namespace vitrine::ui {

/// Buttons, named by their position on the usual gamepad, whatever their labels: `a` is the lowest of the four.
enum class PadButton { a, b, x, y, leftShoulder, rightShoulder, leftStick, rightStick, start, up, down, left, right };
constexpr std::size_t padButtons = 13;

/// State of a gamepad at one moment. Without a gamepad nothing is held.
struct PadState {
    bool connected = false;
    /// Stick positions from -1 to 1, positive to the right and downward.
    double leftX = 0, leftY = 0, rightX = 0, rightY = 0;
    double leftTrigger = 0, rightTrigger = 0;  ///< 0 to 1.
    std::array<bool, padButtons> buttons{};

    [[nodiscard]] bool held(PadButton button) const { return buttons[static_cast<std::size_t>(button)]; }
};

/// Gamepads of the machine. The one that was connected first is read.
class Pads {
public:
    virtual ~Pads() = default;
    /// Reads the state. Also notices gamepads that were connected or removed.
    [[nodiscard]] virtual PadState read() = 0;
};

/// Returns whether a device like a gamepad or joystick is connected. Reads files of /sys and opens no device.
[[nodiscard]] bool padIsPlugged();

/// Opens the module `vitrine_gamepad`, the only one that uses SDL. Throws Failure if it cannot be opened.
[[nodiscard]] std::unique_ptr<Pads> openPads();

/// Entry point of the module; the caller owns the result. Returns null if `version` is not `vitrinePadsVersion`. Throws
/// Failure if SDL does not start.
constexpr int vitrinePadsVersion = 1;
extern "C" vitrine::ui::Pads* vitrinePads(int version);

}  // namespace vitrine::ui
