#pragma once

#include <QWidget>

#include <vector>

class QAction;
class QLabel;
class QMenu;
class QToolButton;

namespace vitrine::ui {

class CompareDesk;
class ValueSlider;

/// One line below the picture while there is a B: how both are shown, how many rows differ, a slider that leads A to B,
/// what B is and what it may become. Where the line is narrow, it leaves out what the menus have as well.
class CompareBar final : public QWidget {
    Q_OBJECT

public:
    /// The desk must outlive it.
    CompareBar(CompareDesk&, QWidget* parent);

    /// Shows what is held and how.
    void refresh();
    /// Out of sight whatever is held: nothing but the picture is shown.
    void setBanned(bool);
    /// "3 rows differ".
    [[nodiscard]] QString differenceText() const;
    [[nodiscard]] ValueSlider& gain() const { return *gain_; }
    [[nodiscard]] ValueSlider& morph() const { return *morph_; }

protected:
    void resizeEvent(QResizeEvent*) override;
    bool event(QEvent*) override;

private:
    QToolButton* button(QAction&, const QString& words);
    QToolButton* menuButton(QMenu*);
    void addGain();
    void addMorph();
    void fillRows();
    /// Widgets that give way where the bar is narrow, the first one first.
    [[nodiscard]] std::vector<QWidget*> whatMayGo() const;
    void showWhatFits();

    CompareDesk& desk_;
    QWidget* gains_;
    ValueSlider* gain_;
    QLabel* times_;
    QMenu* rows_;
    QToolButton* differ_;
    QWidget* morphs_;
    ValueSlider* morph_;
    QToolButton* source_;
    std::vector<QWidget*> buttons_;  // Of the modes, and the one that swaps.
    bool banned_ = false;
};

}  // namespace vitrine::ui
