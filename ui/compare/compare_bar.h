#pragma once

#include <QWidget>

#include <vector>

class QAction;
class QLabel;
class QMenu;
class QToolButton;

namespace vitrine::ui {

class CompareController;
class ValueSlider;

/// Bar below the picture while there is a B: the mode, the number of differing parameters, a slider from A to B, and
/// commands for B. A narrow bar leaves out what the menus also offer.
class CompareBar final : public QWidget {
    Q_OBJECT

public:
    /// The controller must outlive the bar.
    CompareBar(CompareController&, QWidget* parent);

    /// Updates the bar to the present B and mode.
    void refresh();
    /// While on, the bar stays hidden: used for the bare picture.
    void setBanned(bool);
    /// Returns the text "3 parameters differ".
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
    /// Returns the widgets to hide in a narrow bar, the first one first.
    [[nodiscard]] std::vector<QWidget*> whatMayGo() const;
    void showWhatFits();

    CompareController& controller_;
    QWidget* gains_;
    ValueSlider* gain_;
    QLabel* times_;
    QMenu* rows_;
    QToolButton* differ_;
    QWidget* morphs_;
    ValueSlider* morph_;
    QToolButton* source_;
    std::vector<QWidget*> buttons_;  // Buttons of the modes, and the one that swaps.
    bool banned_ = false;
};

}  // namespace vitrine::ui
