#pragma once

#include "render/files/strict_json.h"
#include "render/measure/metrics.h"
#include "render/measure/statistics.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::study {

/// Limits of a file of studies.
inline constexpr render::JsonLimits studyLimits{
    .bytes = 16U << 20U, .depth = 24, .nodes = 1'000'000, .stringBytes = 1U << 16U};

/// Value of one parameter of a setting, as displayed.
struct SettingPart {
    std::string label;  ///< Label of the parameter in the interface: "Shell count".
    std::string value;  ///< Value with its unit: "16", "on", "0.5 m".
};

/// One setting of a study that was read from a file.
struct KeptPoint {
    std::vector<render::Json> values;  ///< Values of the parameters, as in the file: in SI units, choices by name.
    double error = 0;                  ///< Error over all views; infinite if the file has none.
    double lowestError = 0, worstError = 0;
    std::optional<double> modelError;  ///< Error relative to everything exact; unset if not measured.
    double cost = 0;                   ///< In the unit `KeptStudy::cost`; 0 if not measured.
    bool uncertain = false;
    std::map<std::string, double> counters;  ///< Counters, summed over all views.
    struct Time {
        double median = 0, spread = 0;
        render::Interval interval;  ///< Confidence interval of the median.
        std::size_t runs = 0;
    };
    std::optional<Time> time;  ///< Milliseconds of one picture.

    [[nodiscard]] bool measured() const;
};

/// A study as its file contains it: numbers and names, independent of the exhibits and parameters of this program.
struct KeptStudy {
    std::string name;      ///< Name that the user gave it; empty: none.
    std::string measured;  ///< Local time, as "2026-11-25T01:43:23"; empty if the file does not say.
    bool complete = true;  ///< Whether everything was measured before the study stopped.
    std::string exhibit;
    struct Parameter {
        std::string name;        ///< "steps", or "hall.shadowMapSize".
        std::string label = {};  ///< "Steps"; empty if the file does not say.
        std::string unit;        ///< Unit of the SI numbers; may be empty.
    };
    std::vector<Parameter> parameters;
    glm::ivec2 size{0};  ///< Pixels.
    bool alone = false;
    std::vector<std::string> views;
    render::Metric metric = render::Metric::rmse;
    std::string cost;  ///< "ms", or the counter on which the study's own front is based.
    std::string clock;
    bool clockTrusted = false;
    std::string renderer;  ///< Renderer of the machine; empty if the file does not say.
    int processors = 0;    ///< Processors of the machine; 0 if the file does not say.
    std::vector<std::size_t> front;
    std::optional<std::size_t> knee;
    std::vector<std::string> sentences;  ///< Choice, and certainty of the reference.
    std::vector<KeptPoint> points;

    /// Returns a setting as text: "steps 64, method fair".
    [[nodiscard]] std::string pointText(std::size_t point) const;
    /// Returns a setting by the labels of the interface, if the file has them.
    [[nodiscard]] std::vector<SettingPart> settingParts(std::size_t point) const;
    /// Returns "Steps", "Steps and Method", or "all parameters".
    [[nodiscard]] std::string parameterNames() const;
    [[nodiscard]] std::size_t measuredPoints() const;
};

/// Reads what `studyJson` writes, with "name", "measured" and "complete" added if it was kept. Unknown keys are
/// ignored. Throws Failure naming file, line and key for a value that is missing, of a wrong type, not finite, out of
/// range or beyond `studyLimits`.
[[nodiscard]] KeptStudy parseStudy(const render::JsonDocument&);
/// The same for a file.
[[nodiscard]] KeptStudy readStudy(const std::filesystem::path&);

/// A study, and the JSON from which it was read.
struct StudyAndJson {
    KeptStudy study;
    render::Json json;
};
/// Reads a file of one study, or of several: {"format": "vitrine-studies", "version": 1, "studies": [...]}. Throws
/// Failure as `parseStudy`.
[[nodiscard]] std::vector<StudyAndJson> parseStudies(const render::JsonDocument&);
/// Returns the JSON of a file of several studies.
[[nodiscard]] render::Json studiesJson(const std::vector<render::Json>& studies);

/// Returns the study with a name, truncated to 200 bytes. An empty name removes it.
[[nodiscard]] render::Json named(render::Json study, const std::string& name);

/// Returns CSV with one line per point of each study, and a column per counter that any point has.
[[nodiscard]] std::string keptCsv(const std::vector<KeptStudy>&);

}  // namespace vitrine::study
