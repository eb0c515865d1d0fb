#include "ui/study/study_export.h"

#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "ui/kit/language.h"
#include "ui/kit/picture_file.h"
#include "ui/study/study_chart.h"

#include <QFileDialog>
#include <QFileInfo>

namespace vitrine::ui {

QByteArray studyFile(const QString& suffix, Subjects subjects, const StudyRequest& request, const StudyResult& result,
                     const render::Json& machine, StudyChart& chart)
{
    if (suffix == QLatin1String("csv")) return QByteArray::fromStdString(studyCsv(subjects, request, result));
    if (suffix == QLatin1String("json"))
        return QByteArray::fromStdString(render::writeJson(studyJson(subjects, request, result, machine)));
    return suffix == QLatin1String("svg") ? chart.svg(exportedChart) : pngOf(chart.picture(exportedChart, 2));
}

QString askAndSaveStudy(QWidget* parent, const std::function<QByteArray(const QString& suffix)>& contentOf)
{
    const QString path =
        QFileDialog::getSaveFileName(parent, QObject::tr("Save the measurements"), QStringLiteral("study.csv"),
                                     QObject::tr("Tables and charts (*.csv *.json *.png *.svg)"));
    if (path.isEmpty()) return {};
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (!QStringList{"csv", "json", "png", "svg"}.contains(suffix))
        return QObject::tr("%1 was not saved: its name must end in .csv, .json, .png or .svg.").arg(path);
    try {
        render::atomicWrite(path.toStdString(), contentOf(suffix).toStdString());
        return {};
    } catch (const Failure& failure) {
        return translatedText(failure.message());
    }
}

}  // namespace vitrine::ui
