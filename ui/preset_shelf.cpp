#include "ui/preset_shelf.h"

#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "ui/look_text.h"
#include "ui/main_window.h"
#include "ui/preset_list.h"
#include "ui/viewport.h"

#include <QInputDialog>

namespace vitrine::ui {
namespace {

std::filesystem::path pathOf(const QString& id)
{
    return id.toStdString();
}

QString idOf(const std::filesystem::path& path)
{
    return QString::fromStdString(path.string());
}

QString words(const std::string& s)
{
    return QString::fromStdString(s);
}

}  // namespace

PresetShelf::PresetShelf(MainWindow& window, PresetList& list, PresetStore store)
    : QObject(&window), window_(window), list_(list), store_(std::move(store))
{
    connect(&list, &PresetList::loadAsked, this, &PresetShelf::load);
    connect(&list, &PresetList::renamed, this, &PresetShelf::renameTo);
}

std::string PresetShelf::exhibitName() const
{
    return std::string(window_.gallery().exhibits()[window_.chosen()]->name());
}

const Parameters& PresetShelf::table() const
{
    return window_.gallery().exhibits()[window_.chosen()]->parameters();
}

void PresetShelf::trySafely(const std::function<void()>& work)
{
    try {
        work();
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, QString::fromUtf8(failure.what()));
    }
}

void PresetShelf::tell(const QString& origin, const std::vector<std::string>& notes)
{
    if (notes.empty()) return;
    QStringList lines{tr("%1 was loaded, with changes:").arg(origin)};
    for (const std::string& note : notes) lines << words(note);
    window_.say(MessageStrip::Mood::notice, lines.join(QStringLiteral("\n    ")));
}

void PresetShelf::refresh()
{
    if (inUse_ && inUse_->preset.exhibit != exhibitName()) inUse_.reset();
    trySafely([this] {
        std::vector<PresetLine> lines;
        for (const PresetEntry& entry : store_.list(exhibitName())) {
            PresetLine line{idOf(entry.path), words(entry.name), entry.shipped, words(entry.problem), {}};
            if (entry.thumbnail) line.thumbnail.load(idOf(*entry.thumbnail));
            lines.push_back(std::move(line));
        }
        list_.fill(lines);
    });
    list_.setCurrent(inUse_ ? idOf(inUse_->path) : QString());
}

void PresetShelf::show(const Preset& preset, std::size_t exhibit, const QString& step)
{
    Look next = window_.history().look();
    next.values[exhibit] = preset.values;
    const bool moves = preset.camera.has_value();
    if (moves) next.camera = *preset.camera;
    window_.history().change(step, std::move(next), 0, moves ? History::Camera::moves : History::Camera::stays);
}

void PresetShelf::load(const QString& id)
{
    trySafely([&] {
        StoredPreset loaded = store_.load(pathOf(id), exhibitName(), table());
        tell(words(loaded.preset.name), loaded.preset.notes);
        show(loaded.preset, window_.chosen(), tr("Load %1").arg(words(loaded.preset.name)));
        inUse_ = std::move(loaded);
    });
    list_.setCurrent(inUse_ ? idOf(inUse_->path) : QString());
}

Preset PresetShelf::presetOnShow(const QString& name) const
{
    const Look& look = window_.history().look();
    return {
        exhibitName(), name.toStdString(), look.values[window_.chosen()], look.camera, presetVersion, render::Json::object(), {}};
}

void PresetShelf::save()
{
    if (!inUse_ || inUse_->shipped) {
        saveAs();
        return;
    }
    trySafely([this] {
        const Preset now = presetOnShow(words(inUse_->preset.name));
        inUse_->preset.values = now.values;
        inUse_->preset.camera = now.camera;
        if (store_.save(*inUse_) == SaveOutcome::changedOnDisk) {
            window_.say(MessageStrip::Mood::problem, tr("%1 was changed by someone else since it was loaded, and was "
                                                        "not overwritten. Save under another name, or load it again.")
                                                         .arg(idOf(inUse_->path)));
            return;
        }
        keepThumbnail(inUse_->path);
        window_.say(MessageStrip::Mood::notice, tr("Saved %1.").arg(idOf(inUse_->path)));
    });
    refresh();
}

