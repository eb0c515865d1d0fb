#pragma once

#include "ui/viewport/render_thread.h"

#include <QImage>
#include <QObject>
#include <QStringList>

#include <array>
#include <cstdint>
#include <optional>

namespace vitrine::ui {

class ParameterPanel;
class Workbench;

/// Nine random variations of the shown exhibit's values, with pictures. Pictures are drawn one after the other on the
/// render thread, with the viewport's camera, and only while the grid is visible.
class Variations final : public QObject {
    Q_OBJECT

public:
    static constexpr int count = 9;

    /// Both must outlive this object.
    Variations(Workbench&, const ParameterPanel&, QObject* parent);

    /// Sets whether the pictures are visible. Off: nothing is drawn. On: missing pictures are drawn.
    void setSeen(bool);

    /// Sets the number n of the set, from 1. Variation i, from 0, has the seed 9 (n - 1) + i + 1. The first nine are
    /// the first ones of "Randomize parameters".
    void setNumber(int number) { number_ = number; }
    [[nodiscard]] int number() const { return number_; }
    /// Sets how far variations differ, 0 to 1 (see `variation`).
    void setStrength(double strength) { strength_ = strength; }
    [[nodiscard]] double strength() const { return strength_; }
    [[nodiscard]] std::uint64_t seedOf(int variation) const;

    /// Makes nine variations of the present values, and draws them.
    void drawAnew();
    /// Removes the variations, because another exhibit is shown.
    void clear();
    /// Returns whether there are variations; their pictures may be missing.
    [[nodiscard]] bool made() const { return base_.has_value(); }

    /// Returns the values of variation i. Call only while `made`.
    [[nodiscard]] const ParameterValues& values(int i) const { return *made_.at(static_cast<std::size_t>(i)); }
    /// Returns the picture of variation i; null until it is drawn.
    [[nodiscard]] const QImage& image(int i) const { return images_.at(static_cast<std::size_t>(i)); }
    /// Returns the number of finished pictures.
    [[nodiscard]] int finished() const { return finished_; }
    /// Returns why drawing failed; empty if it did not.
    [[nodiscard]] const QString& failure() const { return failure_; }

    /// Returns the variation that equals the present values, if any.
    [[nodiscard]] std::optional<int> onShow() const;
    /// Returns whether the variations are of other values than the present ones, or were made with other locks.
    [[nodiscard]] bool stale() const;

    /// Applies variation i, as one undo step.
    void pick(int i);
    /// Applies variation i, and draws the next nine around it.
    void goOnFrom(int i);

signals:
    /// Emitted when pictures or variations changed.
    void changed();

private:
    void order();
    [[nodiscard]] const ParameterValues& shownValues() const;

    Workbench& workbench_;
    const ParameterPanel& panel_;
    int number_ = 1;
    double strength_ = 0.4;
    bool seen_ = false;
    bool waiting_ = false;                 // Waits for the first picture of the viewport.
    std::size_t exhibit_ = 0;              // Exhibit whose values are varied.
    std::optional<ParameterValues> base_;  // Values that are varied.
    QStringList locked_;                   // Locked parameters of all exhibits when the variations were made.
    std::array<std::optional<ParameterValues>, count> made_;
    std::array<QImage, count> images_;
    int finished_ = 0;
    QString failure_;
    RenderThread::Task task_;
};

}  // namespace vitrine::ui
