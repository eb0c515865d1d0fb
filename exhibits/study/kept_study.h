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

namespace vitrine {

/// What a file of studies may be at most.
inline constexpr render::JsonLimits studyLimits{
    .bytes = 16U << 20U, .depth = 24, .nodes = 1'000'000, .stringBytes = 1U << 16U};

/// Value of one parameter of a setting, for people.
struct SettingPart {
    std::string label;  ///< As the interface shows the parameter: "Shell count".
    std::string value;  ///< With its unit: "16", "on", "0.5 m".
};

/// One setting of a study that was read from a file.
struct KeptPoint {
    std::vector<render::Json> values;  ///< By parameter, as the file has them: in SI, choices by name.
    double error = 0;                  ///< Over all views; infinite where the file has none.
    double lowestError = 0, worstError = 0;
    std::optional<double> modelError;  ///< Against everything exact; unset where it was not measured.
    double cost = 0;                   ///< By `KeptStudy::cost`; 0 where it was not measured.
    bool uncertain = false;
    std::map<std::string, double> counters;  ///< Over all views.
    struct Time {
        double median = 0, spread = 0;
        render::Interval interval;  ///< Of the median.
        std::size_t runs = 0;
    };
    std::optional<Time> time;  ///< Milliseconds of one picture.

    [[nodiscard]] bool measured() const;
};

/// A study as its file has it: numbers and names, whatever exhibits and rows this program knows.
struct KeptStudy {
    std::string name;      ///< That somebody gave it; empty: none.
    std::string measured;  ///< When, as "2026-11-25T01:43:23"; empty: the file does not say.
    bool complete = true;  ///< It was not stopped before it had measured everything.
    std::string exhibit;
    struct Parameter {
        std::string name;        ///< "steps", or "hall.shadowMapSize".
        std::string label = {};  ///< "Steps"; empty: the file does not say.
        std::string unit;        ///< Of numbers in SI; may be empty.
    };
    std::vector<Parameter> parameters;
    glm::ivec2 size{0};  ///< Pixels.
    bool alone = false;
    std::vector<std::string> views;
    render::Metric metric = render::Metric::rmse;
    std::string cost;  ///< "ms", or the counter that its own front goes by.
    std::string clock;
    bool clockTrusted = false;
    std::string renderer;  ///< Of the machine; empty: the file does not say.
    int processors = 0;    ///< Likewise; 0: the file does not say.
    std::vector<std::size_t> front;
    std::optional<std::size_t> knee;
    std::vector<std::string> sentences;  ///< What was chosen, and how sure the reference is.
    std::vector<KeptPoint> points;

    /// "steps 64, method fair".
    [[nodiscard]] std::string pointText(std::size_t point) const;
    /// The same by the labels of the interface, where the file has them.
    [[nodiscard]] std::vector<SettingPart> settingParts(std::size_t point) const;
    /// "Steps", "Steps and Method", or "all parameters".
    [[nodiscard]] std::string parameterNames() const;
    [[nodiscard]] std::size_t measuredPoints() const;
};

/// Reads what `studyJson` writes, with "name", "measured" and "complete" beside it where it was kept. Keys that are not
/// known do not matter. Throws Failure naming file, line and key for whatever is missing, of a wrong type, not finite,
/// out of range or beyond `studyLimits`.
[[nodiscard]] KeptStudy parseStudy(const render::JsonDocument&);
/// The same of a file.
[[nodiscard]] KeptStudy readStudy(const std::filesystem::path&);

/// A study beside the JSON that it was read from.
struct StudyAndJson {
    KeptStudy study;
    render::Json json;
};
/// Reads a file of one study, or of several: {"format": "vitrine-studies", "version": 1, "studies": [...]}. Throws
/// Failure as `parseStudy`.
[[nodiscard]] std::vector<StudyAndJson> parseStudies(const render::JsonDocument&);
/// Such a file of several.
[[nodiscard]] render::Json studiesJson(const std::vector<render::Json>& studies);

/// The same study with a name that somebody gave it, at most 200 bytes of it; an empty one takes it away.
[[nodiscard]] render::Json named(render::Json study, const std::string& name);

/// One line per point of each, with the counters that any of them has.
[[nodiscard]] std::string keptCsv(const std::vector<KeptStudy>&);

}  // namespace vitrine
