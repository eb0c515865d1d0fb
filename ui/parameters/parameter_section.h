#pragma once

#include <QAbstractButton>
#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;

namespace vitrine::ui {

class ParameterRow;

/// Heading of a group; a click folds the group. While folded, a dot marks that a value inside was changed.
class SectionHeading final : public QAbstractButton {
    Q_OBJECT

public:
    SectionHeading(const QString& title, QWidget* parent);
    void setMarked(bool);
    /// Shows or hides a padlock.
    void setLocked(bool);
    /// Shows the number of groups that are edited together; 0: edited alone.
    void setTogether(int groups);
    /// Says why the group has no effect; empty: it has one.
    void setIdle(const QString& why);

signals:
    /// Asks for a menu at this screen position: by a right click, the Menu key, or a click on the dots at its end.
    void menuAsked(const QPoint& at);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void contextMenuEvent(QContextMenuEvent*) override;
    [[nodiscard]] bool hitButton(const QPoint&) const override;
    [[nodiscard]] QSize sizeHint() const override { return {120, 28}; }

private:
    /// Returns the rectangle of the dots.
    [[nodiscard]] QRect menuPlace() const;
    void describe();

    bool marked_ = false;
    bool locked_ = false;
    int together_ = 0;
    QString whyIdle_;
};

/// Rows of one group of parameters. Rows before the first group have no heading and cannot be folded.
class ParameterSection final : public QWidget {
    Q_OBJECT

public:
    ParameterSection(const QString& title, QWidget* parent);

    void add(ParameterRow*);
    [[nodiscard]] QString title() const { return title_; }
    [[nodiscard]] bool folded() const;
    void setFolded(bool);
    /// Shows the wanted rows, or only the changed ones of them, even if the group is folded. Returns their number.
    int showOnlyChanged(bool only);
    /// Updates the heading's mark. Call after values changed.
    void refresh();
    void setLocked(bool locked);
    /// Marks the group as edited together with others. `groups`: their number; 0: edited alone.
    void setTogether(int groups);
    /// Shows below the heading why no parameter of the group has an effect, and a button that gives it one. `when`: the
    /// condition for an effect; empty: it has one. `command`: the text of the button; empty: no button.
    void setIdle(const QString& when, const QString& command);

signals:
    void foldedByVisitor(bool folded);
    /// Emitted by the button that gives the group an effect.
    void actAsked();
    /// Asks for the group's menu at this screen position.
    void menuAsked(const QPoint& at);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    [[nodiscard]] bool shows(const ParameterRow&) const;
    void layOut();
    void addNotice();

    QString title_;
    SectionHeading* heading_ = nullptr;
    QWidget* notice_ = nullptr;
    QLabel* reason_ = nullptr;
    QPushButton* act_ = nullptr;
    QString when_;
    std::vector<ParameterRow*> rows_;
    bool onlyChanged_ = false;
    bool together_ = false;
};

}  // namespace vitrine::ui
