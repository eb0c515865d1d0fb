#pragma once

#include "exhibits/compare/comparison.h"
#include "render/files/strict_json.h"

#include <array>
#include <filesystem>
#include <string>

namespace vitrine::app {

/// What a comparison is written as besides what it found.
struct ComparisonText {
    std::array<std::string, 2> names;    ///< What A and B are, for people.
    std::array<std::string, 2> presets;  ///< The text that brings each back: goes into its picture.
    double gain = 8;                     ///< That the page starts with, one of `comparisonGains`.
    render::Json machine;
};

/// What differences are multiplied by; each has pictures of its own.
inline constexpr std::array<int, 7> comparisonGains{1, 2, 4, 8, 16, 32, 64};

/// Throws Failure (Blame::usage) when the folder is there and holds anything but a comparison.
void requireComparisonFolder(const std::filesystem::path&);

/// Everything that was found but the pictures.
[[nodiscard]] render::Json comparisonJson(Subjects, const Comparison&, const ComparisonText&);

/// Writes index.html, comparison.json and the pictures: a.png and b.png with what brings them back inside, and their
/// differences, flip-G.png and signed-G.png for each gain G. All of it is written beside the folder first, which is
/// then replaced; files of others stay in it. Throws Failure (Blame::file).
void writeComparisonFolder(const std::filesystem::path&, Subjects, const Comparison&, const ComparisonText&);

}  // namespace vitrine::app
