#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace vitrine {

/// A file name for a Unicode name: "half-a-mug" for "Half a Mug!", "cafe" for "Café". Only a-z, 0-9 and
/// single dashes, at most 64 characters, never empty ("preset" when nothing of the name remains).
[[nodiscard]] std::string slugFor(std::string_view name);

/// `<folder>/<slug>.json`, or with -2, -3, ... when that is taken.
[[nodiscard]] std::filesystem::path freePath(const std::filesystem::path& folder, const std::string& slug);

}  // namespace vitrine
