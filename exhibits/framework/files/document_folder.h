#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine {

/// A document that was moved to the trash: its paths before and after.
struct RemovedDocument {
    std::filesystem::path original, trashed;
};

/// Returns the documents of a folder: its JSON files, without hidden ones, in any order. Empty if there is no folder.
[[nodiscard]] std::vector<std::filesystem::path> documentsIn(const std::filesystem::path& folder);

// Documents may have a companion beside them: a file of the same name with the extension `companion` (".png"). Where it
// cannot be moved with its document, it is deleted. Both functions throw Failure with file and cause, and then have
// changed nothing.

/// Moves a document to the folder `trash`.
[[nodiscard]] RemovedDocument removeDocument(const std::filesystem::path&, const std::filesystem::path& trash,
                                             const std::string& companion);
/// Moves a document back, under a new file name if the old one is taken. Returns its path.
std::filesystem::path restoreDocument(const RemovedDocument&, const std::string& companion);
/// Moves the companion of a document that was moved. Never throws.
void moveCompanion(std::filesystem::path from, std::filesystem::path to, const std::string& companion);

}  // namespace vitrine
