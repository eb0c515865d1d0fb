#pragma once

#include <QLabel>

#include <vector>

namespace vitrine::ui {

/// One line or block of text over the picture: plain text on a dark veil, whatever the theme.
class Overlay final : public QLabel {
    Q_OBJECT

public:
    enum class Place { topLeft, top, center, bottom, pointer };

    Overlay(Place, QWidget* viewport);

    /// Empty text hides it.
    void say(const QString& text);
    /// After the viewport's size changed.
    void place();
    /// For `Place::pointer`: beside this point of the viewport.
    void placeAt(const QPoint&);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    Place place_;
    QPoint pointer_;
};

}  // namespace vitrine::ui
