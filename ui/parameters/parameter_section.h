#pragma once

#include <QAbstractButton>
#include <QWidget>

#include <vector>

namespace vitrine::ui {

class ParameterRow;

/// The heading of a group: a click folds it. While folded, a dot says that something inside was changed.
class SectionHeading final : public QAbstractButton {
    Q_OBJECT

public:
    SectionHeading(const QString& title, QWidget* parent);
    void setMarked(bool);
    /// Shows a padlock.
    void setLocked(bool);
    /// Says that it is edited together with others, so many in all; 0: alone.
    void setTogether(int groups);

signals:
    /// By a right click, the menu key, or a click on the dots at its end; on the screen.
    void menuAsked(const QPoint& at);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void contextMenuEvent(QContextMenuEvent*) override;
    [[nodiscard]] bool hitButton(const QPoint&) const override;
    [[nodiscard]] QSize sizeHint() const override { return {120, 28}; }

private:
    /// Where the dots are.
    [[nodiscard]] QRect menuPlace() const;
    void describe();

    bool marked_ = false;
    bool locked_ = false;
    int together_ = 0;
};

/// The rows of one group. Rows before the first group have no heading and do not fold.
class ParameterSection final : public QWidget {
    Q_OBJECT

public:
    ParameterSection(const QString& title, QWidget* parent);

    void add(ParameterRow*);
    [[nodiscard]] QString title() const { return title_; }
    [[nodiscard]] bool folded() const;
    void setFolded(bool);
    /// Shows the rows that match; while there are words or `onlyChanged`, folding does not hide them.
    /// Returns how many rows are there to see or unfold.
    int filter(const QString& words, bool onlyChanged);
    /// After values changed: the mark of the heading.
    void refresh();
    void setLocked(bool locked);
    /// Marks it as edited together with others, so many in all; 0: alone.
    void setTogether(int groups);

signals:
    void foldedByVisitor(bool folded);
    /// What can be done with the group, on the screen.
    void menuAsked(const QPoint& at);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    void layOut();

    QString title_;
    SectionHeading* heading_ = nullptr;
    std::vector<ParameterRow*> rows_;
    QString words_;
    bool onlyChanged_ = false;
    bool together_ = false;
};

}  // namespace vitrine::ui
