#include "ui/study/table_export.h"

#include "exhibits/framework/table/measured_table.h"
#include "exhibits/museum/museum.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/text.h"
#include "ui/kit/time_left.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/viewport/renderers.h"
#include "ui/viewport/viewport.h"

#include <QFileDialog>
#include <QProgressDialog>

#include <utility>

namespace vitrine::ui {

struct TableExport::Work {
    std::unique_ptr<TableMeasurement> table;
    std::unique_ptr<render::RenderBackend> backend = {};
};

void TableExport::ask(Workbench& window, QWidget* parent)
{
    const SceneObject& subject = window.museum().subject(window.chosen());
    const auto* source = capability<MeasuresTable>(subject);
    if (!source) {
        window.say(MessageStrip::Mood::notice,
                   tr("%1 has no table of measurements; the Study panel measures its parameters.")
                       .arg(translatedText(subject.title())));
        return;
    }
    auto* dialog =
        new QFileDialog(parent, translatedText(source->tableTitle()), QStringLiteral("methods.csv"), tr("CSV (*.csv)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    connect(dialog, &QFileDialog::fileSelected, parent,
            [&window, source, parent](const QString& path) { new TableExport(window, *source, path, parent); });
    dialog->open();
}

TableExport::TableExport(Workbench& window, const MeasuresTable& source, QString path, QWidget* parent)
    : QObject(parent), window_(window), path_(std::move(path)),
      shown_(new QProgressDialog(translatedText(source.tableTitle()), tr("Cancel"), 0, 1000, parent))
{
    shown_->setWindowTitle(QStringLiteral("Vitrine"));
    shown_->setMinimumDuration(0);
    shown_->setAutoClose(false);
    shown_->setAutoReset(false);
    shown_->setValue(0);
    connect(shown_, &QProgressDialog::canceled, this, &TableExport::cancel);
    elapsed_.start();
    auto work = std::make_shared<Work>();
    task_ = window.viewport().renderThread().start(
        [this, work, &source, values = window.history().sceneState().values[window.chosen()],
         &renderers = window.renderers()](const RenderThread::Notify& notify) {
            if (!work->table) {
                work->table = source.measureTable(values);
                work->backend = renderers.makeBackend(true);
                if (!work->backend)
                    throw Failure(ErrorKind::openGl, "Nothing can be measured: there is no graphics context.");
            }
            const bool more = work->table->step(*work->backend);
            notify([this, part = work->table->progress()] { note(part); });
            if (more) return true;
            work->backend.reset();
            notify([this, csv = QByteArray::fromStdString(work->table->csv())] { csv_ = csv; });
            return false;
        },
        [this](const QString& failure) { end(failure); });
}

TableExport::~TableExport()
{
    task_.cancel();
    delete shown_;
}

void TableExport::cancel()
{
    task_.cancel();
    window_.say(MessageStrip::Mood::notice, tr("Canceled; no table was written."));
    deleteLater();
}

void TableExport::note(double part)
{
    shown_->setValue(static_cast<int>(part * 1000));
    if (const double left = secondsLeft(part, elapsed_); left >= 0) shown_->setLabelText(timeLeft(left));
}

void TableExport::end(const QString& failure)
{
    QString why = failure;
    try {
        if (why.isEmpty()) render::atomicWrite(path_.toStdString(), csv_.toStdString());
    } catch (const std::exception& thrown) {
        why = messageOf(thrown);
    }
    if (why.isEmpty())
        window_.say(MessageStrip::Mood::notice, tr("Table saved to %1.").arg(path_), {}, {}, path_);
    else
        window_.say(MessageStrip::Mood::problem, why);
    deleteLater();
}

}  // namespace vitrine::ui

#include "moc_table_export.cpp"
