#pragma once

#include <array>
#include <cstddef>
#include <memory>

namespace vitrine::ui {

/// By where they are on the usual kind of gamepad, whatever is written on them: `a` is the lowest of the four.
enum class PadButton { a, b, x, y, leftShoulder, rightShoulder, leftStick, rightStick, start, up, down, left, right };
constexpr std::size_t padButtons = 13;

/// What a gamepad says at a moment. One that is not there says that nothing is held.
struct PadState {
    bool connected = false;
    /// -1 to 1, to the right and downward.
    double leftX = 0, leftY = 0, rightX = 0, rightY = 0;
    double leftTrigger = 0, rightTrigger = 0;  ///< 0 to 1.
    std::array<bool, padButtons> buttons{};

    [[nodiscard]] bool held(PadButton button) const { return buttons[static_cast<std::size_t>(button)]; }
};

/// The gamepads of the machine, of which the one that was connected first counts.
class Pads {
public:
    virtual ~Pads() = default;
    /// Also notices what was connected and taken away since.
    [[nodiscard]] virtual PadState read() = 0;
};

/// Whether the system has something like a gamepad or a joystick, connected: files of /sys are looked at, nothing is
/// opened.
[[nodiscard]] bool padIsPlugged();

/// Opens the module `vitrine_gamepad`, which is all that uses SDL. Throws Failure when it cannot be opened.
[[nodiscard]] std::unique_ptr<Pads> openPads();

/// The one symbol of the module; the caller owns what it gives. `version` must be `vitrinePadsVersion`; otherwise the
/// answer is null. Throws Failure where SDL does not start.
constexpr int vitrinePadsVersion = 1;
extern "C" vitrine::ui::Pads* vitrinePads(int version);

}  // namespace vitrine::ui
