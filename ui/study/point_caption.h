#pragma once

#include <QString>

#include <optional>
#include <string>

namespace vitrine::ui {

/// Measurements of a setting that its caption names.
struct PointNumbers {
    double error = 0;
    /// Milliseconds of one picture: the median and its interval.
    struct Time {
        double median, low, high;
    };
    std::optional<Time> time = {};
    std::optional<qlonglong> work = {};  ///< Count of the counter `workName`.
    std::string workName = {};
    std::optional<double> modelError = {};
};

/// Formats a number with three significant digits.
[[nodiscard]] QString threeDigits(double);
/// Returns the caption of a measured setting: "hit tolerance 4: error 0.02, 12 ms (11 to 13), 8,000 evaluations".
[[nodiscard]] QString pointCaption(const QString& setting, const PointNumbers&);

}  // namespace vitrine::ui
