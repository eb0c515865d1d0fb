#pragma once

#include "exhibits/study/study_result.h"
#include "render/files/strict_json.h"

#include <QByteArray>
#include <QString>

#include <functional>

class QWidget;

namespace vitrine::ui {

class LogChart;

/// Returns the content of a file with a chart: "svg", "pdf", or any other suffix for "png".
[[nodiscard]] QByteArray chartFile(const QString& suffix, LogChart&);

/// Returns the content of a file with a study: the data as "csv" or "json" (including `machine`), or the chart.
[[nodiscard]] QByteArray studyFile(const QString& suffix, Subjects, const study::StudyRequest&,
                                   const study::StudyResult&, const render::Json& machine, LogChart&);

/// Asks for a file name and writes the result of `contentOf` for its suffix. Returns a sentence why saving failed;
/// empty after success or if the visitor canceled.
[[nodiscard]] QString askAndSaveStudy(QWidget* parent,
                                      const std::function<QByteArray(const QString& suffix)>& contentOf);

}  // namespace vitrine::ui
