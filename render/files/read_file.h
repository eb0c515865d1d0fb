#pragma once

#include "render/text/message.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace vitrine::render {

/// Reads a regular file. Throws Failure naming the file if it cannot be opened, is not a regular file (a folder, a
/// pipe, a device) or is larger than `mostBytes`. Never blocks on a pipe.
[[nodiscard]] std::string readFile(const std::filesystem::path&, std::uint64_t mostBytes);

/// Folders that a reference found inside a file may lead into.
enum class Reach : std::uint8_t {
    folder,  ///< The folder that contains the file, and its subfolders.
    parent,  ///< The parent of that folder, and its subfolders: "../textures/wood.png".
};

/// Returns why `reference`, found inside a file, may not be followed; empty if it may. Only relative paths with `/`
/// that stay within their reach are followed: no "~" or "$", no backslash, no control characters, no drive letter or
/// URL scheme, at most 4096 bytes. ".." removes the component before it ("a/../b" is "b").
[[nodiscard]] Message whyRefused(std::string_view reference, Reach = Reach::folder);

/// Reads the regular file `reference`, relative to `folder`. Throws Failure as `readFile` does, and if `reference` is
/// refused or any component of it is a symbolic link. Nothing beyond its reach is opened, even if the tree changes in
/// the meantime. With `Reach::parent`, the parent is the real one, even if `folder` is reached through a link.
[[nodiscard]] std::string readFileBeneath(const std::filesystem::path& folder, std::string_view reference,
                                          std::uint64_t mostBytes, Reach = Reach::folder);

}  // namespace vitrine::render
