#pragma once

#include "render/text/message.h"

#include <memory>
#include <stdexcept>
#include <utility>

namespace vitrine {

/// Kind of failure, by who must act on it; the value is the program's exit code.
enum class ErrorKind : int { check = 1, usage = 2, openGl = 3, shader = 4, file = 5 };

/// Error of the environment (file, preset, driver, shader, disk). A bug in the program is an assert instead.
///
/// `what()` is one sentence for people: what was being done, to what (file, line, key), what is wrong and what to do
/// next. A function that throws it leaves everything as it was.
class Failure : public std::runtime_error {
public:
    Failure(ErrorKind kind, Message message)
        : std::runtime_error(message.english()), kind_(kind),
          message_(std::make_shared<const Message>(std::move(message)))
    {
    }

    [[nodiscard]] ErrorKind kind() const { return kind_; }
    [[nodiscard]] const Message& message() const { return *message_; }
    [[nodiscard]] int exitCode() const { return static_cast<int>(kind_); }

private:
    ErrorKind kind_;
    std::shared_ptr<const Message> message_;  ///< Shared, because copying an exception must not fail.
};

}  // namespace vitrine
