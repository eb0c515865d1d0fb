#pragma once

#include <qcustomplot.h>

namespace vitrine::ui {

/// Axis ticker with round numbers, as many as their labels have room for. Labels are measured in the axis's font, at
/// its length in the last layout. For linear and logarithmic axes.
class RoomyTicker final : public QCPAxisTicker {
public:
    /// The axis owns the ticker and must outlive it.
    explicit RoomyTicker(const QCPAxis& axis) : axis_(axis) {}

    void generate(const QCPRange&, const QLocale&, QChar formatChar, int precision, QVector<double>& ticks,
                  QVector<double>* subTicks, QVector<QString>* tickLabels) override;

private:
    /// Returns the ticks whose labels end within the axis.
    [[nodiscard]] QVector<double> within(const QVector<double>& ticks, const QCPRange&) const;
    [[nodiscard]] bool collide(const QVector<double>& ticks, const QCPRange&) const;
    [[nodiscard]] double length() const;                             ///< Length of the axis in pixels.
    [[nodiscard]] double place(double tick, const QCPRange&) const;  ///< Distance from the axis's beginning in pixels.
    [[nodiscard]] double extent(double tick) const;                  ///< Size of the label along the axis, in pixels.

    const QCPAxis& axis_;
};

/// Formats a number for an axis: "0.02", "60 000", "2·10⁶".
[[nodiscard]] QString axisNumber(double);

}  // namespace vitrine::ui
