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

/// Upper limits for a JSON text; the reader refuses anything beyond.
struct JsonLimits {
    std::size_t bytes = 32U << 20U;       ///< Size of the whole text.
    std::size_t depth = 64;               ///< Nesting depth of objects and arrays.
    std::size_t nodes = 4'000'000;        ///< Number of values of all kinds.
    std::size_t stringBytes = 1U << 20U;  ///< Size of one string or key.
};

/// Syntax error of a JSON text with its position; `what()` says all in one sentence.
class JsonFailure : public Failure {
public:
    /// The key of the place is empty outside of objects; `problem` is a sentence without its full stop.
    JsonFailure(const FilePlace&, const Message& problem);

    [[nodiscard]] const Message& problem() const { return problem_; }

private:
    Message problem_;
};

/// A parsed JSON text that can still give the line of each of its keys.
class JsonDocument {
public:
    JsonDocument(Json root, std::string text, std::string name)
        : root_(std::move(root)), text_(std::move(text)), name_(std::move(name))
    {
    }

    [[nodiscard]] const Json& root() const { return root_; }
    [[nodiscard]] Json& root() { return root_; }                     ///< Changes do not affect the line numbers.
    [[nodiscard]] const std::string& name() const { return name_; }  ///< Name of the file, as messages show it.
    [[nodiscard]] const std::string& text() const { return text_; }

    /// Returns the line (from 1) of the key or array element at `keyPath` ("values.morph", "accessors[3].count"), or of
    /// the nearest existing one above it; 1 if there is none.
    [[nodiscard]] int lineOf(std::string_view keyPath) const;

    /// Returns the error "<name>, line <n>, <key path>: <problem>", to be thrown. An empty path omits line and key.
    [[nodiscard]] Failure failure(std::string_view keyPath, const Message& problem) const;

private:
    Json root_;
    std::string text_;
    std::string name_;
};

/// Parses one JSON value, strictly (RFC 8259), with or without a byte order mark. Besides invalid grammar, it refuses a
/// key that occurs twice in one object, numbers beyond double range (1e999), invalid UTF-8, NUL in strings, control
/// characters in keys, and everything beyond `limits`. `name` is the file's name for messages. Throws JsonFailure
/// naming file, line, column and, inside an object, the key path. Not recursive.
[[nodiscard]] JsonDocument parseJson(std::string text, std::string name, const JsonLimits& limits = {});

/// Reads and parses a regular file. Throws Failure as `readFile` and `parseJson` do.
[[nodiscard]] JsonDocument readJson(const std::filesystem::path&, const JsonLimits& limits = {});

/// Formats JSON for files: two blanks of indent, arrays of plain numbers on one line, the shortest numbers that read
/// back as the same bits, and a newline at the end; the same in every locale. A double that is a whole number keeps its
/// ".0", so that its type is preserved. Throws Failure naming the key path if a number is not finite (JSON cannot
/// represent it) or a string is not valid UTF-8.
[[nodiscard]] std::string writeJson(const Json&);

/// Returns the same JSON with every non-ASCII character written as `\uXXXX`, for places that can only store Latin-1.
[[nodiscard]] std::string asciiJson(std::string_view utf8Json);

}  // namespace vitrine::render
