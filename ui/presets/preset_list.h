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

/// One line of the list. `id` is whatever its owner finds it by.
struct PresetLine {
    QString id;
    QString name;
    bool shipped = false;  ///< Came with the program: can be loaded and duplicated, not changed.
    QString problem;       ///< Why it cannot be opened; empty when it can.
    QPixmap thumbnail;
    QStringList tags;
};

/// The presets of one exhibit, by picture and name, the visitor's own first. Where there are more than a few, words
/// and tags find some of them. A large preview shows what a line does not. Asks for everything; does nothing itself.
class PresetList final : public QWidget {
    Q_OBJECT

public:
    explicit PresetList(QWidget* parent = nullptr);

    void fill(const std::vector<PresetLine>&);
    /// The preset that the look was loaded from or saved to, or "" for none; `changed`: the look has left it since.
    void setCurrent(const QString& id, bool changed = false);
    [[nodiscard]] QString selected() const;
    /// The actions that its buttons and menu offer, in this order; null is a separator.
    void setActions(QAction* save, QAction* saveAs, const QList<QAction*>& menu);
    /// Lets the visitor type a new name in place. Returns false where the preset is none of his own.
    bool startRename(const QString& id);
    /// The answer to `factsAsked`.
    void showPreview(const PresetFacts&);
    /// One entry per use, of all presets in the list.
    [[nodiscard]] QStringList tagsInUse() const;

signals:
    /// `selected` is another one, by the visitor.
    void selectedChanged();
    void loadAsked(const QString& id);
    void factsAsked(const QString& id);
    void renamed(const QString& id, const QString& name);

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    /// Shows those that have all words that were typed, and all tags that are pressed.
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
    QLabel* nothing_ = nullptr;  ///< Says that nothing is found; null while something is.
    QWidget* buttons_;
    QList<QAction*> menu_;
};

}  // namespace vitrine::ui
