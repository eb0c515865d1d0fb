#pragma once

#include "ui/kit/accessible_content.h"

#include <QWidget>

#include <deque>

namespace vitrine::ui {

/// Bar graph of the last frames' milliseconds, the newest on the right. It is as high as the highest bar, at least 16.7
/// ms, where it has a line. The tooltip gives the shortest, median and longest time.
class FrameGraph final : public QWidget, public AccessibleContent {
    Q_OBJECT

public:
    explicit FrameGraph(QWidget* parent = nullptr);

    void add(double milliseconds);
    /// Returns a summary: "60 frames: 12.0 to 80.5 ms, half of them up to 14.1 ms".
    [[nodiscard]] QString summary() const;
    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Chart; }

    [[nodiscard]] QSize sizeHint() const override { return {2 * most, 18}; }

protected:
    void paintEvent(QPaintEvent*) override;
    bool event(QEvent*) override;

private:
    static constexpr int most = 60;  ///< Frames; two pixels each.

    std::deque<double> milliseconds_;
};

}  // namespace vitrine::ui
