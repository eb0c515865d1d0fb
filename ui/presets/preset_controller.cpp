#include "ui/presets/preset_controller.h"

#include "exhibits/compare/differing_parameters.h"
#include "exhibits/framework/files/table_change.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "render/video/carried_settings.h"
#include "ui/kit/file_patterns.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/name_dialog.h"
#include "ui/kit/picture_file.h"
#include "ui/kit/text.h"
#include "ui/kit/tile_delegate.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/presets/preset_facts.h"
#include "ui/presets/preset_files.h"
#include "ui/presets/preset_list.h"
#include "ui/presets/recent_presets.h"
#include "ui/presets/scene_text.h"
#include "ui/presets/tags_dialog.h"
#include "ui/viewport/viewport.h"

#include <QUndoStack>

#include <algorithm>

namespace vitrine::ui {
PresetController::PresetController(Workbench& window, PresetList& list, PresetStore store)
    : QObject(&list), window_(window), list_(list), store_(std::move(store)), uses_(window.history().stack())
{
    connect(&list, &PresetList::loadAsked, this, &PresetController::load);
    // Queued, because a visit fills the list again, which is in the middle of a click.
    connect(&list, &PresetList::recentAsked, this, &PresetController::loadOfAny, Qt::QueuedConnection);
    connect(&list, &PresetList::renamed, this, &PresetController::renameTo);
    connect(&list, &PresetList::factsAsked, this, &PresetController::showFacts);
    connect(&window.history().stack(), &QUndoStack::indexChanged, this, [this] { uses_.prune(); });
    connect(&window.history(), &History::changesSettled, this, &PresetController::mark);
}

std::string PresetController::exhibitName() const
{
    return std::string(window_.museum().subject(window_.shown()).name());
}

const Parameters& PresetController::table() const
{
    return window_.museum().subject(window_.shown()).parameters();
}

void PresetController::trySafely(const std::function<void()>& work, const QString& cause)
{
    try {
        work();
        window_.setProblems(cause, {});
    } catch (const std::exception& failure) {
        window_.setProblems(cause, {});
        window_.setProblems(cause, {messageOf(failure)});
    }
}

void PresetController::showNotes(const QString& origin, const std::vector<std::string>& notes)
{
    if (notes.empty()) return;
    QStringList lines{tr("%1 was loaded, with changes:").arg(origin)};
    for (const std::string& note : notes) lines << words(note);
    window_.say(MessageStrip::Mood::notice, lines.join(QStringLiteral("\n    ")));
}

void PresetController::refresh()
{
    trySafely(
        [this] {
            std::vector<PresetLine> lines;
            for (const PresetEntry& entry : store_.list(exhibitName())) {
                PresetLine line{idOf(entry.path),
                                presetName(entry.name, entry.shipped),
                                entry.shipped,
                                words(entry.problem),
                                {},
                                presetTags(entry.tags, entry.shipped)};
                if (entry.thumbnail) line.thumbnail.load(idOf(*entry.thumbnail));
                lines.push_back(std::move(line));
            }
            // The visitor's own presets come first, because they are used most.
            std::stable_partition(lines.begin(), lines.end(), [](const PresetLine& line) { return !line.shipped; });
            list_.fill(lines);
            list_.setRecent(recentOfOthers());
        },
        QStringLiteral("list of presets"));
    mark();
}

std::vector<RecentPreset> PresetController::recentOfOthers() const
{
    std::vector<RecentPreset> recent;
    for (const QString& id : recentPresets()) {
        const std::optional<std::size_t> exhibit = exhibitOf(id);
        if (!exhibit || *exhibit == window_.shown()) continue;
        const SceneObject& subject = window_.museum().subject(*exhibit);
        for (const PresetEntry& entry : store_.list(subject.name()))
            if (idOf(entry.path) == id && entry.problem.empty())
                recent.push_back(
                    {id, tr("%1 – %2").arg(presetName(entry.name, entry.shipped), translatedText(subject.title()))});
    }
    return recent;
}

std::optional<std::size_t> PresetController::exhibitOf(const QString& id) const
{
    return window_.museum().find(pathOf(id).parent_path().filename().string());
}

const StoredPreset* PresetController::inUse() const
{
    return uses_.of(exhibitName());
}

void PresetController::use(StoredPreset stored)
{
    addRecentPreset(idOf(stored.path));
    uses_.add(std::move(stored));
    mark();
}

bool PresetController::changedSince(const StoredPreset& stored) const
{
    const ParameterValues& shown = window_.history().sceneState().values[window_.shown()];
    return !(withTableOf(shown, stored.preset.values) == shown);
}

void PresetController::mark()
{
    const StoredPreset* used = inUse();
    list_.setCurrent(used ? idOf(used->path) : QString(), used && changedSince(*used));
    emit marked();
}

QString PresetController::titleOfUse() const
{
    const StoredPreset* used = inUse();
    if (!used) return {};
    return presetName(used->preset.name, used->shipped) + (changedSince(*used) ? QStringLiteral(" *") : QString());
}

QString PresetController::freeName(const QString& wanted, const std::filesystem::path& exceptFor) const
{
    const std::vector<PresetEntry> all = store_.list(exhibitName());
    const auto taken = [&](const QString& name) {
        return std::any_of(all.begin(), all.end(), [&](const PresetEntry& entry) {
            return entry.path != exceptFor &&
                   presetName(entry.name, entry.shipped).compare(name, Qt::CaseInsensitive) == 0;
        });
    };
    QString name = wanted;
    for (int i = 2; taken(name); ++i) name = QStringLiteral("%1 %2").arg(wanted).arg(i);
    return name;
}

void PresetController::show(const Preset& preset, std::size_t exhibit, const QString& step)
{
    SceneState next = window_.history().sceneState();
    next.values[exhibit] = preset.values;
    const bool moves = preset.camera.has_value();
    if (moves) next.camera = *preset.camera;
    window_.history().change(step, next, 0, moves ? History::Camera::moves : History::Camera::stays);
}

void PresetController::load(const QString& id)
{
    trySafely([&] {
        StoredPreset loaded = store_.load(pathOf(id), exhibitName(), table());
        const QString name = presetName(loaded.preset.name, loaded.shipped);
        showNotes(name, loaded.preset.notes);
        show(loaded.preset, window_.shown(), tr("Load %1").arg(name));
        use(std::move(loaded));
    });
    mark();  // Restores the mark if the clicked preset could not be loaded.
}

void PresetController::loadOfAny(const QString& id)
{
    const std::optional<std::size_t> exhibit = exhibitOf(id);
    if (!exhibit) return;
    if (*exhibit != window_.shown()) emit visitAsked(*exhibit);
    load(id);
}

Preset PresetController::presetOnShow(const QString& name) const
{
    const SceneState& sceneState = window_.history().sceneState();
    return {exhibitName(),     name.toStdString(),     sceneState.values[window_.shown()],
            sceneState.camera, render::Json::object(), {}};
}

void PresetController::save()
{
    const StoredPreset* used = inUse();
    if (!used || used->shipped) {
        const QString name = freeName(proposedName());
        saveUnder(name);
        window_.say(MessageStrip::Mood::notice, tr("Saved as preset “%1”. F2 in the list renames it.").arg(name));
        return;
    }
    trySafely([this, used] {
        StoredPreset next = *used;
        const Preset now = presetOnShow(words(next.preset.name));
        next.preset.values = now.values;
        next.preset.camera = now.camera;
        if (store_.save(next) == SaveOutcome::changedOnDisk) {
            window_.say(MessageStrip::Mood::problem, tr("%1 was changed by another program since it was loaded and was "
                                                        "not overwritten. Save under another name, or load it again.")
                                                         .arg(idOf(next.path)));
            return;
        }
        keepThumbnail(next.path);
        window_.say(MessageStrip::Mood::notice, tr("Saved %1.").arg(idOf(next.path)));
        use(std::move(next));
    });
    refresh();
}

QString PresetController::proposedName() const
{
    const std::size_t shown = window_.shown();
    const StoredPreset* used = inUse();
    const QString title =
        used ? presetName(used->preset.name, used->shipped) : translatedText(window_.museum().subject(shown).title());
    const ParameterValues& values = window_.history().sceneState().values[shown];
    QStringList changed;
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const ParameterInfo& parameter = values.rows()[i];
        if (values.isInitial(i) || !(parameter.isNumeric() || parameter.kind == Kind::choice)) continue;
        changed << translatedText(label(parameter)) + QLatin1Char(' ') +
                       translatedText(compare::valueWithUnit(parameter, values.row(i)));
    }
    return !used && changed.size() == 1 ? changed.front() : title;
}

