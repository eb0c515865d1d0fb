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

protected:
    void paintEvent(QPaintEvent*) override;
    [[nodiscard]] QSize sizeHint() const override { return {120, 28}; }

private:
    bool marked_ = false;
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

signals:
    void foldedByVisitor(bool folded);

private:
    void layOut();

    QString title_;
    SectionHeading* heading_ = nullptr;
    std::vector<ParameterRow*> rows_;
    QString words_;
    bool onlyChanged_ = false;
};

}  // namespace vitrine::ui
