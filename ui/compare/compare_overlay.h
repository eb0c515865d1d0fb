#pragma once

#include "ui/compare/compare_mode.h"
#include "ui/kit/accessible_content.h"

#include <QImage>
#include <QWidget>

#include <optional>

class QMouseEvent;

namespace vitrine::ui {

class PictureB;
class SettingsB;
class ProgressJob;
class Viewport;

/// Overlay of the viewport that shows B's picture beside A's, or their difference. The wipe line is dragged, or moved
/// with comma and period. Side by side, the pointer works in both pictures as in the whole viewport.
class CompareOverlay final : public QWidget, public AccessibleContent {
    Q_OBJECT

public:
    /// All must outlive the overlay.
    CompareOverlay(Viewport&, const SettingsB&, PictureB&);

    void setMode(CompareMode);
    [[nodiscard]] CompareMode mode() const { return mode_; }
    /// Sets the factor by which differences are multiplied.
    void setGain(int gain);
    [[nodiscard]] int gain() const { return gain_; }
    /// While on, shows B alone, whatever the mode.
    void setOtherAlone(bool alone);
    [[nodiscard]] bool otherAlone() const { return alone_ || held_; }
    /// Returns the position of the wipe line, 0 (left) to 1.
    [[nodiscard]] double wipe() const { return wipe_; }
    void setWipe(double share);
    [[nodiscard]] QAccessible::Role accessibleRole() const override;
    [[nodiscard]] QString accessibleText() const override;
    /// Returns the position of the wipe line in percent, if it is shown.
    [[nodiscard]] std::optional<AccessibleNumber> accessibleNumber() const override;
    void setAccessibleNumber(double percent) override { setWipe(percent / 100); }
    /// Returns the difference image; null if there is none yet.
    [[nodiscard]] const QImage& difference() const { return difference_; }

signals:
    /// Emitted when B may have to be drawn, or not any more.
    void needsChanged();

protected:
    bool eventFilter(QObject*, QEvent*) override;
    void paintEvent(QPaintEvent*) override;

private:
    void renew();
    void computeDifference();
    void paintWipe(QPainter&);
    void paintSideBySide(QPainter&);
    [[nodiscard]] QString otherText() const;
    void label(QPainter&, const QRect& in, Qt::Alignment, const QString&) const;
    /// Returns the rectangle of a picture in side-by-side mode.
    [[nodiscard]] QRect pictureOf(bool other) const;
    /// Returns whether the event was consumed by the wipe line.
    bool dragWipe(const QMouseEvent&);
    /// Passes a pointer event on to the viewport and all its event filters, at the position in the whole picture. This
    /// filter must be the last one installed.
    bool passOn(const QMouseEvent&);
    bool holdKey(QEvent*);
    /// Handles comma and period, which move the wipe line.
    bool moveWipe(QEvent*);
    [[nodiscard]] bool showsWipe() const;
    /// Sets whether the key of B is down.
    void hold(bool down);

    Viewport& viewport_;
    const SettingsB& other_;
    PictureB& picture_;
    ProgressJob* job_;
    CompareMode mode_ = CompareMode::off;
    int gain_ = 8;
    bool alone_ = false, held_ = false;
    double wipe_ = 0.5;
    bool dragging_ = false, near_ = false;
    // Set while the pointer is down in side-by-side mode: whether it was pressed in B's picture.
    std::optional<bool> pressedOther_;
    bool passing_ = false;  // The present event was passed on by this filter.
    /// Identity of a difference: both images, mode and gain.
    struct DifferenceKey {
        qint64 a = 0, b = 0;
        CompareMode mode = CompareMode::off;
        int gain = 0;

        bool operator==(const DifferenceKey&) const = default;
    };
    QImage difference_;
    DifferenceKey differenceKey_;  // Difference that is shown or being computed.
    bool differenceDue_ = false;
};

}  // namespace vitrine::ui
