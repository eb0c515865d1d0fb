#pragma once

#include "render/image/image.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::study {

/// Result of one measuring job: a picture, or times.
struct StudyMeasure {
    render::Image picture;
    std::map<std::string, std::int64_t> counters;
    std::vector<double> milliseconds;
    std::string clock;
    bool clockTrusted = false;
    double overheadMilliseconds = 0;
};

/// Storage for a study that is measured in parts by several processes.
class StudyParts {
public:
    virtual ~StudyParts() = default;
    /// Whether this is one part, which measures its share and judges nothing.
    [[nodiscard]] virtual bool isPart() const = 0;
    /// Returns whether the part does the measuring job with this number, counted through the study.
    [[nodiscard]] virtual bool makes(std::size_t number) const = 0;
    virtual void keep(const std::string& key, const StudyMeasure&) = 0;
    /// Returns what a part measured; nothing if none did, and then the study measures it.
    [[nodiscard]] virtual std::optional<StudyMeasure> find(const std::string& key) const = 0;
};

}  // namespace vitrine::study
