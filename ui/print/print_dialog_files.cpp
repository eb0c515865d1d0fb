// Files that come to the print dialog and files that leave it.
#include "ui/print/print_dialog.h"

#include "exhibits/framework/save_bytes.h"
#include "exhibits/framework/state_folder.h"
#include "render/files/read_file.h"
#include "ui/print/shown_views.h"
#include "ui/kit/replace_question.h"

#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QUrl>

namespace vitrine::ui {
namespace {

constexpr std::uint64_t mostSettingsBytes = 4U << 20U;

std::filesystem::path rememberedPath()
{
    return configFolder() / "print.json";
}

QString placesPath()
{
    return QString::fromStdString((stateFolder() / "print.ini").string());
}

/// The name in that folder, or with a number, not taken yet.
QString freePath(const QString& folder, const QString& name)
{
    const QString path = QDir(folder).filePath(name);
    return QFileInfo::exists(path) ? nextFreePath(path) : path;
}

/// What a print of this name may be written to besides the file itself.
QStringList besidePrint(const QString& path)
{
    const QFileInfo file(path);
    return {path + QStringLiteral(".json"), QStringLiteral("%1/%2-1.%3").arg(file.path(), file.completeBaseName(), file.suffix())};
}

std::vector<std::string> textsOf(const QStringList& files)
{
    std::vector<std::string> texts;
    for (const QString& file : files) texts.push_back(file.toStdString());
    return texts;
}

}  // namespace

void PrintDialog::recall()
{
    const QSettings places(placesPath(), QSettings::IniFormat);
    restoreGeometry(places.value(QStringLiteral("geometry")).toByteArray());
    QString folder = places.value(QStringLiteral("folder")).toString();
    if (folder.isEmpty() || !QDir(folder).exists()) folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    path_->setText(freePath(folder, QStringLiteral("lenticular-print.tif")));
    otherPath_ = freePath(folder, QStringLiteral("lenticular-chart.tif"));
    std::error_code ignored;
    if (std::filesystem::exists(rememberedPath(), ignored)) {
        try {
            takeSettings(render::readFile(rememberedPath(), mostSettingsBytes), rememberedPath().string());
            return;
        } catch (const std::exception& failure) {
            say(MessageStrip::Mood::problem, QString::fromUtf8(failure.what()));
        }
    }
    setValues(desk_->parameters().initial());
}

void PrintDialog::remember()
{
    remembered_ = true;
    try {
        savePresetBytes(rememberedPath(), desk_->settingsText(*values_, textsOf(files_)));
        QSettings places(placesPath(), QSettings::IniFormat);
        places.setValue(QStringLiteral("geometry"), saveGeometry());
        places.setValue(QStringLiteral("folder"), QFileInfo(path_->text()).absolutePath());
    } catch (const std::exception& failure) {
        qWarning("%s", failure.what());  // The dialog is closing; nothing else depends on it.
    }
}

void PrintDialog::takeSettings(const std::string& text, const std::string& fileName)
{
    const PrintDesk::Settings settings = desk_->settingsFrom(text, fileName);
    for (const std::string& note : settings.notes) say(MessageStrip::Mood::notice, QString::fromStdString(note));
    files_.clear();
    for (const std::string& file : settings.sources) files_ << QString::fromStdString(file);
    values_.reset();  // So that the views are got anew.
    setValues(settings.values);
}

void PrintDialog::loadSettings(const QString& path)
{
    try {
        takeSettings(desk_->settingsIn(path.toStdString()), path.toStdString());
    } catch (const std::exception& failure) {
        if (!values_) setValues(desk_->parameters().initial());
        say(MessageStrip::Mood::problem, QString::fromUtf8(failure.what()));
    }
}

void PrintDialog::saveSettings(const QString& path)
{
    try {
        savePresetBytes(path.toStdString(), desk_->settingsText(*values_, textsOf(files_)));
        say(MessageStrip::Mood::notice, tr("Settings saved to %1.").arg(path));
    } catch (const std::exception& failure) {
        say(MessageStrip::Mood::problem, QString::fromUtf8(failure.what()));
    }
}

void PrintDialog::open(const QStringList& paths)
{
    if (paths.isEmpty() || exporting_) return;
    if (paths.size() == 1 && QFileInfo(paths.front()).isFile()) {
        const std::string path = paths.front().toStdString();
        try {
            takeSettings(desk_->settingsIn(path), path);
            return;
        } catch (const std::exception& failure) {
            if (QFileInfo(paths.front()).suffix().toLower() == QLatin1String("json")) {
                say(MessageStrip::Mood::problem, QString::fromUtf8(failure.what()));
                return;
            }
        }
        // No print: a picture like any other.
    }
    files_ = paths;
    if (chart_) setChart(false);
    if (desk_->origin(*values_) == ViewOrigin::shown) setValues(desk_->withOrigin(*values_, ViewOrigin::files));
    else getViews();
    refresh();
}

void PrintDialog::dragEnterEvent(QDragEnterEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) event->acceptProposedAction();
}

