#pragma once

#include "ui/compare/compare_mode.h"
#include "ui/kit/spoken.h"

#include <QImage>
#include <QWidget>

#include <optional>

class QMouseEvent;

namespace vitrine::ui {

class OtherPicture;
class OtherSettings;
class ProgressJob;
class Viewport;

/// Lies over the viewport and shows B's picture beside A's, or where they differ. The line of the wipe is dragged, or
/// moved by comma and period; side by side, the pointer works in either picture as in the whole one.
class CompareOverlay final : public QWidget, public Spoken {
    Q_OBJECT

public:
    /// All must outlive it.
    CompareOverlay(Viewport&, const OtherSettings&, OtherPicture&);

    void setMode(CompareMode);
    [[nodiscard]] CompareMode mode() const { return mode_; }
    /// What differences are multiplied by.
    void setGain(int gain);
    [[nodiscard]] int gain() const { return gain_; }
    /// B alone, whatever the mode.
    void setOtherAlone(bool alone);
    [[nodiscard]] bool otherAlone() const { return alone_ || held_; }
    /// Where the line of the wipe is, 0 (left) to 1.
    [[nodiscard]] double wipe() const { return wipe_; }
    void setWipe(double share);
    [[nodiscard]] QAccessible::Role spokenRole() const override;
    [[nodiscard]] QString spokenText() const override;
    /// Where the line is, in percent; none where there is no line.
    [[nodiscard]] std::optional<SpokenNumber> spokenNumber() const override;
    void setSpokenNumber(double percent) override { setWipe(percent / 100); }
    /// The difference on show; null: none, or not there yet.
    [[nodiscard]] const QImage& difference() const { return difference_; }

signals:
    /// Whether B has to be drawn may have changed.
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
    /// Where the pictures lie side by side.
    [[nodiscard]] QRect pictureOf(bool other) const;
    /// Whether the event was for the line.
    bool dragWipe(const QMouseEvent&);
    /// Hands a pointer event over to the viewport, and to all that filter its events, where it lies in the whole
    /// picture: this filter is to be the last one installed.
    bool passOn(const QMouseEvent&);
    bool holdKey(QEvent*);
    /// Comma and period move the line.
    bool moveWipe(QEvent*);
    [[nodiscard]] bool showsWipe() const;
    /// Whether the key of B is down.
    void hold(bool down);

    Viewport& viewport_;
    const OtherSettings& other_;
    OtherPicture& picture_;
    ProgressJob* job_;
    CompareMode mode_ = CompareMode::off;
    int gain_ = 8;
    bool alone_ = false, held_ = false;
    double wipe_ = 0.5;
    bool dragging_ = false, near_ = false;
    std::optional<bool> pressedOther_;  // While the pointer is down side by side: whether it went down in B's picture.
    bool passing_ = false;              // The event that comes is one that was passed on.
    /// What a difference is of.
    struct DifferenceKey {
        qint64 a = 0, b = 0;
        CompareMode mode = CompareMode::off;
        int gain = 0;

        bool operator==(const DifferenceKey&) const = default;
    };
    QImage difference_;
    DifferenceKey differenceKey_;  // Of the one on show or in the making.
    bool differenceDue_ = false;
};

}  // namespace vitrine::ui
