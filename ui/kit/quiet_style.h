#pragma once

#include <QProxyStyle>

namespace vitrine::ui {

/// Fusion without bevels and gradients: flat fields, thin edges, the accent only for what is on or has the focus.
class QuietStyle final : public QProxyStyle {
    Q_OBJECT

public:
    /// Property of a tool button whose words say already that it has a menu. A style sheet would do as well, but
    /// widgets with one keep their size of type when the application gets another.
    static constexpr auto hidesMenuArrow = "hidesMenuArrow";

    QuietStyle();

    /// Makes every label that was not told otherwise plain text, tooltips among them: names, titles and paths of files
    /// stand in them, and Qt would read files that their HTML names.
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
