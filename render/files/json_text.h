#pragma once

#include "render/files/json_span.h"
#include "render/files/text_position.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::render {

/// A JSON text with the place of every value, for what must name a place or change the text of one value and leave the
/// rest as it was written. Values stand in the order of the text: a parent before its children. Nothing here recurses.
class JsonText {
public:
    /// Throws JsonFailure as `parseJson` does.
    JsonText(std::string text, std::string name, const JsonLimits& limits = {});

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::vector<JsonSpan>& values() const { return values_; }
    [[nodiscard]] const JsonSpan& value(std::uint32_t index) const { return values_[index]; }

    /// Of the value, as it is written.
    [[nodiscard]] std::string_view written(std::uint32_t index) const;
    /// Of a member, without escapes; empty for others.
    [[nodiscard]] std::string key(std::uint32_t index) const;
    /// Of a string, without escapes.
    [[nodiscard]] std::string string(std::uint32_t index) const;
    /// Of a number.
    [[nodiscard]] double number(std::uint32_t index) const;
    /// Of a boolean.
    [[nodiscard]] bool boolean(std::uint32_t index) const { return text_[values_[index].begin] == 't'; }
    /// Of an array or an object.
    [[nodiscard]] std::vector<std::uint32_t> children(std::uint32_t index) const;
    /// The member of an object, or nothing.
    [[nodiscard]] std::optional<std::uint32_t> member(std::uint32_t object, std::string_view key) const;
    /// The value at a path such as "root.children[2].radius", or nothing. "" is the whole.
    [[nodiscard]] std::optional<std::uint32_t> at(std::string_view path) const;
    /// The path of a value. Of one with more parts than `mostParts` the beginning and the end.
    [[nodiscard]] std::string path(std::uint32_t index, std::size_t mostParts = 20) const;
    /// The whole of it, as `at` takes it.
    [[nodiscard]] std::string wholePath(std::uint32_t index) const { return path(index, std::string::npos); }
    /// Of a value's key, or of the value where it has none.
    [[nodiscard]] TextPosition position(std::uint32_t index) const;

    // The text with one change; all that is not named keeps its bytes. What is put in must be JSON.

    [[nodiscard]] std::string withValue(std::uint32_t index, std::string_view json) const;
    /// Replaces the member, or adds it behind the last one, laid out as that.
    [[nodiscard]] std::string withMember(std::uint32_t object, std::string_view key, std::string_view json) const;
    /// `before` the element of this number, or behind the last one.
    [[nodiscard]] std::string withElement(std::uint32_t array, std::size_t before, std::string_view json) const;
    /// Without this member or element, its comma and the blanks that led to it.
    [[nodiscard]] std::string without(std::uint32_t index) const;
    /// With another name for a member.
    [[nodiscard]] std::string withKey(std::uint32_t member, std::string_view key) const;

private:
    [[nodiscard]] std::string inserted(std::uint32_t parent, std::size_t before, const std::string& item) const;
    [[nodiscard]] std::string spliced(std::size_t begin, std::size_t end, std::string_view with) const;

    std::string text_;
    std::string name_;
    std::vector<JsonSpan> values_;
    std::vector<std::uint32_t> lineStarts_;
};

}  // namespace vitrine::render
