#pragma once

#include "render/failure.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace vitrine::render {

/// JSON whose objects keep the order of their keys.
using Json = nlohmann::ordered_json;

/// What a JSON text may be at most; the reader refuses anything beyond.
struct JsonLimits {
    std::size_t bytes = 32U << 20U;       ///< Of the whole text.
    std::size_t depth = 64;               ///< Objects and arrays inside one another.
    std::size_t nodes = 4'000'000;        ///< Values of all kinds.
    std::size_t stringBytes = 1U << 20U;  ///< Of one string or key.
};

/// Where a text stops being JSON, and why; `what()` has it all in one sentence.
class JsonFailure : public Failure {
public:
    /// `key` is a path ("values.morph"), empty outside of objects; `problem` a sentence without its full stop.
    JsonFailure(const std::string& file, int line, int column, const std::string& key, const std::string& problem);

    [[nodiscard]] int line() const { return line_; }      ///< From 1.
    [[nodiscard]] int column() const { return column_; }  ///< From 1, in bytes.
    [[nodiscard]] const std::string& key() const { return key_; }
    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    int line_, column_;
    std::string key_, problem_;
};

/// A JSON text that was read, and that can still say where each of its keys stands.
class JsonDocument {
public:
    JsonDocument(Json root, std::string text, std::string name)
        : root_(std::move(root)), text_(std::move(text)), name_(std::move(name))
    {
    }

    [[nodiscard]] const Json& root() const { return root_; }
    [[nodiscard]] Json& root() { return root_; }                     ///< Lines go on to be those of the text.
    [[nodiscard]] const std::string& name() const { return name_; }  ///< Of the file, as messages show it.
    [[nodiscard]] const std::string& text() const { return text_; }

    /// The line (from 1) of the key or array element at `keyPath` ("values.morph", "accessors[3].count"),
    /// or of the nearest one above it that exists; 1 when there is none.
    [[nodiscard]] int lineOf(std::string_view keyPath) const;

    /// "<name>, line <n>, <key path>: <problem>", to throw. An empty path leaves out line and key.
    [[nodiscard]] Failure failure(std::string_view keyPath, std::string_view problem) const;

private:
    Json root_;
    std::string text_;
    std::string name_;
};

/// Reads one JSON value, strictly (RFC 8259), behind a byte order mark or without one. Beyond what the grammar
/// refuses, it refuses a key that stands twice in one object, numbers beyond double range (1e999), invalid UTF-8, NUL
/// in strings, control characters in keys, and everything beyond `limits`. `name` is the file's name for messages.
/// Throws JsonFailure naming file, line, column and, inside an object, the key path. Does not recurse.
[[nodiscard]] JsonDocument parseJson(std::string text, std::string name, const JsonLimits& limits = {});

/// Reads a regular file with `parseJson`. Throws Failure as `readFile` and `parseJson` do.
[[nodiscard]] JsonDocument readJson(const std::filesystem::path&, const JsonLimits& limits = {});

/// JSON text for files: two blanks of indent, arrays of plain numbers on one line, the shortest numbers
/// that read back as the same bits, and a newline at the end; the same in every locale. A double that is a
/// whole number keeps its ".0", so that its type survives. Throws Failure naming the key path when a
/// number is not finite (JSON has no word for it) or a string is not valid UTF-8.
[[nodiscard]] std::string writeJson(const Json&);

/// The same JSON with every character beyond ASCII written as \uXXXX, for places that only carry Latin-1.
[[nodiscard]] std::string asciiJson(std::string_view utf8Json);

}  // namespace vitrine::render