void PrintDialog::dropEvent(QDropEvent* event)
{
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    open(paths);
    event->acceptProposedAction();
}

void PrintDialog::browse()
{
    auto* dialog = new QFileDialog(this, tr("Export lenticular print"), path_->text(), tr("TIFF (*.tif);;PNG (*.png)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& chosen) {
        path_->setText(chosen);
        replaced_ = chosen;  // The dialog has asked.
    });
    dialog->open();
}

void PrintDialog::askSettings(bool save)
{
    auto* dialog = new QFileDialog(this, save ? tr("Save settings") : tr("Load settings"), QFileInfo(path_->text()).absolutePath(),
                                   save ? tr("Settings (*.json)") : tr("Settings and prints (*.json *.tif *.png)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(save ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setDefaultSuffix(save ? QStringLiteral("json") : QString());
    connect(dialog, &QFileDialog::fileSelected, this, save ? &PrintDialog::saveSettings : &PrintDialog::loadSettings);
    dialog->open();
}

void PrintDialog::startExport()
{
    if (exporting_) return;
    if (path_->text() == replaced_) begin(replaced_);
    else askBeforeReplacing(this, path_->text(), [this](const QString& path) { begin(path); }, besidePrint(path_->text()));
}

void PrintDialog::begin(const QString& path)
{
    if (exporting_) return;
    path_->setText(path);
    replaced_.clear();
    exporting_ = true;
    renderSoon_.stop();
    status_->setText(tr("Starting"));
    showButtons();
    if (chart_) write(nullptr);
    else if (desk_->origin(*values_) != ViewOrigin::shown || (views_ && !draft_)) write(views_);
    else live_->start(*desk_, *values_, false);
}

void PrintDialog::stopExport()
{
    if (!exporting_) return;
    if (write_.running()) {
        status_->setText(tr("Stopping"));
        write_.stop();
        return;
    }
    live_->stop();
    endExport(tr("Cancelled; no file was written."));
}

void PrintDialog::write(std::shared_ptr<const PrintViews> views)
{
    const std::filesystem::path path = path_->text().toStdString();
    write_.start([this, views = std::move(views), path, values = *values_, sources = textsOf(files_)](const PrintProgress& progress) -> ProgressJob::Outcome {
        const std::vector<std::filesystem::path> written = desk_->write(values, views, sources, path, progress);
        return [this, written] {
            const QString first = QString::fromStdString(written.front().string());
            path_->setText(nextFreePath(path_->text()));
            say(MessageStrip::Mood::notice, written.size() == 1 ? tr("Saved %1, and its settings beside it.").arg(first)
                                                                : tr("Saved %1 files, the first %2, and their settings beside them.").arg(written.size()).arg(first));
            endExport(QString());
        };
    });
}

void PrintDialog::endExport(const QString& words)
{
    exporting_ = false;
    progress_->setValue(0);
    status_->setText(words);
    showButtons();
    emit exportEnded(words.isEmpty());
}

void PrintDialog::reject()
{
    if (exporting_) stopExport();
    else QDialog::reject();
}

void PrintDialog::done(int result)
{
    if (live_) live_->stop();
    write_.stop();
    remember();
    QDialog::done(result);
}

}  // namespace vitrine::ui
