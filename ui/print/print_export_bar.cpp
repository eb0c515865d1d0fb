#include "ui/print/print_export_bar.h"

#include "render/image/picture_formats.h"
#include "ui/kit/file_patterns.h"
#include "ui/kit/replace_question.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPushButton>

#include <utility>

namespace vitrine::ui {
namespace {

/// Returns the path of this name in the folder, with a number if it is taken.
QString freePath(const QString& folder, const QString& name)
{
    const QString path = QDir(folder).filePath(name);
    return QFileInfo::exists(path) ? nextFreePath(path) : path;
}

/// Returns the files that may be written beside a print of this name.
QStringList besidePrint(const QString& path)
{
    const QFileInfo file(path);
    return {path + QStringLiteral(".json"),
            QStringLiteral("%1/%2-1.%3").arg(file.path(), file.completeBaseName(), file.suffix())};
}

}  // namespace

PrintExportBar::PrintExportBar(QWidget* parent)
    : ExportBar({tr("Output file of the print. Its settings are written inside and beside it."),
                 tr("Export lenticular print"), tr("Prints (%1)").arg(filePatterns(render::streamedEndings())),
                 QString()},
                parent),
      load_(addButton(tr("Load settings…"),
                      tr("From a print that Vitrine made, or a .json. Dropping one here works too.")))
{
    const QPushButton* save = addButton(tr("Save settings…"), tr("Everything that is set here, as JSON."));
    connect(load_, &QPushButton::clicked, this, [this] { askSettings(false); });
    connect(save, &QPushButton::clicked, this, [this] { askSettings(true); });
    connect(this, &ExportBar::goAsked, this, &PrintExportBar::askForPrint);
}

void PrintExportBar::suggest(const QString& folder)
{
    setPath(freePath(folder, QStringLiteral("lenticular-print.tif")));
    otherPath_ = freePath(folder, QStringLiteral("lenticular-chart.tif"));
}

void PrintExportBar::setChart(bool chart)
{
    if (chart == chart_) return;
    chart_ = chart;
    goButton().setText(chart ? tr("Export chart") : tr("Export"));
    const QString other = std::exchange(otherPath_, path());
    setPath(other);
}

void PrintExportBar::askForPrint()
{
    ask(besidePrint(path()));
}

void PrintExportBar::showPossible(bool exporting, bool possible)
{
    ExportBar::showPossible(exporting, possible);
    load_->setEnabled(!exporting);
}

void PrintExportBar::askSettings(bool save)
{
    auto* dialog = new QFileDialog(
        this, save ? tr("Save settings") : tr("Load settings"), QFileInfo(path()).absolutePath(),
        save ? tr("Settings (*.json)")
             : tr("Settings and prints (%1)").arg(filePatterns("json " + std::string(render::streamedEndings()))));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(save ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setDefaultSuffix(save ? QStringLiteral("vitrine-print.json") : QString());
    connect(dialog, &QFileDialog::fileSelected, this,
            save ? &PrintExportBar::settingsSaved : &PrintExportBar::settingsLoaded);
    dialog->open();
}

}  // namespace vitrine::ui

#include "moc_print_export_bar.cpp"
