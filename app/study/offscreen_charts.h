#pragma once

#include <QByteArray>
#include <QSize>

#include <filesystem>

namespace vitrine::app {

/// Of charts in the folders of studies, pixels.
inline constexpr QSize studyChartSize(960, 540);
inline constexpr double studyChartScale = 1.5;  ///< Of the PNG, for sharp screens.

/// Qt then draws charts without a display, in light colors; there may be an application already.
void prepareOffscreenCharts();

/// Throws Failure (Blame::file) where a chart for this folder could not be drawn.
void requireChart(const QByteArray& png, const std::filesystem::path& folder);

}  // namespace vitrine::app
