#pragma once

#include "ui/parameters/controlled_parameters.h"
#include "ui/parameters/value_editor.h"

#include <QAbstractButton>
#include <QLabel>
#include <QStringList>

#include <cstdint>

namespace vitrine::ui {

/// Label with the name of a parameter; dragging it changes a number.
class RowLabel final : public QLabel {
    Q_OBJECT

public:
    RowLabel(const QString& text, ValueEditor* editor, QWidget* parent);
    void setDim(bool dim);
    /// Shows or hides a padlock.
    void setLocked(bool locked);
    /// Shows or hides a wave, the mark of an animation.
    void setMoving(bool moving);
    /// Returns the height for this width, in pixels: a long name takes up to three lines.
    [[nodiscard]] int heightFor(int width) const;
    /// Returns whether the name is shown whole.
    [[nodiscard]] bool isWhole() const;

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;

private:
    /// Returns the room of the name in this width, in pixels.
    [[nodiscard]] int roomIn(int width) const;
    /// Breaks the name into lines of this width in pixels.
    [[nodiscard]] QStringList linesIn(int width) const;

    ValueEditor* editor_;
    bool dragging_ = false;
    bool dim_ = false;
    bool locked_ = false;
    bool moving_ = false;
};

/// Reset button: an amber dot if the value differs from the initial one, an arrow under the pointer.
class ResetDot final : public QAbstractButton {
    Q_OBJECT

public:
    explicit ResetDot(QWidget* parent);
    void setDiffers(bool);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    bool differs_ = false;
};

/// Button of a quality parameter that shows the cost of its accuracy.
class GaugeMark final : public QAbstractButton {
    Q_OBJECT

public:
    explicit GaugeMark(QWidget* parent);

protected:
    void paintEvent(QPaintEvent*) override;
};

/// Button of a parameter without effect: explains why, and offers changes that give it an effect.
class IdleMark final : public QAbstractButton {
    Q_OBJECT

public:
    explicit IdleMark(QWidget* parent);

protected:
    void paintEvent(QPaintEvent*) override;
};

/// Row of the panel for one parameter: label, editor, reset dot.
class ParameterRow final : public QWidget {
    Q_OBJECT

public:
    // Pixels at the usual font size.
    static constexpr int rowHeight = 26;
    static constexpr int narrowestLabel = 112, widestLabel = 240;

    /// Returns the width at which a row shows this parameter's label whole, in pixels.
    [[nodiscard]] static int widthForLabel(const ParameterInfo&, const QWidget& panel);

    /// Label of a parameter: whole, or without the word that the heading of its group has.
    enum class Label : std::uint8_t { whole, underHeading };

    ParameterRow(const ValueRef&, QWidget* parent, Label = Label::underHeading);

    [[nodiscard]] const ParameterInfo& info() const { return editor_->row(); }
    void showValue(const Value&);
    /// Sets the values that a text parameter offers.
    void setOffers(const QStringList& offers) { editor_->setOffers(offers); }
    /// Sets the initial value.
    void reset();
    [[nodiscard]] bool differs() const { return differs_; }
    /// Sets whether the row may be shown. A parameter that means nothing now stays hidden.
    void setWanted(bool wanted) { wanted_ = wanted; }
    [[nodiscard]] bool wanted() const { return wanted_; }
    /// Grays the row while the parameter has no effect, and shows a mark that explains it. `when`: the condition for an
    /// effect; empty: it has one. The value can be edited all the same.
    void setIdle(const QString& when);
    [[nodiscard]] bool idle() const { return !idleUntil_.isEmpty(); }
    /// Returns a sentence why the parameter has no effect; empty if it has one.
    [[nodiscard]] QString whyIdle() const;
    /// Marks a parameter that keeps its value when others are varied.
    void setLocked(bool locked);
    /// Marks an animated parameter. `how`: description for the tooltip; empty: not animated.
    void setMotion(const QString& how);
    [[nodiscard]] const QString& motion() const { return motion_; }
    /// Shows below the parameter which control moves it; an empty text: none does.
    void setController(const ParameterNote&);
    /// Shows or hides the gauge of a quality parameter. It is hidden until its click is handled.
    void setGaugeShown(bool);
    /// Adds a button before the editor, for a parameter that stands for a press.
    void addButton();

signals:
    void accuracyAsked();
    void pushed();
    /// Asks to explain at this screen position why the parameter has no effect, and what would give it one.
    void wayAsked(const QPoint& at);

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    ValueRef value_;
    ValueEditor* editor_;
    RowLabel* label_;
    QWidget* naming_;
    ResetDot* dot_;
    void describe();
    void alignEditors();
    void placeController();
    /// Makes the row as high as its label.
    void fitLabel();

    QString idleUntil_, motion_;
    GaugeMark* gauge_ = nullptr;
    IdleMark* why_;
    QLabel* controller_ = nullptr;  ///< Made when it is first needed.
    QString controlledBy_;
    bool differs_ = false;
    bool wanted_ = true;
};

}  // namespace vitrine::ui
