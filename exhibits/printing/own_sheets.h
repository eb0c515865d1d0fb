#pragma once

#include "exhibits/printing/sheet.h"

#include <filesystem>
#include <vector>

namespace vitrine::printing {

/// The sheets of the user's own: a small file of JSON that can also be edited by hand, lengths in millimeters:
///
///     {"format": "vitrine-sheets", "version": 1, "sheets": [{"name": "...", "nominalLpi": 60, ...}]}
///
/// It is read whenever it is asked for, and never written over when it could not be read.
class OwnSheets {
public:
    explicit OwnSheets(std::filesystem::path path) : path_(std::move(path)) {}

    /// Empty when there is no such file. Throws Failure naming file, line and key.
    [[nodiscard]] std::vector<Sheet> read() const;
    /// Adds the sheet, or replaces the one of its name. Throws Failure, also when a shipped sheet has that name.
    void save(const Sheet&) const;
    void remove(const std::string& name) const;

private:
    void write(const std::vector<Sheet>&) const;

    std::filesystem::path path_;
};

}  // namespace vitrine::printing
