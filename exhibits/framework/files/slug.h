#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace vitrine {

/// Returns a file name for a Unicode name: "half-a-mug" for "Half a Mug!", "cafe" for "Café". It contains only a-z, 0-9
/// and single dashes, at most 64 characters, and is never empty ("preset" if no character remains).
[[nodiscard]] std::string slugFor(std::string_view name);

/// Returns `<folder>/<slug>.json`, or with -2, -3, ... if that exists.
[[nodiscard]] std::filesystem::path freePath(const std::filesystem::path& folder, const std::string& slug);

}  // namespace vitrine
