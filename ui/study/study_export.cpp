#include "ui/study/study_export.h"

#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "ui/kit/language.h"
#include "ui/kit/picture_file.h"
#include "ui/study/log_chart.h"

#include <QFileDialog>
#include <QFileInfo>

namespace vitrine::ui {

namespace {

const QStringList& studySuffixes()
{
    static const QStringList all{QStringLiteral("csv"), QStringLiteral("json"), QStringLiteral("png"),
                                 QStringLiteral("svg"), QStringLiteral("pdf")};
    return all;
}

}  // namespace

QByteArray chartFile(const QString& suffix, LogChart& chart)
{
    if (suffix == QLatin1String("svg")) return chart.svg(exportedChart);
    if (suffix == QLatin1String("pdf")) return chart.pdf(exportedChart);
    return pngOf(chart.picture(exportedChart, 2));
}

QByteArray studyFile(const QString& suffix, Subjects subjects, const study::StudyRequest& request,
                     const study::StudyResult& result, const render::Json& machine, LogChart& chart)
{
    if (suffix == QLatin1String("csv")) return QByteArray::fromStdString(study::studyCsv(subjects, request, result));
    if (suffix == QLatin1String("json"))
        return QByteArray::fromStdString(render::writeJson(study::studyJson(subjects, request, result, machine)));
    return chartFile(suffix, chart);
}

QString askAndSaveStudy(QWidget* parent, const std::function<QByteArray(const QString& suffix)>& contentOf)
{
    const QString patterns = QStringLiteral("*.") + studySuffixes().join(QStringLiteral(" *."));
    const QString path =
        QFileDialog::getSaveFileName(parent, QObject::tr("Save the measurements"), QStringLiteral("study.csv"),
                                     QObject::tr("Tables and charts (%1)").arg(patterns));
    if (path.isEmpty()) return {};
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (!studySuffixes().contains(suffix))
        return QObject::tr("%1 was not saved: its name must end in %2.")
            .arg(path, QLatin1Char('.') + studySuffixes().join(QStringLiteral(", .")));
    try {
        render::atomicWrite(path.toStdString(), contentOf(suffix).toStdString());
        return {};
    } catch (const Failure& failure) {
        return translatedText(failure.message());
    }
}

}  // namespace vitrine::ui
