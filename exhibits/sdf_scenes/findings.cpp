#include "exhibits/sdf_scenes/findings.h"

#include "render/files/number_text.h"
#include "render/text/nearest_word.h"

#include <algorithm>
#include <cmath>

namespace vitrine::scenes {
namespace {

/// Shortens a word to one line of a message.
std::string shownWord(std::string_view word)
{
    constexpr std::size_t most = 40;
    std::string text(word.substr(0, most));
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    return '"' + text + (word.size() > most ? "...\"" : "\"");
}

}  // namespace

std::string sentenceNumber(double x)
{
    const std::string whole = std::isfinite(x) ? render::shortestNumber(x) : std::string(20, ' ');
    constexpr std::size_t most = 8;
    const bool isPlain = whole.size() <= most && whole.find('e') == std::string::npos;
    return isPlain ? whole : render::shortNumber(x);
}

std::string listed(const std::vector<std::string>& words)
{
    constexpr std::size_t most = 12;
    std::string text;
    const std::size_t shown = std::min(words.size(), most);
    for (std::size_t i = 0; i < shown; ++i) {
        if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
        text += words[i];
    }
    return words.size() > most ? text + " and others" : text;
}

std::string unknownWord(std::string_view word, const std::string& of, const std::vector<std::string>& known)
{
    std::string sentence = "unknown " + of + ": " + shownWord(word);
    const std::string nearest = nearestWord(word.substr(0, 40), known);
    if (!nearest.empty()) return sentence + "; did you mean \"" + nearest + "\"? Known are " + listed(known);
    return sentence + (known.empty() ? "; there are none here" : "; take one of " + listed(known));
}

void Findings::translate(const render::JsonText& made, const render::JsonText& original, std::vector<MadeFrom> parts)
{
    made_ = &made;
    original_ = &original;
    parts_ = std::move(parts);
}

void Findings::add(const render::JsonText& text, std::uint32_t value, const std::string& sentence)
{
    if (full()) return;
    if (&text != made_) {
        const render::TextPosition at = text.position(value);
        list_.push_back({text.name(), at.line, at.column, text.path(value), sentence + '.'});
        return;
    }
    const std::string path = text.path(value);
    const MadeFrom* nearest = nullptr;
    for (const MadeFrom& part : parts_)
        if (path.starts_with(part.path) && (!nearest || part.path.size() > nearest->path.size())) nearest = &part;
    const std::uint32_t original = nearest ? nearest->original : 0;
    if (nearest && nearest->shape) shapes_.push_back(original);
    const render::TextPosition at = original_->position(original);
    list_.push_back({original_->name(), at.line, at.column, original_->path(original), sentence + '.'});
}

void Findings::addOfShape(const render::JsonText& text, std::uint32_t value, const std::string& sentence)
{
    if (full()) return;
    add(text, value, sentence);
    shapes_.push_back(value);
}

std::vector<std::uint32_t> Findings::shapes() const
{
    return shapes_.size() == list_.size() ? shapes_ : std::vector<std::uint32_t>();
}

void Findings::add(const render::JsonFailure& failure)
{
    if (full()) return;
    constexpr std::size_t most = 200;  // Limit for a path, which may be 40,000 levels deep.
    const auto& [file, line, column, key] = failure.place();
    list_.push_back({file, line, column, key.size() > most ? "..." + key.substr(key.size() - most) : key,
                     failure.problem().english() + '.'});
}

}  // namespace vitrine::scenes
