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

/// Nine variations of the values that the panel shows, and their pictures, which are drawn one after the other on the
/// render thread while the visitor goes on: seen as the viewport sees, and only while someone looks.
class Variations final : public QObject {
    Q_OBJECT

public:
    static constexpr int count = 9;

    /// Both must outlive it.
    Variations(Workbench&, const ParameterPanel&, QObject* parent);

    /// Off: nothing is drawn. On again, it goes on with those that are missing.
    void setSeen(bool);

    /// Variation i, from 0, is that of seed 9 (n - 1) + i + 1: the first nine are those that "Vary at random" begins
    /// with.
    void setNumber(int number) { number_ = number; }
    [[nodiscard]] int number() const { return number_; }
    /// How far they go, 0 to 1, as `variation` says.
    void setStrength(double strength) { strength_ = strength; }
    [[nodiscard]] double strength() const { return strength_; }
    [[nodiscard]] std::uint64_t seedOf(int variation) const;

    /// Varies what is on show, and draws the nine.
    void drawAnew();
    /// There are none any more: another exhibit is on show.
    void clear();
    /// There are nine, drawn or on the way.
    [[nodiscard]] bool made() const { return base_.has_value(); }

    /// Of variation i, while `made`.
    [[nodiscard]] const ParameterValues& values(int i) const { return *made_.at(static_cast<std::size_t>(i)); }
    /// Null until it is drawn.
    [[nodiscard]] const QImage& image(int i) const { return images_.at(static_cast<std::size_t>(i)); }
    /// How many are finished.
    [[nodiscard]] int finished() const { return finished_; }
    /// Why drawing ended; empty: it did not fail.
    [[nodiscard]] const QString& failure() const { return failure_; }

    /// The one that is the look on show; nothing: none is.
    [[nodiscard]] std::optional<int> onShow() const;
    /// They vary an older look than the one on show, or under other locks.
    [[nodiscard]] bool stale() const;

    /// It becomes the look; one undo step.
    void pick(int i);
    /// The same, and the next nine are drawn around it.
    void goOnFrom(int i);

signals:
    /// The pictures, or what they are of.
    void changed();

private:
    void order();
    [[nodiscard]] const ParameterValues& shownValues() const;

    Workbench& workbench_;
    const ParameterPanel& panel_;
    int number_ = 1;
    double strength_ = 0.4;
    bool seen_ = false;
    bool waiting_ = false;                 // For the first picture of the viewport.
    std::size_t exhibit_ = 0;              // Whose values they vary.
    std::optional<ParameterValues> base_;  // Which they vary.
    QStringList locked_;                   // Of all exhibits, when they were made.
    std::array<std::optional<ParameterValues>, count> made_;
    std::array<QImage, count> images_;
    int finished_ = 0;
    QString failure_;
    RenderThread::Task task_;
};

}  // namespace vitrine::ui
