#include "ui/controllers/control.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vitrine::ui {
namespace {

constexpr int mostChannels = 16;
constexpr int largestByte = 127;       // Largest byte of MIDI data.
constexpr int firstModeMessage = 120;  // Controllers from here on are channel mode messages (MIDI 1.0).

/// Returns whether the text can be an OSC address: printable ASCII without the characters that OSC 1.0 reserves.
/// QSettings gives @ a meaning of its own.
bool isOscAddress(std::string_view text)
{
    return text.size() >= 2 && text.size() <= longestOscAddress && text.front() == '/' &&
           std::all_of(text.begin(), text.end(), [](char c) {
               return c > ' ' && c < '\x7f' && std::string_view("#*,?[]{}@").find(c) == std::string_view::npos;
           });
}

std::vector<ControlMove> decodeOsc(const ControlMessage& message)
{
    std::vector<ControlMove> moves;
    if (!isOscAddress(message.address)) return moves;
    const std::size_t count = std::min(message.numbers.size(), mostOscNumbers);
    for (std::size_t i = 0; i < count; ++i)
        if (const double number = message.numbers[i]; std::isfinite(number))
            moves.push_back({.control = {Control::Kind::osc, static_cast<int>(i) + 1, 0, message.address},
                             .position = std::clamp(number, 0.0, 1.0),
                             .alone = count == 1});
    return moves;
}

std::vector<ControlMove> decodeMidi(const std::vector<unsigned char>& bytes)
{
    if (bytes.size() != 3 || bytes[1] > largestByte || bytes[2] > largestByte) return {};
    const int channel = bytes[0] % mostChannels + 1, first = bytes[1], second = bytes[2];
    switch (bytes[0] / mostChannels) {
    case 0x8: return {{{Control::Kind::note, channel, first, {}}, 0}};
    case 0x9: return {{{Control::Kind::note, channel, first, {}}, second > 0 ? 1.0 : 0.0}};  // Velocity 0: released.
    case 0xb:
        if (first >= firstModeMessage) return {};
        return {{{Control::Kind::controlChange, channel, first, {}}, static_cast<double>(second) / largestByte}};
    case 0xe: return {{{Control::Kind::pitchBend, channel, 0, {}}, (second * 128 + first) / 16383.0}};
    default: return {};
    }
}

/// Takes the next word of the text, and the space behind it.
std::string_view takeWord(std::string_view& text)
{
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return word;
}

std::optional<int> numberFrom(std::string_view digits, int least, int most)
{
    int number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size() || number < least || number > most) return {};
    return number;
}

}  // namespace

std::vector<ControlMove> decode(const ControlMessage& message)
{
    return message.address.empty() ? decodeMidi(message.bytes) : decodeOsc(message);
}

std::string controlText(const Control& control)
{
    const std::string channel = std::to_string(control.channel);
    switch (control.kind) {
    case Control::Kind::osc: return "osc " + channel + ' ' + control.address;
    case Control::Kind::controlChange: return "cc " + channel + ' ' + std::to_string(control.number);
    case Control::Kind::note: return "note " + channel + ' ' + std::to_string(control.number);
    case Control::Kind::pitchBend: return "bend " + channel;
    }
    return {};
}

std::optional<Control> controlFrom(std::string_view text)
{
    const std::string_view kind = takeWord(text);
    const bool isOsc = kind == "osc";
    const std::optional<int> channel =
        numberFrom(takeWord(text), 1, isOsc ? static_cast<int>(mostOscNumbers) : mostChannels);
    if (!channel) return {};
    if (isOsc) {
        if (!isOscAddress(text)) return {};
        return Control{Control::Kind::osc, *channel, 0, std::string(text)};
    }
    if (kind == "bend")
        return text.empty() ? std::optional(Control{Control::Kind::pitchBend, *channel, 0, {}}) : std::nullopt;
    if (kind != "cc" && kind != "note") return {};
    const bool isNote = kind == "note";
    const std::optional<int> number = numberFrom(text, 0, isNote ? largestByte : firstModeMessage - 1);
    if (!number) return {};
    return Control{isNote ? Control::Kind::note : Control::Kind::controlChange, *channel, *number, {}};
}

}  // namespace vitrine::ui