void PresetShelf::saveAs()
{
    auto* ask = new QInputDialog(&window_);
    ask->setAttribute(Qt::WA_DeleteOnClose);
    ask->setWindowTitle(tr("Save preset as"));
    ask->setLabelText(tr("Name"));
    ask->setTextValue(inUse_ && !inUse_->shipped ? tr("%1 copy").arg(words(inUse_->preset.name)) : QString());
    connect(ask, &QInputDialog::textValueSelected, this, &PresetShelf::saveUnder);
    ask->show();
}

void PresetShelf::saveUnder(const QString& name)
{
    if (name.trimmed().isEmpty()) return;
    trySafely([&] {
        inUse_ = store_.saveAs(presetOnShow(name.trimmed()));
        keepThumbnail(inUse_->path);
    });
    refresh();
}

void PresetShelf::keepThumbnail(const std::filesystem::path& preset)
{
    const QImage picture = window_.viewport().grabFramebuffer();
    if (!picture.isNull()) MainWindow::thumbnailOf(picture).save(idOf(PresetStore::thumbnailPath(preset)), "PNG");
}

void PresetShelf::rename()
{
    list_.startRename(list_.selected());
}

void PresetShelf::renameTo(const QString& id, const QString& name)
{
    trySafely([&] {
        if (name.trimmed().isEmpty()) return;
        const std::filesystem::path path = store_.rename(pathOf(id), name.trimmed().toStdString());
        if (inUse_ && idOf(inUse_->path) == id) inUse_ = store_.load(path, exhibitName(), table());
    });
    // The list is in the middle of an edit.
    QMetaObject::invokeMethod(this, &PresetShelf::refresh, Qt::QueuedConnection);
}

void PresetShelf::duplicate()
{
    const QString id = list_.selected();
    if (id.isEmpty()) return;
    trySafely([&] {
        const StoredPreset original = store_.load(pathOf(id), exhibitName(), table());
        store_.duplicate(pathOf(id), tr("%1 copy").arg(words(original.preset.name)).toStdString());
    });
    refresh();
}

void PresetShelf::remove()
{
    const QString id = list_.selected();
    if (id.isEmpty()) return;
    trySafely([&] {
        // Fails here, before there is a step to undo, when the file may not be deleted.
        auto removed = std::make_shared<RemovedPreset>(store_.remove(pathOf(id)));
        auto first = std::make_shared<bool>(true);
        if (inUse_ && idOf(inUse_->path) == id) inUse_.reset();
        window_.history().record(
            tr("Delete %1").arg(idOf(removed->original.stem())),
            [this, removed, first] {
                if (!std::exchange(*first, false)) trySafely([&] { *removed = store_.remove(removed->original); });
                refresh();
            },
            [this, removed] {
                trySafely([&] { removed->original = store_.restore(*removed); });
                refresh();
            });
    });
}

void PresetShelf::loadText(const std::string& text, const QString& origin)
{
    const PresetHeader header = presetHeader(render::parseJson(text, origin.toStdString(), presetLimits));
    if (header.isExhibition) {
        std::vector<std::string> notes;
        Look look = lookFrom(window_.gallery(), text, origin.toStdString(), notes);
        tell(origin, notes);
        window_.history().change(tr("Load %1").arg(origin), std::move(look), 0, History::Camera::moves);
        return;
    }
    for (std::size_t i = 0; i < window_.gallery().exhibits().size(); ++i) {
        const Exhibit& exhibit = *window_.gallery().exhibits()[i];
        if (exhibit.name() != header.exhibit) continue;
        const Preset preset = parsePreset(text, origin.toStdString(), exhibit.name(), exhibit.parameters());
        tell(origin, preset.notes);
        window_.choose(i);
        show(preset, i, tr("Load %1").arg(words(preset.name)));
        return;
    }
    throw Failure(Blame::file, origin.toStdString() + " is a preset of \"" + header.exhibit + "\", which is not in this museum.");
}

void PresetShelf::loadFile(const QString& path)
{
    trySafely([&] { loadText(render::readFile(path.toStdString(), presetLimits.bytes), path); });
}

bool PresetShelf::loadFromPicture(const QString& path)
{
    bool done = true;
    trySafely([&] {
        const std::optional<std::string> text = render::embeddedPreset(path.toStdString());
        done = text.has_value();
        if (text) loadText(*text, path);
    });
    return done;
}

std::string PresetShelf::lookText() const
{
    return textOf(window_.gallery(), window_.history().look(), "Picture");
}

}  // namespace vitrine::ui

#include "moc_preset_shelf.cpp"
