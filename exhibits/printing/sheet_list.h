#pragma once

#include "exhibits/printing/sheet.h"

#include <filesystem>
#include <vector>

namespace vitrine::printing {

/// The sheets to choose from: those that come with the program, and the user's own, a small file of JSON that can also
/// be edited by hand, lengths in millimeters:
///
///     {"format": "vitrine-sheets", "version": 1, "sheets": [{"name": "...", "nominalLpi": 60, ...}]}
///
/// The file is read whenever it is asked for, and never written over when it could not be read.
class SheetList {
public:
    /// "vitrine/sheets.json" in the configuration folder.
    SheetList();
    explicit SheetList(std::filesystem::path own) : path_(std::move(own)) {}

    /// Shipped ones first: `knownSheets`, then the user's. `problem` says why the user's own could not be read.
    [[nodiscard]] std::vector<Sheet> all(std::string& problem) const;
    /// The sheet of that name. Throws Failure (Blame::usage) when there is none.
    [[nodiscard]] Sheet named(const std::string& name) const;
    /// The name of the sheet with these numbers, or empty when there is none. Of several alike, the one that is named
    /// `preferred`, else the first.
    [[nodiscard]] std::string nameOf(const Sheet&, const std::string& preferred = {}) const;
    /// Adds the sheet to the user's own, or replaces the one of its name. Throws Failure when the sheet cannot be, when
    /// a shipped sheet has that name, or when the file cannot be written.
    void save(const Sheet&) const;
    void remove(const std::string& name) const;

private:
    /// Empty when there is no such file. Throws Failure naming file, line and key.
    [[nodiscard]] std::vector<Sheet> own() const;
    void write(const std::vector<Sheet>&) const;

    std::filesystem::path path_;
};

}  // namespace vitrine::printing
