#pragma once

#include "exhibits/framework/preset_store.h"

#include <QObject>

#include <functional>
#include <optional>
#include <string>

namespace vitrine::ui {

class MainWindow;
class PresetList;

/// Presets on disk, for the exhibit that is chosen: loads, saves, renames, duplicates, deletes. What fails is
/// said in the message strip, and everything stays as it was.
class PresetShelf final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive it.
    PresetShelf(MainWindow&, PresetList&, PresetStore);

    /// Shows the presets of the chosen exhibit.
    void refresh();

    // What the actions do; those without an argument work on the preset selected in the list.
    void load(const QString& id);
    /// To the preset in use, or under a new name where that is none of the visitor's own.
    void save();
    void saveAs();
    void saveUnder(const QString& name);
    void rename();
    void duplicate();
    void remove();
    void importFile();
    void exportFile();
    void saveExhibition();

    /// A preset or exhibition from a file: shown, not copied.
    void loadFile(const QString& path);
    /// Returns false when the picture has no preset inside; true when it is shown, or what is wrong was said.
    bool loadFromPicture(const QString& path);
    /// The look on show as the text of an exhibition: what travels inside pictures.
    [[nodiscard]] std::string lookText() const;

private:
    void loadText(const std::string& text, const QString& origin);
    void show(const Preset&, std::size_t exhibit, const QString& step);
    void tell(const QString& origin, const std::vector<std::string>& notes);
    void keepThumbnail(const std::filesystem::path& preset);
    void trySafely(const std::function<void()>& work);
    void renameTo(const QString& id, const QString& name);
    [[nodiscard]] std::string exhibitName() const;
    [[nodiscard]] const Parameters& table() const;
    [[nodiscard]] Preset presetOnShow(const QString& name) const;

    MainWindow& window_;
    PresetList& list_;
    PresetStore store_;
    std::optional<StoredPreset> inUse_;  ///< What "Save" writes back.
};

}  // namespace vitrine::ui
