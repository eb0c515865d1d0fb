#pragma once

#include <QProxyStyle>

namespace vitrine::ui {

/// Style based on Fusion without bevels and gradients: flat fields and thin edges. The accent color marks only active
/// and focused controls.
class FlatStyle final : public QProxyStyle {
    Q_OBJECT

public:
    /// Property of a tool button whose text already says that it has a menu. A style sheet is not used, because widgets
    /// with one do not follow a changed font size of the application.
    static constexpr auto hidesMenuArrow = "hidesMenuArrow";

    FlatStyle();

    /// Sets labels and tooltips with automatic text format to plain text. They show file names and paths, and Qt would
    /// load files that HTML in them names.
    void polish(QWidget*) override;
    using QProxyStyle::polish;

    void drawPrimitive(PrimitiveElement, const QStyleOption*, QPainter*, const QWidget*) const override;
    void drawControl(ControlElement, const QStyleOption*, QPainter*, const QWidget*) const override;
    void drawComplexControl(ComplexControl, const QStyleOptionComplex*, QPainter*, const QWidget*) const override;
    int styleHint(StyleHint, const QStyleOption* = nullptr, const QWidget* = nullptr,
                  QStyleHintReturn* = nullptr) const override;
    [[nodiscard]] int pixelMetric(PixelMetric, const QStyleOption*, const QWidget*) const override;
    [[nodiscard]] QSize sizeFromContents(ContentsType, const QStyleOption*, const QSize&,
                                         const QWidget*) const override;
    [[nodiscard]] QRect subControlRect(ComplexControl, const QStyleOptionComplex*, SubControl,
                                       const QWidget*) const override;
};

}  // namespace vitrine::ui
