#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace vitrine::render {

/// The bytes of a regular file. Throws Failure naming the file when it cannot be opened, is not a regular
/// file (a folder, a pipe, a device) or is larger than `mostBytes`. Never waits on a pipe.
[[nodiscard]] std::string readFile(const std::filesystem::path&, std::uint64_t mostBytes);

/// How far a reference that was found inside a file may lead.
enum class Reach : std::uint8_t {
    folder,  ///< The folder that the file lies in, and folders in it.
    parent,  ///< The folder that holds that folder, and folders in it: "../textures/wood.png".
};

/// Why `reference`, found inside a file, may not be followed; empty when it may. Only relative paths with
/// `/` that stay within their reach are followed: no "~" or "$", no backslash, no control characters, no drive
/// letter or URL scheme, at most 4096 bytes. ".." takes back the component before it ("a/../b" is "b").
[[nodiscard]] std::string whyRefused(std::string_view reference, Reach = Reach::folder);

/// The bytes of the regular file `reference`, seen from `folder`. Throws Failure as `readFile` does, and when
/// `reference` is refused or any component of it is a symbolic link: nothing beyond its reach is opened,
/// even when the tree changes meanwhile. With `Reach::parent`, the folder above is the one that really holds `folder`,
/// also where `folder` is reached by a link.
[[nodiscard]] std::string readFileBeneath(const std::filesystem::path& folder, std::string_view reference,
                                          std::uint64_t mostBytes, Reach = Reach::folder);

}  // namespace vitrine::render
