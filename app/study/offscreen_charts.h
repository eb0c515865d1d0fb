#pragma once

#include <QByteArray>

#include <filesystem>

namespace vitrine::app {

/// Qt then draws charts without a display, in light colors; there may be an application already.
void prepareOffscreenCharts();

/// Throws Failure (Blame::file) where a chart for this folder could not be drawn.
void requireChart(const QByteArray& png, const std::filesystem::path& folder);

}  // namespace vitrine::app
