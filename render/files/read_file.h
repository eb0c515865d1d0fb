#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace vitrine::render {

/// The bytes of a regular file. Throws Failure naming the file when it cannot be opened, is not a regular
/// file (a folder, a pipe, a device) or is larger than `mostBytes`. Never waits on a pipe.
[[nodiscard]] std::string readFile(const std::filesystem::path&, std::uint64_t mostBytes);

/// Why `reference`, found inside a file, may not be followed; empty when it may. Only relative paths with
/// `/` that stay below their folder are followed: no "..", no "~" or "$", no backslash, no control
/// characters, no drive letter or URL scheme, at most 4096 bytes.
[[nodiscard]] std::string whyRefused(std::string_view reference);

/// The bytes of the regular file `reference` below `folder`. Throws Failure as `readFile` does, and when
/// `reference` is refused or any component of it is a symbolic link: nothing outside `folder` is opened,
/// even when the tree changes meanwhile.
[[nodiscard]] std::string readFileBeneath(const std::filesystem::path& folder, std::string_view reference,
                                          std::uint64_t mostBytes);

}  // namespace vitrine::render
