#pragma once

#include "ui/message_strip.h"

#include <QObject>

namespace vitrine::ui {

class MainWindow;
class PresetList;

/// Presets on disk, for the exhibit that is chosen: loads, saves, renames, duplicates, deletes.
class PresetShelf final : public QObject {
    Q_OBJECT

public:
    PresetShelf(MainWindow&, PresetList&);

    /// Shows the presets of the chosen exhibit.
    void refresh();
    void load(const QString& id);
    /// To the preset in use, or under a new name where there is none of the visitor's own.
    void save();
    void saveAs();
    void rename();
    void duplicate();
    void remove();
    void importFile();
    void loadFile(const QString& path);
    /// Returns false when the picture has no preset inside.
    bool loadFromPicture(const QString& path);
    void exportFile();
    void saveExhibition();
    /// A preset or exhibition from its text; `origin` names it in messages. Returns whether it was taken.
    bool loadText(const std::string& text, const QString& origin);
    /// The look on show as the text of an exhibition: what travels inside screenshots.
    [[nodiscard]] std::string lookText() const;

private:
    MainWindow& window_;
    PresetList& list_;
    QString current_;
};

}  // namespace vitrine::ui
