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

/// A JSON text with the position of every value. It serves to report positions, and to change one value without
/// reformatting the rest. Values are indexed in the order of the text: a parent before its children. No function is
/// recursive.
class JsonText {
public:
    /// Throws JsonFailure as `parseJson` does.
    JsonText(std::string text, std::string name, const JsonLimits& limits = {});

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::vector<JsonSpan>& values() const { return values_; }
    [[nodiscard]] const JsonSpan& value(std::uint32_t index) const { return values_[index]; }

    /// Returns the text of a value as it is written.
    [[nodiscard]] std::string_view written(std::uint32_t index) const;
    /// Returns the key of a member, without escapes; empty for other values.
    [[nodiscard]] std::string key(std::uint32_t index) const;
    /// Returns the content of a string, without escapes.
    [[nodiscard]] std::string string(std::uint32_t index) const;
    /// Returns the value of a number.
    [[nodiscard]] double number(std::uint32_t index) const;
    /// Returns the value of a boolean.
    [[nodiscard]] bool boolean(std::uint32_t index) const { return text_[values_[index].begin] == 't'; }
    /// Returns the elements of an array or the members of an object.
    [[nodiscard]] std::vector<std::uint32_t> children(std::uint32_t index) const;
    /// Returns the member of an object, or nothing.
    [[nodiscard]] std::optional<std::uint32_t> member(std::uint32_t object, std::string_view key) const;
    /// Returns the value at a path such as "root.children[2].radius", or nothing. "" is the whole text.
    [[nodiscard]] std::optional<std::uint32_t> at(std::string_view path) const;
    /// Returns the path of a value. A path with more parts than `mostParts` is shortened in the middle.
    [[nodiscard]] std::string path(std::uint32_t index, std::size_t mostParts = 20) const;
    /// Returns the complete path, as `at` takes it.
    [[nodiscard]] std::string wholePath(std::uint32_t index) const { return path(index, std::string::npos); }
    /// Returns the position of a value's key, or of the value if it has none.
    [[nodiscard]] TextPosition position(std::uint32_t index) const;

    // These functions return the text with one change; all other bytes stay the same. Inserted text must be JSON.

    [[nodiscard]] std::string withValue(std::uint32_t index, std::string_view json) const;
    /// Replaces the member, or adds it after the last one with the same layout.
    [[nodiscard]] std::string withMember(std::uint32_t object, std::string_view key, std::string_view json) const;
    /// Inserts an element before index `before`, or after the last one.
    [[nodiscard]] std::string withElement(std::uint32_t array, std::size_t before, std::string_view json) const;
    /// Removes this member or element, with its comma and the blanks before it.
    [[nodiscard]] std::string without(std::uint32_t index) const;
    /// Renames a member.
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
