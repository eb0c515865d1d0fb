#pragma once

#include <QFrame>
#include <QString>

#include <cstddef>
#include <functional>
#include <vector>

class QLabel;

namespace vitrine {
class SceneObject;
}

namespace vitrine::ui {

class FlowLayout;
class History;
class Viewport;

/// Something that a visitor can do at an exhibit, as a button of the card.
struct VisitOffer {
    QString face, tip;
    std::function<void()> act;
};

/// Card over the lower left corner of the picture that says what an exhibit is and what a visitor can do there: its
/// lesson, a comparison that it offers, nine variations, its page. It appears on the first visit of an exhibit, once
/// on this machine, and disappears when it was used or closed, a value changed, or the visitor went elsewhere.
class VisitCard final : public QFrame {
    Q_OBJECT

public:
    /// `offers` returns the buttons of an exhibit; nothing: its visit does not count as the first, and no card appears.
    /// The history must outlive the card, which is a child of the picture.
    VisitCard(Viewport&, History&, std::function<std::vector<VisitOffer>(std::size_t exhibit)> offers);

    /// Shows the card if this exhibit is visited for the first time, and hides it otherwise.
    void follow(std::size_t exhibit, const SceneObject&);
    /// While on, the card is hidden and no visit counts as the first: used for the bare picture.
    void setBanned(bool);

protected:
    bool eventFilter(QObject*, QEvent*) override;
    void paintEvent(QPaintEvent*) override;

private:
    void fill(const std::vector<VisitOffer>&);
    void place();

    Viewport& picture_;
    std::function<std::vector<VisitOffer>(std::size_t exhibit)> offers_;
    QLabel *title_, *summary_;
    FlowLayout* buttons_;
    std::size_t exhibit_ = 0;
    bool banned_ = false;
};

}  // namespace vitrine::ui
