#pragma once

#include "exhibits/compare/comparison.h"
#include "render/files/strict_json.h"

#include <array>
#include <filesystem>
#include <string>

namespace vitrine::app {

/// Texts and settings of a written comparison, beside its results.
struct ComparisonText {
    std::array<std::string, 2> names;    ///< Names of A and B for people.
    std::array<std::string, 2> presets;  ///< Preset texts of A and B, which are written into their pictures.
    double gain = 8;                     ///< Initial factor of the page; one of `comparisonGains`.
    render::Json machine;
};

/// Factors by which differences are multiplied. Each has pictures of its own.
inline constexpr std::array<int, 7> comparisonGains{1, 2, 4, 8, 16, 32, 64};

/// Throws Failure (ErrorKind::usage) if the folder exists and contains anything but a comparison.
void requireComparisonFolder(const std::filesystem::path&);

/// Returns all results except the pictures.
[[nodiscard]] render::Json comparisonJson(Subjects, const Comparison&, const ComparisonText&);

/// Writes index.html, comparison.json and the pictures: a.png and b.png with their presets inside, and the differences
/// flip-G.png and signed-G.png for each factor G. All files are written beside the folder first, which is then
/// replaced; files of others stay in it. Throws Failure (ErrorKind::file).
void writeComparisonFolder(const std::filesystem::path&, Subjects, const Comparison&, const ComparisonText&);

}  // namespace vitrine::app
