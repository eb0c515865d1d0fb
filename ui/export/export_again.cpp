#include "ui/export/export_again.h"

#include "ui/kit/replace_question.h"
#include "ui/model/workbench.h"

namespace vitrine::ui {

ExportAgain::ExportAgain(Workbench& window, QObject& parent) : QObject(&parent), window_(window) {}

void ExportAgain::note(const ExportRequest& exportRequest)
{
    last_ = exportRequest;
    emit noted();
}

void ExportAgain::run()
{
    if (!last_) return;
    // The path must also differ from that of an export in progress.
    QString path = nextFreePath(QString::fromStdString(last_->path.string()));
    const auto promised = [&] {
        for (const PictureExport* other : parent()->findChildren<PictureExport*>())
            if (other->running() && QString::fromStdString(other->path().string()) == path) return true;
        return false;
    };
    while (promised()) path = nextFreePath(path);
    last_->path = path.toStdString();
    auto* work = new PictureExport(window_, *last_, parent());
    connect(work, &PictureExport::finished, this, [this](const QString& written) {
        window_.say(MessageStrip::Mood::notice, tr("Picture saved to %1.").arg(written),
                    tr("%1 pictures saved, the last one to %2."), written, written);
    });
    connect(work, &PictureExport::failed, this,
            [this](const QString& why) { window_.say(MessageStrip::Mood::problem, why); });
    work->start();
}

}  // namespace vitrine::ui

#include "moc_export_again.cpp"
