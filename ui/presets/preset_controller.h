#pragma once

#include "exhibits/framework/files/preset_store.h"
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
struct RecentPreset;

/// Scene state read from a preset, an exhibition, or a picture with one inside, applied to the present one.
struct ReadSettings {
    SceneState sceneState;
    std::size_t exhibit = 0;  ///< Exhibit of the preset, or the one chosen in the exhibition.
    QString name;             ///< Name for people.
    bool movesCamera = false;
    std::vector<std::string> notes;  ///< Sentences on values that were corrected while reading.
};

/// Presets on disk of the exhibit whose parameters the panel shows: loads, saves, renames, duplicates, deletes. A
/// failure is reported in the message strip and changes nothing.
class PresetController final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    PresetController(Workbench&, PresetList&, PresetStore);

    /// Lists the presets of the exhibit whose parameters are shown.
    void refresh();
    /// Marks the preset in use. Call after values or the shown exhibit changed.
    void mark();
    /// Saves the finished picture as thumbnail of the preset in use, if it has none and the picture shows it unchanged.
    void keepMissingThumbnail();
    /// Name of the preset in use: "Old gold", with " *" if values were changed since; empty if none is in use.
    [[nodiscard]] QString titleOfUse() const;

    /// Reads a file and returns the scene state that it gives. If it cannot be read, shows a message and returns
    /// nullopt. Changes nothing.
    [[nodiscard]] std::optional<ReadSettings> settingsIn(const QString& path);
    /// Returns the presets of this exhibit by name and id (their path), the visitor's own first.
    [[nodiscard]] std::vector<std::pair<QString, QString>> choices(std::size_t exhibit);
    /// Returns the id of the preset selected in the list; empty: none.
    [[nodiscard]] QString selected() const;

    // Commands. Those without an argument act on the preset selected in the list.
    void load(const QString& id);
    /// Loads a preset of any exhibit, after asking to go there.
    void loadOfAny(const QString& id);
    /// Saves the present values to the preset in use. If that is not the visitor's own, saves them at once as a new
    /// one, whose name is proposed.
    void save();
    /// Asks for a name.
    void saveAs();
    /// Saves under this name. A name that exists gets a number, because names of an exhibit's presets are unique.
    void saveUnder(const QString& name);
    void rename();
    /// Asks for the tags of the selected preset, which must be the visitor's own.
    void editTags();
    void duplicate();
    void remove();
    void importFile();
    void exportFile();
    void saveExhibition();

    /// Loads a preset or exhibition from a file without copying the file.
    void loadFile(const QString& path);
    /// Loads the preset inside a picture. Returns false if there is none; true if it was loaded or an error was shown.
    bool loadFromPicture(const QString& path);

signals:
    /// Emitted when the preset in use, or whether its values were changed, may have changed.
    void marked();
    /// Asks to go to an exhibit and to show its parameters.
    void visitAsked(std::size_t exhibit);

private:
    [[nodiscard]] ReadSettings read(const std::string& text, const QString& origin) const;
    void loadText(const std::string& text, const QString& origin);
    void show(const Preset&, std::size_t exhibit, const QString& step);
    void showNotes(const QString& origin, const std::vector<std::string>& notes);
    void keepThumbnail(const std::filesystem::path& preset);
    /// Returns the presets of exhibits other than the shown one that were used last.
    [[nodiscard]] std::vector<RecentPreset> recentOfOthers() const;
    /// Returns the exhibit to which a preset's folder belongs; nullopt: it is not in this museum.
    [[nodiscard]] std::optional<std::size_t> exhibitOf(const QString& id) const;
    void trySafely(const std::function<void()>& work, const QString& cause = QStringLiteral("presets"));
    void renameTo(const QString& id, const QString& name);
    void setTags(const QString& id, const PresetTags&, std::size_t exhibit);
    void showFacts(const QString& id);
    [[nodiscard]] std::string exhibitName() const;
    [[nodiscard]] const Parameters& table() const;
    [[nodiscard]] Preset presetOnShow(const QString& name) const;
    /// Returns the preset that "Save" writes and the list marks; null if none was loaded or saved.
    [[nodiscard]] const StoredPreset* inUse() const;
    void use(StoredPreset);
    [[nodiscard]] bool changedSince(const StoredPreset&) const;
    /// Returns a name for the present values: the parameter that alone differs from its initial value, or that of the
    /// preset in use, or the exhibit's.
    [[nodiscard]] QString proposedName() const;
    [[nodiscard]] QString freeName(const QString& wanted, const std::filesystem::path& exceptFor = {}) const;

    Workbench& window_;
    PresetList& list_;
    PresetStore store_;
    PresetUses uses_;
};

}  // namespace vitrine::ui
