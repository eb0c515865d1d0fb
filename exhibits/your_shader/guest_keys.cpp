#include "exhibits/your_shader/guest_keys.h"

#include "render/files/number_text.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <mutex>
#include <optional>
#include <utility>

namespace vitrine::guest {
namespace {

constexpr std::size_t keyCodes = 256;

/// Reads "65@1-2.5" or "65@1".
std::optional<KeyPress> pressOf(std::string_view word)
{
    const std::size_t at = word.find('@');
    if (at == std::string_view::npos) return std::nullopt;
    const std::size_t dash = std::min(word.find('-', at + 2), word.size());  // The first sign may be that of a number.
    const std::optional<double> code = render::parseNumber(word.substr(0, at));
    const std::optional<double> from = render::parseNumber(word.substr(at + 1, dash - at - 1));
    if (!code || *code < 0 || *code >= keyCodes || *code != std::floor(*code) || !from || !std::isfinite(*from))
        return std::nullopt;
    KeyPress press{static_cast<int>(*code), *from};
    if (dash == word.size()) return press;
    const std::optional<double> to = render::parseNumber(word.substr(dash + 1));
    if (!to || !(*to >= *from)) return std::nullopt;
    press.to = *to;
    return press;
}

std::string textOf(const std::vector<KeyPress>& presses)
{
    std::string text;
    for (const KeyPress& press : presses) {
        if (!text.empty()) text += ' ';
        ((text += std::to_string(press.code)) += '@') += render::shortestNumber(press.from);
        if (std::isfinite(press.to)) (text += '-') += render::shortestNumber(press.to);
    }
    return text;
}

/// Leaves out the first two presses of a key, or the first of all.
void dropOldest(std::vector<KeyPress>& presses)
{
    for (std::size_t i = 0; i < presses.size(); ++i)
        for (std::size_t j = i + 1; j < presses.size(); ++j)
            if (presses[j].code == presses[i].code) {
                presses.erase(presses.begin() + static_cast<std::ptrdiff_t>(j));
                presses.erase(presses.begin() + static_cast<std::ptrdiff_t>(i));
                return;
            }
    presses.erase(presses.begin());
}

}  // namespace

KeyPresses readKeys(std::string_view text)
{
    KeyPresses read;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(" \t\n"), text.size());
        const std::string_view word = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (word.empty()) continue;
        const std::optional<KeyPress> press = pressOf(word);
        if (!press || read.presses.size() >= mostPresses) {
            read.problem = press ? message("There are more than {1} presses of keys; remove some.", mostPresses)
                                 : message("“{1}” is not a key press; write code@from-to, such as 65@1-2.5.", word);
            return read;
        }
        read.presses.push_back(*press);
    }
    return read;
}

std::string withKey(std::string_view text, int code, bool isDown, double time)
{
    std::vector<KeyPress> presses = readKeys(text).presses;
    const auto held = std::find_if(presses.begin(), presses.end(),
                                   [&](const KeyPress& press) { return press.code == code && std::isinf(press.to); });
    if (!isDown && held != presses.end()) held->to = std::max(time, held->from);
    if (isDown && held == presses.end()) {
        if (presses.size() >= mostPresses) dropOldest(presses);
        presses.push_back({code, time});
    }
    return textOf(presses);
}

std::shared_ptr<const render::Texture> keyboardPicture(const std::vector<KeyPress>& presses, const StepTime& time)
{
    std::vector<std::uint8_t> bytes(3 * keyCodes, 0);
    const auto stepAt = [&](double seconds) { return std::floor(seconds * time.rate + 1e-6); };
    const auto now = static_cast<double>(time.frame);
    for (const KeyPress& press : presses) {
        const auto column = static_cast<std::size_t>(press.code);
        const double first = stepAt(press.from), end = stepAt(press.to);
        const bool isPressed = first == now && press.to > press.from;
        if (isPressed || (first <= now && now < end)) bytes[column] = 255;
        if (isPressed) bytes[keyCodes + column] = 255;
        if (first <= now) bytes[2 * keyCodes + column] ^= 255U;
    }
    // Textures are uploaded once, by their address: the same keys have the same texture.
    static std::mutex mutex;
    static std::list<std::shared_ptr<const render::Texture>> kept;
    constexpr std::size_t mostKept = 16;
    const std::lock_guard lock(mutex);
    for (const auto& each : kept)
        if (each->bytes == bytes) return each;
    auto made = std::make_shared<render::Texture>();
    made->name = "keyboard";
    made->width = keyCodes;
    made->height = 3;
    made->channels = 1;
    made->repeat = made->mipmaps = false;
    made->magnifyNearest = made->minifyNearest = true;
    made->bytes = std::move(bytes);
    kept.push_front(std::move(made));
    if (kept.size() > mostKept) kept.pop_back();
    return kept.front();
}

}  // namespace vitrine::guest
