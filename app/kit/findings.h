#pragma once

#include "render/files/strict_json.h"
#include "render/text/message.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {
class Failure;
}

namespace vitrine::app {

/// Result of a check: an error, or a note on something that the program changes or leaves out.
struct CheckFinding {
    bool isError = true;
    Message sentence = {};
    std::string file = {};     ///< File that it is about; empty: the checked one.
    int line = 0, column = 0;  ///< From 1; 0: unknown.
    std::string key = {};      ///< Path of the value ("values.morph"); empty: unknown, or the whole file.
};

/// Returns the error of checking a file, at the place of the failure.
[[nodiscard]] CheckFinding findingOf(const Failure&, const std::string& file);

/// Document in which all `check` commands list what they found (assets/schemas/findings.schema.json):
///
///     {"format": "vitrine-findings", "version": 1, "app": "0.1.0", "command": "preset check", "good": false,
///      "files": [{"file": "a.json", "good": false,
///                 "findings": [{"level": "error", "sentence": "...", "file": "a.json", "line": 3, "key": "values"}]}]}
class FindingsReport {
public:
    /// `command`: words of the command, such as "preset check".
    explicit FindingsReport(std::string_view command);

    /// Adds a file. Returns its entry, to which facts such as "exhibit" can be added; valid until the next call.
    render::Json& add(const std::string& file, bool good, const std::vector<CheckFinding>&);
    /// Prints the document to standard output.
    void print() const;

private:
    render::Json json_;
};

/// Checks each file, with a report if `asJson`, which is then printed, else with null. `check` returns 0 for a good
/// file, else an exit code. Returns the largest one.
[[nodiscard]] int checkEach(const std::vector<std::string>& files, std::string_view command, bool asJson,
                            const std::function<int(const std::string& file, FindingsReport*)>& check);

/// Returns a document with the keys "format", "version" (1) and "app", which begin each document that a command prints.
[[nodiscard]] render::Json newDocument(std::string_view format);

}  // namespace vitrine::app
