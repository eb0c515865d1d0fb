#pragma once

#include "exhibits/framework/preset_store.h"
#include "exhibits/museum/scene_state.h"
#include "ui/presets/preset_uses.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::ui {

class PresetList;
class Workbench;

/// What a preset, an exhibition, or a picture with one inside makes of the settings on show.
struct ReadSettings {
    SceneState sceneState;
    std::size_t exhibit = 0;  ///< Whose it is; of an exhibition the chosen one.
    QString name;             ///< For people.
    bool movesCamera = false;
    std::vector<std::string> notes;  ///< What reading changed, for people.
};

/// Presets on disk, for the exhibit whose parameters the panel shows: loads, saves, renames, duplicates, deletes. What
/// fails is said in the message strip, and everything stays as it was.
class PresetShelf final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive it.
    PresetShelf(Workbench&, PresetList&, PresetStore);

    /// Shows the presets of the table on show.
    void refresh();
    /// The values or the table on show changed: marks the preset in use.
    void mark();
    /// The picture is at rest: it becomes that of the preset in use, if this has none and shows its own look.
    void keepMissingThumbnail();
    /// "Old gold", with " *" when the look has left it since; empty when no preset is in use.
    [[nodiscard]] QString titleOfUse() const;

    /// What this file would make of the settings on show; nothing, and a message, where it cannot be read. Nothing
    /// changes.
    [[nodiscard]] std::optional<ReadSettings> settingsIn(const QString& path);
    /// The presets of the table on show, by name and the id that is their path; the visitor's own first.
    [[nodiscard]] std::vector<std::pair<QString, QString>> choices();
    /// The id of the preset that is selected in the list; empty: none.
    [[nodiscard]] QString selected() const;

    // What the actions do; those without an argument work on the preset selected in the list.
    void load(const QString& id);
    /// What the panel shows, to the preset in use, or under a new name where that is none of the visitor's own.
    void save();
    void saveAs();
    /// A name that is taken gets a number: no two presets of an exhibit have one name.
    void saveUnder(const QString& name);
    void rename();
    /// Asks for the tags of one of the visitor's own.
    void editTags();
    void duplicate();
    void remove();
    void importFile();
    void exportFile();
    void saveExhibition();

    /// A preset or exhibition from a file: shown, not copied.
    void loadFile(const QString& path);
    /// Returns false when the picture has no preset inside; true when it is shown, or what is wrong was said.
    bool loadFromPicture(const QString& path);

signals:
    /// Which preset is in use, or whether the look has left it, may have changed.
    void marked();

private:
    [[nodiscard]] ReadSettings read(const std::string& text, const QString& origin) const;
    void loadText(const std::string& text, const QString& origin);
    void show(const Preset&, std::size_t exhibit, const QString& step);
    void tell(const QString& origin, const std::vector<std::string>& notes);
    void keepThumbnail(const std::filesystem::path& preset);
    void trySafely(const std::function<void()>& work, const QString& cause = QStringLiteral("presets"));
    void renameTo(const QString& id, const QString& name);
    void setTags(const QString& id, const PresetTags&, std::size_t exhibit);
    void showFacts(const QString& id);
    [[nodiscard]] std::string exhibitName() const;
    [[nodiscard]] const Parameters& table() const;
    [[nodiscard]] Preset presetOnShow(const QString& name) const;
    /// What "Save" writes back, and what the list marks; null where none was loaded or saved.
    [[nodiscard]] const StoredPreset* inUse() const;
    void use(StoredPreset);
    [[nodiscard]] bool changedSince(const StoredPreset&) const;
    [[nodiscard]] QString freeName(const QString& wanted, const std::filesystem::path& exceptFor = {}) const;

    Workbench& window_;
    PresetList& list_;
    PresetStore store_;
    PresetUses uses_;
};

}  // namespace vitrine::ui