void PresetController::saveAs()
{
    const SceneObject& subject = window_.museum().subject(window_.shown());
    const QString title = translatedText(subject.title());
    const StoredPreset* used = inUse();
    const QString before = used ? presetName(used->preset.name, used->shipped) : title;
    auto* ask = new NameDialog(tr("Save preset of %1 as").arg(title), freeName(before), list_.window());
    // The name is for this exhibit, even if another one is chosen by then.
    connect(ask, &NameDialog::named, this, [this, shown = window_.shown()](const QString& name) {
        if (window_.shown() != shown) window_.choose(shown);
        saveUnder(name);
    });
    ask->openOver(list_);
}

void PresetController::saveUnder(const QString& name)
{
    if (name.trimmed().isEmpty()) return;
    trySafely([&] {
        const QString unique = freeName(name.trimmed());
        StoredPreset saved = store_.saveAs(presetOnShow(unique));
        keepThumbnail(saved.path);
        use(std::move(saved));
        if (unique != name.trimmed())
            window_.say(
                MessageStrip::Mood::notice,
                tr("A preset \"%1\" already exists; this one was saved as \"%2\".").arg(name.trimmed(), unique));
    });
    refresh();
}

void PresetController::keepThumbnail(const std::filesystem::path& preset)
{
    const QImage& picture = window_.viewport().pictures().shown().image();
    if (!picture.isNull()) saveThumbnail(idOf(PresetStore::thumbnailPath(preset)), previewOf(picture));
}

