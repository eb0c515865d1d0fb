#pragma once

#include "render/text/message.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace vitrine {

/// Kind of failure, by who must act on it; the value is the program's exit code.
enum class ErrorKind : int { check = 1, usage = 2, openGl = 3, shader = 4, file = 5 };

/// Place in a file that a failure is about. The message names it, too.
struct FilePlace {
    std::string file = {};     ///< Name as the message shows it; empty: the failure is about no file.
    int line = 0, column = 0;  ///< From 1, the column in bytes; 0: unknown.
    std::string key = {};      ///< Path of a value ("values.morph"); empty: unknown, or the whole file.
};

/// Error of the environment (file, preset, driver, shader, disk). A bug in the program is an assert instead.
///
/// `what()` is one sentence for people: what was being done, to what (file, line, key), what is wrong and what to do
/// next. A function that throws it leaves everything as it was.
class Failure : public std::runtime_error {
public:
    Failure(ErrorKind kind, Message message, FilePlace place = {})
        : std::runtime_error(message.english()), kind_(kind),
          content_(std::make_shared<const Content>(Content{std::move(message), std::move(place)}))
    {
    }

    [[nodiscard]] ErrorKind kind() const { return kind_; }
    [[nodiscard]] const Message& message() const { return content_->message; }
    [[nodiscard]] const FilePlace& place() const { return content_->place; }
    [[nodiscard]] int exitCode() const { return static_cast<int>(kind_); }

private:
    struct Content {
        Message message;
        FilePlace place;
    };

    ErrorKind kind_;
    std::shared_ptr<const Content> content_;  ///< Shared, because copying an exception must not fail.
};

}  // namespace vitrine
