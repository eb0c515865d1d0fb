#pragma once

#include <qcustomplot.h>

namespace vitrine::ui {

/// Ticks at round numbers, as many as their labels have room for beside each other and within the axis: labels are
/// measured in the axis's font and at its length of the layout before. Works for linear and logarithmic axes.
class RoomyTicker final : public QCPAxisTicker {
public:
    /// The axis owns it.
    explicit RoomyTicker(const QCPAxis& axis) : axis_(axis) {}

    void generate(const QCPRange&, const QLocale&, QChar formatChar, int precision, QVector<double>& ticks,
                  QVector<double>* subTicks, QVector<QString>* tickLabels) override;

private:
    /// Those whose labels end within the axis.
    [[nodiscard]] QVector<double> within(const QVector<double>& ticks, const QCPRange&) const;
    [[nodiscard]] bool collide(const QVector<double>& ticks, const QCPRange&) const;
    [[nodiscard]] double length() const;                             ///< Of the axis, pixels.
    [[nodiscard]] double place(double tick, const QCPRange&) const;  ///< From the axis's beginning, pixels.
    [[nodiscard]] double extent(double tick) const;                  ///< Of the label along the axis, pixels.

    const QCPAxis& axis_;
};

/// A number as an axis shows it: "0.02", "60 000", "2·10⁶".
[[nodiscard]] QString axisNumber(double);

}  // namespace vitrine::ui