void PresetController::keepMissingThumbnail()
{
    if (!window_.viewport().pictures().schedule().still()) return;
    const StoredPreset* used = inUse();
    std::error_code ignored;
    if (!used || used->shipped || changedSince(*used) ||
        std::filesystem::exists(PresetStore::thumbnailPath(used->path), ignored))
        return;
    // If the visitor is not at the exhibit, the picture does not show the preset.
    const bool fromItsOwnView = used->preset.camera == window_.history().sceneState().camera;
    const bool before =
        window_.viewport().visitor().mode() == CameraControl::Mode::orbit && window_.chosen() == window_.shown();
    if (window_.shown() != hallIndex && !fromItsOwnView && !before) return;
    keepThumbnail(used->path);
    refresh();
}

void PresetController::rename()
{
    const QString id = list_.selected();
    if (id.isEmpty() || list_.startRename(id)) return;
    trySafely([&] {
        const StoredPreset stored = store_.load(pathOf(id), exhibitName(), table());
        window_.say(MessageStrip::Mood::notice,
                    tr("%1 is supplied with the exhibit and cannot be renamed. Duplicate it, and rename the copy.")
                        .arg(presetName(stored.preset.name, stored.shipped)));
    });
}

void PresetController::renameTo(const QString& id, const QString& name)
{
    trySafely([&] {
        if (name.trimmed().isEmpty()) return;
        const QString unique = freeName(name.trimmed(), pathOf(id));
        const std::filesystem::path path = store_.rename(pathOf(id), unique.toStdString());
        uses_.renamed(pathOf(id), store_.load(path, exhibitName(), table()));
        renameRecentPreset(id, idOf(path));
    });
    // Queued, because the list is still in the middle of an edit.
    QMetaObject::invokeMethod(this, &PresetController::refresh, Qt::QueuedConnection);
}

