// Presets that come from and go to places of the visitor's choice.
#include "ui/presets/preset_shelf.h"

#include "render/files/atomic_write.h"
#include "ui/presets/look_text.h"
#include "ui/presets/preset_list.h"
#include "ui/window/main_window.h"

#include <QFileDialog>

namespace vitrine::ui {
namespace {

QFileDialog* fileDialog(QWidget* window, const QString& title, QFileDialog::AcceptMode mode, const QString& filter)
{
    auto* dialog = new QFileDialog(window, title);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(mode);
    dialog->setFileMode(mode == QFileDialog::AcceptOpen ? QFileDialog::ExistingFile : QFileDialog::AnyFile);
    dialog->setNameFilter(filter);
    if (mode == QFileDialog::AcceptSave) dialog->setDefaultSuffix(QStringLiteral("json"));
    return dialog;
}

}  // namespace

void PresetShelf::importFile()
{
    QFileDialog* dialog = fileDialog(&window_, tr("Import preset"), QFileDialog::AcceptOpen,
                                     tr("Presets, and pictures with one inside (*.json *.png *.exr)"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        trySafely([&] {
            std::filesystem::path copy = store_.importFile(path.toStdString(), exhibitName(), table());
            // A picture shows itself what is in it; the others get theirs once what they look like is on the screen.
            if (const QImage picture(path); !picture.isNull())
                MainWindow::thumbnailOf(picture).save(QString::fromStdString(PresetStore::thumbnailPath(copy).string()), "PNG");
            const QString name = QString::fromStdString(store_.load(copy, exhibitName(), table()).preset.name);
            if (const QString unique = freeName(name, copy); unique != name) copy = store_.rename(copy, unique.toStdString());
            refresh();
            load(QString::fromStdString(copy.string()));
            keepMissingThumbnail();  // Where the picture shows it already.
        });
    });
    dialog->open();
}

void PresetShelf::exportFile()
{
    const QString id = list_.selected();
    if (id.isEmpty()) {
        window_.say(MessageStrip::Mood::notice, tr("Nothing was exported: select a preset in the list first."));
        return;
    }
    QFileDialog* dialog = fileDialog(&window_, tr("Export preset"), QFileDialog::AcceptSave, tr("Presets (*.json)"));
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, id](const QString& target) { trySafely([&] { store_.exportFile(id.toStdString(), target.toStdString()); }); });
    dialog->open();
}

void PresetShelf::saveExhibition()
{
    QFileDialog* dialog = fileDialog(&window_, tr("Save exhibition"), QFileDialog::AcceptSave, tr("Exhibitions (*.json)"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& target) {
        trySafely([&] {
            const std::string name = QFileInfo(target).completeBaseName().toStdString();
            render::atomicWrite(target.toStdString(), textOf(window_.gallery(), window_.history().look(), window_.chosen(), name));
            window_.say(MessageStrip::Mood::notice, tr("Saved %1.").arg(target));
        });
    });
    dialog->open();
}

}  // namespace vitrine::ui
