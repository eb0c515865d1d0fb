#include "ui/viewport/reading_notice.h"

#include "ui/viewport/overlay.h"

#include <QFileInfo>
#include <QLocale>

#include <utility>

namespace vitrine::ui {
namespace {

constexpr int lookEvery = 250;  // Milliseconds between polls. Files that are read sooner get no notice.

}  // namespace

ReadingNotice::ReadingNotice(QWidget* viewport, std::function<std::vector<render::PendingAsset>()> pending)
    : QObject(viewport), pending_(std::move(pending)), words_(new Overlay(Overlay::Place::top, viewport))
{
    timer_.setInterval(lookEvery);
    connect(&timer_, &QTimer::timeout, this, &ReadingNotice::look);
}

void ReadingNotice::start()
{
    if (timer_.isActive()) return;
    since_.start();
    timer_.start();
}

void ReadingNotice::place()
{
    words_->place();
}

void ReadingNotice::look()
{
    const std::vector<render::PendingAsset> pending = pending_();
    if (pending.empty()) timer_.stop();
    QStringList files;
    qint64 bytes = 0;
    for (const render::PendingAsset& asset : pending) {
        const QFileInfo file(QString::fromStdString(asset.path));
        if (asset.path.empty() || files.contains(file.fileName())) continue;
        files << file.fileName();
        bytes += file.isFile() ? file.size() : 0;
    }
    if (files.isEmpty()) return words_->say({});
    const QString size =
        bytes > 0
            ? QStringLiteral(" (%1)").arg(QLocale().formattedDataSize(bytes, 0, QLocale::DataSizeTraditionalFormat))
            : QString();
    words_->say(tr("Reading %1%2 … %3 s").arg(files.join(tr(", ")), size).arg((since_.elapsed() + 500) / 1000));
}

}  // namespace vitrine::ui

#include "moc_reading_notice.cpp"
