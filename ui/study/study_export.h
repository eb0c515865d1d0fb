#pragma once

#include "exhibits/study/study_result.h"
#include "render/files/strict_json.h"

#include <QByteArray>
#include <QString>

#include <functional>

class QWidget;

namespace vitrine::ui {

class StudyChart;

/// What was measured, as a file that ends in "csv" or "json", which has `machine` in it; or the chart, in "svg" or
/// "png".
[[nodiscard]] QByteArray studyFile(const QString& suffix, Subjects, const StudyRequest&, const StudyResult&,
                                   const render::Json& machine, StudyChart&);

/// Asks for a file name and writes what `contentOf` makes for its ending. Returns why it could not be saved, for
/// people; empty otherwise, and where the visitor thought better of it.
[[nodiscard]] QString askAndSaveStudy(QWidget* parent,
                                      const std::function<QByteArray(const QString& suffix)>& contentOf);

}  // namespace vitrine::ui
