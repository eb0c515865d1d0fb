#pragma once

#include "exhibits/your_shader/guest_blocks.h"
#include "render/image/texture.h"
#include "render/text/message.h"

#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

// Keys that a visitor's shader reads. They are written in a parameter with their times, so that the keyboard at a time
// is a function of the values alone.
namespace vitrine::guest {

/// One press of a key.
struct KeyPress {
    int code = 0;  ///< As in browsers: 65 is A, 32 the blank, 37 to 40 the arrows; 0 to 255.
    double from = 0;
    double to = std::numeric_limits<double>::infinity();  ///< Seconds; infinity while the key is held.
};

/// Presses that a text names, "65@1-2.5 32@3", and the reason why the rest is left out; empty if there is none.
struct KeyPresses {
    std::vector<KeyPress> presses;
    Message problem;
};

/// Reads the text. The first word of another form ends it.
[[nodiscard]] KeyPresses readKeys(std::string_view text);

/// Returns the text with a key that is pressed, or let go, at this time, in seconds. A key that is held is not pressed
/// again. After `mostPresses`, the oldest ones are left out in pairs, which keeps what is switched on.
[[nodiscard]] std::string withKey(std::string_view text, int code, bool isDown, double time);
inline constexpr std::size_t mostPresses = 256;

/// Returns the picture of the keyboard in one step: 256 x 3 texels, a column for each code. The lowest row says which
/// keys are held, the next which were pressed in this step, the last which were pressed an odd number of times.
[[nodiscard]] std::shared_ptr<const render::Texture> keyboardPicture(const std::vector<KeyPress>&, const StepTime&);

}  // namespace vitrine::guest
