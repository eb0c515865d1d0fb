#pragma once

#include <QByteArray>
#include <QSize>

#include <filesystem>

namespace vitrine::app {

/// Size of charts in the folders of studies, in pixels.
inline constexpr QSize studyChartSize(960, 540);
inline constexpr double studyChartScale = 1.5;  ///< Scale of the PNG, for high-resolution screens.

/// Prepares Qt for drawing charts without a display, in light colors. An application may already exist.
void prepareOffscreenCharts();

/// Throws Failure (ErrorKind::file) if a chart for this folder could not be drawn.
void requireChart(const QByteArray& png, const std::filesystem::path& folder);

}  // namespace vitrine::app
