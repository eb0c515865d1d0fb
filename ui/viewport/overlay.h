#pragma once

#include <QLabel>

#include <vector>

namespace vitrine::ui {

/// Text over the picture, one line or more: plain text on a dark veil, whatever the theme.
class Overlay final : public QLabel {
    Q_OBJECT

public:
    enum class Place { topLeft, top, center, bottom, pointer };

    Overlay(Place, QWidget* viewport);

    /// Shows the text; empty text hides the overlay.
    void say(const QString& text);
    /// Places the overlay. Call after the viewport's size changed.
    void place();
    /// Places an overlay of `Place::pointer` beside this point of the viewport.
    void placeAt(const QPoint&);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    Place place_;
    QPoint pointer_;
};

}  // namespace vitrine::ui
