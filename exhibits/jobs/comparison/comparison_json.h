#pragma once

#include "exhibits/compare/comparison.h"
#include "render/files/strict_json.h"

#include <array>
#include <string>

namespace vitrine::jobs {

/// Texts and settings of a written comparison, beside its results.
struct ComparisonText {
    std::array<std::string, 2> names;    ///< Names of A and B for people.
    std::array<std::string, 2> presets;  ///< Preset texts of A and B, which are written into their pictures.
    int gain = 8;                        ///< Initial factor of the page; one of `comparisonGains`.
    render::Json machine;
};

/// Returns all results except the pictures: the content of comparison.json.
[[nodiscard]] render::Json comparisonJson(Subjects, const compare::Comparison&, const ComparisonText&);

}  // namespace vitrine::jobs
