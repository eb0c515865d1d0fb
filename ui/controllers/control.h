#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace vitrine::ui {

/// Control of a controller: a fader, knob, key or button.
struct Control {
    enum class Kind : std::uint8_t { osc, controlChange, note, pitchBend };

    Kind kind = Kind::osc;
    int channel = 1;      ///< MIDI channel, 1 to 16. For OSC: which number of the message, from 1.
    int number = 0;       ///< MIDI controller or key, 0 to 127.
    std::string address;  ///< OSC address, such as "/fader/3".

    bool operator==(const Control&) const = default;
    bool operator<(const Control& other) const
    {
        return std::tie(kind, channel, number, address) <
               std::tie(other.kind, other.channel, other.number, other.address);
    }
};

/// Longest OSC address that is accepted, in bytes.
constexpr std::size_t longestOscAddress = 120;
/// Most numbers of one OSC message that are read, each as a control of its own.
constexpr std::size_t mostOscNumbers = 16;

/// Position of a control, as a message reports it.
struct ControlMove {
    Control control;
    double position = 0;  ///< 0 to 1.
    bool alone = true;    ///< The message moves no other control.
};

/// Message of a controller, as a driver delivers it: either an OSC message or the bytes of a MIDI message.
struct ControlMessage {
    std::string address;          ///< Address of an OSC message; empty for MIDI.
    std::vector<double> numbers;  ///< Numeric arguments of the OSC message, in their order; true is 1.
    std::vector<unsigned char> bytes;
};

/// Decodes a message. OSC: each number is a control of its own, clamped to 0 to 1. MIDI: control changes (0 to 119),
/// pitch bend, and keys, which are 1 while they are held. All other messages, and damaged ones, give nothing.
[[nodiscard]] std::vector<ControlMove> decode(const ControlMessage&);

/// Returns the text that stands for a control in the preferences: "cc 1 21", "note 1 60", "bend 1", "osc 1 /fader/3".
[[nodiscard]] std::string controlText(const Control&);
/// Parses such a text; nullopt if it is invalid.
[[nodiscard]] std::optional<Control> controlFrom(std::string_view text);

}  // namespace vitrine::ui