void PresetController::editTags()
{
    const QString id = list_.selected();
    if (id.isEmpty()) return;
    trySafely([&] {
        const StoredPreset stored = store_.load(pathOf(id), exhibitName(), table());
        if (stored.shipped) {
            window_.say(MessageStrip::Mood::notice,
                        tr("%1 is supplied with the exhibit and cannot be tagged. Duplicate it, and tag the copy.")
                            .arg(presetName(stored.preset.name, stored.shipped)));
            return;
        }
        QStringList tags;
        for (const std::string& tag : stored.preset.tags) tags << words(tag);
        auto* ask = new TagsDialog(words(stored.preset.name), tags, list_.tagsInUse(), list_.window());
        connect(ask, &TagsDialog::given, this,
                [this, id, before = stored.preset.tags, exhibit = window_.shown()](const QStringList& given) {
                    PresetTags after;
                    for (const QString& tag : given) after.push_back(tag.toStdString());
                    if (after == before) return;
                    window_.history().record(
                        tr("Tag a preset"), [this, id, after, exhibit] { setTags(id, after, exhibit); },
                        [this, id, before, exhibit] { setTags(id, before, exhibit); });
                });
        ask->openOver(list_);
    });
}

void PresetController::setTags(const QString& id, const PresetTags& tags, std::size_t exhibit)
{
    trySafely([&] {
        store_.setTags(pathOf(id), tags);
        const SceneObject& subject = window_.museum().subject(exhibit);
        // The preset in use takes the changed tags from the file.
        uses_.renamed(pathOf(id), store_.load(pathOf(id), subject.name(), subject.parameters()));
    });
    refresh();
}

void PresetController::showFacts(const QString& id)
{
    list_.showPreview(presetFacts(store_, pathOf(id), exhibitName(), table()));
}

void PresetController::duplicate()
{
    const QString id = list_.selected();
    if (id.isEmpty()) return;
    trySafely([&] {
        const StoredPreset original = store_.load(pathOf(id), exhibitName(), table());
        const QString name = presetName(original.preset.name, original.shipped);
        const std::filesystem::path copy =
            store_.duplicate(pathOf(id), freeName(tr("%1 copy").arg(name)).toStdString());
        // The copy is the visitor's own, so its tags are translated, as they are displayed.
        PresetTags tags;
        for (const QString& tag : presetTags(original.preset.tags, original.shipped)) tags.push_back(tag.toStdString());
        if (tags != original.preset.tags) store_.setTags(copy, tags);
    });
    refresh();
}

