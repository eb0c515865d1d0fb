#include "render/files/json_text.h"

#include "render/files/byte_order_mark.h"
#include "render/files/number_text.h"

#include <algorithm>
#include <cassert>

namespace vitrine::render {
namespace {

/// Returns the content of a quoted string, without escapes; the text must be valid JSON.
std::string unquoted(std::string_view quotedText)
{
    const std::string_view inside = quotedText.substr(1, quotedText.size() - 2);
    if (inside.find('\\') == std::string_view::npos) return std::string(inside);
    return Json::parse(quotedText).get<std::string>();
}

std::string quotedKey(std::string_view key)
{
    return Json(std::string(key)).dump();
}

}  // namespace

JsonText::JsonText(std::string text, std::string name, const JsonLimits& limits)
    : text_(withoutByteOrderMark(std::move(text))), name_(std::move(name)), values_(jsonSpans(text_, name_, limits))
{
    lineStarts_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i)
        if (text_[i] == '\n') lineStarts_.push_back(static_cast<std::uint32_t>(i + 1));
}

std::string_view JsonText::written(std::uint32_t index) const
{
    const JsonSpan& span = values_[index];
    return std::string_view(text_).substr(span.begin, span.end - span.begin);
}

std::string JsonText::key(std::uint32_t index) const
{
    const JsonSpan& span = values_[index];
    if (span.keyEnd == span.keyBegin) return {};
    return unquoted(std::string_view(text_).substr(span.keyBegin, span.keyEnd - span.keyBegin));
}

std::string JsonText::string(std::uint32_t index) const
{
    return unquoted(written(index));
}

double JsonText::number(std::uint32_t index) const
{
    return parseNumber(written(index)).value_or(0);
}

std::vector<std::uint32_t> JsonText::children(std::uint32_t index) const
{
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = values_[index].firstChild; i != JsonSpan::none; i = values_[i].next) found.push_back(i);
    return found;
}

std::optional<std::uint32_t> JsonText::member(std::uint32_t object, std::string_view wanted) const
{
    if (values_[object].type != JsonSpan::Type::object) return std::nullopt;
    for (std::uint32_t i = values_[object].firstChild; i != JsonSpan::none; i = values_[i].next)
        if (key(i) == wanted) return i;
    return std::nullopt;
}

std::optional<std::uint32_t> JsonText::at(std::string_view wanted) const
{
    std::uint32_t here = 0;
    while (!wanted.empty()) {
        if (wanted.front() == '[') {
            const std::size_t close = wanted.find(']');
            if (close == std::string_view::npos || values_[here].type != JsonSpan::Type::array) return std::nullopt;
            const std::optional<double> number = parseNumber(wanted.substr(1, close - 1));
            std::uint32_t child = values_[here].firstChild;
            for (double i = 0; number && i < *number && child != JsonSpan::none; ++i) child = values_[child].next;
            if (!number || *number < 0 || child == JsonSpan::none) return std::nullopt;
            here = child;
            wanted.remove_prefix(close + 1);
        } else {
            if (wanted.front() == '.') wanted.remove_prefix(1);
            const std::size_t end = std::min(wanted.find_first_of(".["), wanted.size());
            const std::optional<std::uint32_t> found = member(here, wanted.substr(0, end));
            if (!found) return std::nullopt;
            here = *found;
            wanted.remove_prefix(end);
        }
    }
    return here;
}

std::string JsonText::path(std::uint32_t index, std::size_t mostParts) const
{
    std::vector<std::string> parts;
    for (std::uint32_t i = index; values_[i].parent != JsonSpan::none; i = values_[i].parent) {
        if (values_[i].keyEnd > 0) {
            parts.push_back('.' + key(i));
            continue;
        }
        std::size_t number = 0;
        for (std::uint32_t j = values_[values_[i].parent].firstChild; j != i; j = values_[j].next) ++number;
        parts.push_back('[' + std::to_string(number) + ']');
    }
    std::reverse(parts.begin(), parts.end());
    if (parts.size() > mostParts) {
        const auto kept = static_cast<std::ptrdiff_t>(mostParts / 2);
        parts.erase(parts.begin() + kept, parts.end() - kept);
        parts[mostParts / 2].insert(0, "...");
    }
    std::string text;
    for (const std::string& part : parts) text += part;
    if (text.starts_with('.')) text.erase(0, 1);
    return text;
}

