#pragma once

#include <QListWidget>
#include <QPixmap>
#include <QWidget>

#include <vector>

class QAction;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace vitrine::ui {

class PresetPreview;
class TagChips;
struct PresetFacts;

/// Line of the list. `id` identifies the preset for the owner of the list.
struct PresetLine {
    QString id;
    QString name;
    bool shipped = false;  ///< Comes with the program: can be loaded and duplicated, but not changed.
    QString problem;       ///< Reason why it cannot be opened; empty if it can.
    QPixmap thumbnail;
    QStringList tags;
};

/// Preset of another exhibit, which was used lately.
struct RecentPreset {
    QString id;
    QString text;  ///< Name and exhibit.
};

/// List of one exhibit's presets with picture and name, the visitor's own first. More than a few can be searched by
/// words and tags. A large preview shows further details. Below it are the presets of other exhibits that were used
/// last, as many as there is room for. The list emits requests and changes nothing itself.
class PresetList final : public QWidget {
    Q_OBJECT

public:
    explicit PresetList(QWidget* parent = nullptr);

    void fill(const std::vector<PresetLine>&);
    /// Sets the presets of other exhibits, the newest first; nothing: none are shown.
    void setRecent(const std::vector<RecentPreset>&);
    /// Marks the preset that the scene state was loaded from or saved to; "": none. `changed`: values differ from it.
    void setCurrent(const QString& id, bool changed = false);
    [[nodiscard]] QString selected() const;
    /// Sets the actions of the two buttons and of the menu, in this order; null is a separator.
    void setActions(QAction* save, QAction* saveAs, const QList<QAction*>& menu);
    /// Begins typing a new name in place. Returns false if the preset is not the visitor's own.
    bool startRename(const QString& id);
    /// Shows the preview; called in answer to `factsAsked`.
    void showPreview(const PresetFacts&);
    /// Returns the tags of all presets in the list, with one entry for each use.
    [[nodiscard]] QStringList tagsInUse() const;

signals:
    /// Emitted when the visitor selected another preset.
    void selectedChanged();
    void loadAsked(const QString& id);
    /// Emitted when a preset of another exhibit was chosen.
    void recentAsked(const QString& id);
    void factsAsked(const QString& id);
    void renamed(const QString& id, const QString& name);

protected:
    bool eventFilter(QObject*, QEvent*) override;
    void resizeEvent(QResizeEvent*) override;

private:
    void addRecent();
    /// Hides tags and recent presets for which there is no room beside a few presets of the list.
    void fit();
    /// Shows the presets that have all typed words and all pressed tags.
    void filter();
    void showNothing(bool);
    [[nodiscard]] QListWidgetItem* itemFor(const PresetLine&);
    [[nodiscard]] QListWidgetItem* itemOf(const QString& id) const;

    QWidget* finder_;
    QLineEdit* words_;
    TagChips* chips_;
    QListWidget* list_;
    PresetPreview* preview_;
    QVBoxLayout* layout_;
    QLabel* nothing_ = nullptr;  ///< Label for an empty result; null if something is found.
    QWidget* recent_;
    QListWidget* recentList_;
    QWidget* buttons_;
    QList<QAction*> menu_;
};

}  // namespace vitrine::ui
