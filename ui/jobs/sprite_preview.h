#pragma once

#include "exhibits/jobs/sprite/sprite_sheet.h"
#include "ui/jobs/job_preview.h"
#include "ui/kit/accessible_content.h"

#include <QElapsedTimer>
#include <QImage>
#include <QPoint>
#include <QTimer>

#include <memory>
#include <vector>

namespace vitrine::ui {

/// Animated preview of a sprite sheet: shows the frames of one direction after the other, with large pixels. Its clock
/// stops while it is hidden.
class SpritePreview final : public JobPreview, public AccessibleContent {
    Q_OBJECT

public:
    /// Sheet to show: its picture, and the positions of the frames in it.
    struct Shown {
        QImage picture;
        std::vector<jobs::SpriteCell> cells;  ///< Direction by direction.
        std::vector<QPoint> pivots;           ///< Pivot of each cell, in pixels of the untrimmed frame.
        QSize frame;                          ///< Size of the untrimmed frame.
        int frames = 1;                       ///< Number of frames of each direction.
        double seconds = 1.0 / 12;            ///< Duration of each frame.
    };

    explicit SpritePreview(QWidget* parent);

    [[nodiscard]] std::function<void()> prepare(const jobs::JobRun&, const ParameterValues& all,
                                                const ParameterValues& drawn) override;
    void clear() override { setShown(nullptr); }
    [[nodiscard]] const Shown* shown() const { return shown_.get(); }
    /// Returns the index of the displayed cell.
    [[nodiscard]] int cell() const { return cell_; }
    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Animation; }
    [[nodiscard]] QString accessibleText() const override;
    [[nodiscard]] QSize sizeHint() const override { return {480, 480}; }

protected:
    void paintEvent(QPaintEvent*) override;
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;

private:
    /// Sets the sheet to show; null: none.
    void setShown(std::shared_ptr<const Shown>);
    void next();

    std::shared_ptr<const Shown> shown_;
    int cell_ = 0;
    QTimer timer_;
};

}  // namespace vitrine::ui
