#pragma once

#include <filesystem>
#include <string_view>

namespace vitrine {

/// Replaces a small file, or leaves it as it was; creates its folder. QSaveFile does the work, with the
/// checks that it lacks in Qt 6.4 (its `commit` returns true on a full disk and replaces the good file by
/// half of the new one): sizes and errors before the commit, afterwards a sync of the folder and a
/// comparison with what is on the disk. Keeps mode and symbolic links.
/// Throws Failure naming file and cause.
void savePresetBytes(const std::filesystem::path&, std::string_view bytes);

}  // namespace vitrine