void PresetController::remove()
{
    const QString id = list_.selected();
    if (id.isEmpty()) return;
    trySafely([&] {
        // An undeletable file throws here, before there is an undo step.
        auto removed = std::make_shared<RemovedDocument>(store_.remove(pathOf(id)));
        auto first = std::make_shared<bool>(true);
        uses_.forget(pathOf(id));
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

void PresetController::importFile()
{
    QFileDialog* dialog = fileDialog(
        list_.window(), tr("Import preset"), QFileDialog::AcceptOpen,
        tr("Presets, and pictures with one inside (%1)").arg(filePatterns("json " + render::carriedSettingsEndings())));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        trySafely([&] {
            std::filesystem::path copy = store_.importFile(path.toStdString(), exhibitName(), table());
            // A picture is its own thumbnail. Other files get one once the screen shows the preset.
            if (const QImage picture(path); !picture.isNull())
                saveThumbnail(idOf(PresetStore::thumbnailPath(copy)), previewOf(picture));
            const QString name = QString::fromStdString(store_.load(copy, exhibitName(), table()).preset.name);
            if (const QString unique = freeName(name, copy); unique != name)
                copy = store_.rename(copy, unique.toStdString());
            refresh();
            load(QString::fromStdString(copy.string()));
            keepMissingThumbnail();  // The picture on the screen may already show the preset.
        });
    });
    dialog->open();
}

void PresetController::exportFile()
{
    const QString id = list_.selected();
    if (id.isEmpty()) {
        window_.say(MessageStrip::Mood::notice, tr("Nothing was exported: select a preset in the list first."));
        return;
    }
    QFileDialog* dialog =
        fileDialog(list_.window(), tr("Export preset"), QFileDialog::AcceptSave, tr("Presets (*.json)"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, id](const QString& target) {
        trySafely([&] { store_.exportFile(id.toStdString(), target.toStdString()); });
    });
    dialog->open();
}

void PresetController::saveExhibition()
{
    QFileDialog* dialog =
        fileDialog(list_.window(), tr("Save exhibition"), QFileDialog::AcceptSave, tr("Exhibitions (*.json)"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& target) {
        trySafely([&] {
            const std::string name = QFileInfo(target).completeBaseName().toStdString();
            render::atomicWrite(target.toStdString(),
                                textOf(window_.museum(), window_.history().sceneState(), window_.chosen(), name));
            window_.say(MessageStrip::Mood::notice, tr("Saved %1.").arg(target), {}, {}, target);
        });
    });
    dialog->open();
}

ReadSettings PresetController::read(const std::string& text, const QString& origin) const
{
    const PresetHeader header = presetHeader(render::parseJson(text, origin.toStdString(), presetLimits));
    ReadSettings result;
    if (header.isExhibition) {
        result.sceneState = lookFrom(window_.museum(), text, origin.toStdString(), result.notes, &result.exhibit);
        result.name = QFileInfo(origin).fileName();
        result.movesCamera = true;
        return result;
    }
    const std::optional<std::size_t> found = window_.museum().find(header.exhibit);
    if (!found)
        throw Failure(ErrorKind::file, origin.toStdString() + " is a preset of \"" + header.exhibit +
                                           "\", which is not in this museum.");
    const SceneObject& subject = window_.museum().subject(*found);
    Preset preset = parsePreset(text, origin.toStdString(), subject.name(), subject.parameters());
    result.sceneState = window_.history().sceneState();
    result.sceneState.values[*found] = preset.values;
    result.movesCamera = preset.camera.has_value();
    if (preset.camera) result.sceneState.camera = *preset.camera;
    result.exhibit = *found;
    result.name = words(preset.name);
    result.notes = std::move(preset.notes);
    return result;
}

void PresetController::loadText(const std::string& text, const QString& origin)
{
    const ReadSettings loaded = read(text, origin);
    showNotes(origin, loaded.notes);
    window_.choose(loaded.exhibit);
    window_.history().change(tr("Load %1").arg(loaded.name), loaded.sceneState, 0,
                             loaded.movesCamera ? History::Camera::moves : History::Camera::stays);
}

std::optional<ReadSettings> PresetController::settingsIn(const QString& path)
{
    std::optional<ReadSettings> result;
    trySafely([&] {
        const bool picture = QFileInfo(path).suffix().compare(QLatin1String("json"), Qt::CaseInsensitive) != 0;
        std::optional<std::string> text = picture ? render::carriedSettings(path.toStdString())
                                                  : render::readFile(path.toStdString(), presetLimits.bytes);
        if (!text)
            throw Failure(ErrorKind::file, path.toStdString() +
                                               ": this picture carries no preset; choose a preset file, "
                                               "or a picture that Vitrine made.");
        ReadSettings found = read(*text, path);
        showNotes(path, found.notes);
        result = std::move(found);
    });
    return result;
}

std::vector<std::pair<QString, QString>> PresetController::choices(std::size_t exhibit)
{
    std::vector<std::pair<QString, QString>> all;
    trySafely([&] {
        std::vector<PresetEntry> entries = store_.list(window_.museum().subject(exhibit).name());
        std::stable_partition(entries.begin(), entries.end(), [](const PresetEntry& entry) { return !entry.shipped; });
        for (const PresetEntry& entry : entries)
            if (entry.problem.empty()) all.emplace_back(presetName(entry.name, entry.shipped), idOf(entry.path));
    });
    return all;
}

QString PresetController::selected() const
{
    return list_.selected();
}

void PresetController::loadFile(const QString& path)
{
    trySafely([&] { loadText(render::readFile(path.toStdString(), presetLimits.bytes), path); }, openingOf(path));
}

bool PresetController::loadFromPicture(const QString& path)
{
    bool done = true;
    trySafely(
        [&] {
            const std::optional<std::string> text = render::carriedSettings(path.toStdString());
            done = text.has_value();
            if (text) loadText(*text, path);
        },
        openingOf(path));
    return done;
}

}  // namespace vitrine::ui

#include "moc_preset_controller.cpp"
