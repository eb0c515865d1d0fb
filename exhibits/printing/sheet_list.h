#pragma once

#include "exhibits/printing/sheet.h"

#include <filesystem>
#include <vector>

namespace vitrine::printing {

/// Available sheets: the shipped ones, and the user's own in a small JSON file. It can also be edited by hand; lengths
/// are in millimeters:
///
///     {"format": "vitrine-sheets", "version": 1, "sheets": [{"name": "...", "nominalLpi": 60, ...}]}
///
/// The file is read at every call, and never overwritten if it cannot be read.
class SheetList {
public:
    /// Uses "vitrine/sheets.json" in the configuration folder.
    SheetList();
    explicit SheetList(std::filesystem::path own) : path_(std::move(own)) {}

    /// Returns `knownSheets`, then the user's sheets. `problem` says why the user's own could not be read.
    [[nodiscard]] std::vector<Sheet> all(std::string& problem) const;
    /// Returns the sheet of that name. Throws Failure (ErrorKind::usage) if there is none.
    [[nodiscard]] Sheet named(const std::string& name) const;
    /// Returns the name of the sheet with these numbers, or an empty text. Among several, it is the one named
    /// `preferred`, otherwise the first.
    [[nodiscard]] std::string nameOf(const Sheet&, const std::string& preferred = {}) const;
    /// Adds the sheet to the user's own, or replaces the one of its name. Throws Failure if the sheet is impossible, if
    /// a shipped sheet has that name, or if the file cannot be written.
    void save(const Sheet&) const;
    void remove(const std::string& name) const;

private:
    /// Returns an empty list if there is no such file. Throws Failure naming file, line and key.
    [[nodiscard]] std::vector<Sheet> own() const;
    void write(const std::vector<Sheet>&) const;

    std::filesystem::path path_;
};

}  // namespace vitrine::printing