TextPosition JsonText::position(std::uint32_t index) const
{
    const JsonSpan& span = values_[index];
    const std::uint32_t at = span.keyEnd > 0 ? span.keyBegin : span.begin;
    const auto line = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), at) - lineStarts_.begin();
    return {static_cast<int>(line), static_cast<int>(at - lineStarts_[static_cast<std::size_t>(line) - 1]) + 1};
}

std::string JsonText::spliced(std::size_t begin, std::size_t end, std::string_view with) const
{
    std::string changed;
    changed.reserve(text_.size() + with.size());
    changed.append(text_, 0, begin).append(with).append(text_, end);
    return changed;
}

std::string JsonText::withValue(std::uint32_t index, std::string_view json) const
{
    return spliced(values_[index].begin, values_[index].end, json);
}

std::string JsonText::withKey(std::uint32_t memberIndex, std::string_view newKey) const
{
    const JsonSpan& span = values_[memberIndex];
    assert(span.keyEnd > span.keyBegin);
    return spliced(span.keyBegin, span.keyEnd, quotedKey(newKey));
}

/// Inserts an item among the children of its parent, with the layout of its neighbor.
std::string JsonText::inserted(std::uint32_t parent, std::size_t before, const std::string& item) const
{
    const std::vector<std::uint32_t> items = children(parent);
    const auto beginOf = [&](std::uint32_t i) {
        return values_[i].keyEnd > 0 ? values_[i].keyBegin : values_[i].begin;
    };
    if (items.empty()) return spliced(values_[parent].begin + 1, values_[parent].end - 1, item);
    const std::uint32_t neighbor = items[std::min(before, items.size() - 1)];
    std::size_t blanks = beginOf(neighbor);
    while (isBetweenJsonTokens(text_[blanks - 1]) && text_[blanks - 1] != ',') --blanks;
    const std::string lead = text_.substr(blanks, beginOf(neighbor) - blanks);
    if (before < items.size())
        return spliced(beginOf(neighbor), beginOf(neighbor), item + ',' + (lead.empty() ? " " : lead));
    const std::string next = items.size() == 1 && lead.empty() ? " " : lead;
    return spliced(values_[neighbor].end, values_[neighbor].end, ',' + next + item);
}

std::string JsonText::withMember(std::uint32_t object, std::string_view newKey, std::string_view json) const
{
    if (const std::optional<std::uint32_t> there = member(object, newKey)) return withValue(*there, json);
    return inserted(object, JsonSpan::none, quotedKey(newKey) + ": " + std::string(json));
}

std::string JsonText::withElement(std::uint32_t array, std::size_t before, std::string_view json) const
{
    return inserted(array, before, std::string(json));
}

std::string JsonText::without(std::uint32_t index) const
{
    const JsonSpan& span = values_[index];
    assert(span.parent != JsonSpan::none);
    std::size_t begin = span.keyEnd > 0 ? span.keyBegin : span.begin;
    while (isBetweenJsonTokens(text_[begin - 1])) --begin;
    const bool first = text_[begin - 1] == '[' || text_[begin - 1] == '{';
    if (!first || span.next == JsonSpan::none) {
        // The comma before it is removed, too. The only child leaves the blanks before the bracket.
        return spliced(begin, span.end, "");
    }
    const JsonSpan& next = values_[span.next];
    return spliced(span.keyEnd > 0 ? span.keyBegin : span.begin, next.keyEnd > 0 ? next.keyBegin : next.begin, "");
}

}  // namespace vitrine::render
