#pragma once

#include "ui/parameters/value_editor.h"

#include <QAbstractButton>
#include <QLabel>

namespace vitrine::ui {

/// The name of a row; dragging it edits a number.
class RowLabel final : public QLabel {
    Q_OBJECT

public:
    RowLabel(const QString& text, ValueEditor* editor, QWidget* parent);
    void setDim(bool dim);
    /// Shows a padlock.
    void setLocked(bool locked);
    /// Shows a wave.
    void setMoving(bool moving);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;

private:
    ValueEditor* editor_;
    bool dragging_ = false;
    bool dim_ = false;
    bool locked_ = false;
    bool moving_ = false;
};

/// An amber dot while the value differs from the initial one, an arrow under the pointer; a click resets.
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

/// The mark of a quality parameter: what does its accuracy cost?
class GaugeMark final : public QAbstractButton {
    Q_OBJECT

public:
    explicit GaugeMark(QWidget* parent);

protected:
    void paintEvent(QPaintEvent*) override;
};

/// Mark of a row that does nothing now: a click says why, and offers what would change that.
class IdleMark final : public QAbstractButton {
    Q_OBJECT

public:
    explicit IdleMark(QWidget* parent);

protected:
    void paintEvent(QPaintEvent*) override;
};

/// One row of the panel: label, editor, reset dot.
class ParameterRow final : public QWidget {
    Q_OBJECT

public:
    // Pixels beside type of the usual size.
    static constexpr int rowHeight = 26;
    static constexpr int narrowestLabel = 112, widestLabel = 240;

    ParameterRow(const ValueRef&, QWidget* parent);

    [[nodiscard]] const ParameterInfo& info() const { return editor_->row(); }
    void showValue(const Value&);
    /// Back to the initial value.
    void reset();
    [[nodiscard]] bool differs() const { return differs_; }
    /// Whether label, name, group, help or a choice contains `words`, whatever the case.
    [[nodiscard]] static bool matches(const ParameterInfo&, const QString& words);
    [[nodiscard]] bool matches(const QString& words) const { return matches(info(), words); }
    /// A row that means nothing at the moment is not shown, whatever is searched for.
    void setWanted(bool wanted) { wanted_ = wanted; }
    [[nodiscard]] bool wanted() const { return wanted_; }
    /// Grays the row while it does not act, with a mark that asks why: `when` is empty while it acts. It can be edited
    /// all the same, and acts with that value as soon as it does.
    void setIdle(const QString& when);
    [[nodiscard]] bool idle() const { return !idleUntil_.isEmpty(); }
    /// Why it does nothing, as a sentence; empty while it acts.
    [[nodiscard]] QString whyIdle() const;
    /// Marks a row that keeps its value when others are varied.
    void setLocked(bool locked) { label_->setLocked(locked); }
    /// Marks a row that moves, and says how in its tooltip; empty: it keeps its value.
    void setMotion(const QString& how);
    [[nodiscard]] const QString& motion() const { return motion_; }
    /// Quality parameters show their gauge only once something answers it.
    void setGaugeShown(bool);

signals:
    void accuracyAsked();
    /// Why does it do nothing, and what would change that? At this place on the screen.
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

    QString idleUntil_, motion_;
    GaugeMark* gauge_ = nullptr;
    IdleMark* why_;
    bool differs_ = false;
    bool wanted_ = true;
};

}  // namespace vitrine::ui
