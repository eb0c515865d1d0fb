#pragma once

#include <QFrame>

#include <cstddef>
#include <utility>
#include <vector>

namespace vitrine {
class Museum;
}

namespace vitrine::ui {

class History;
class Viewport;

/// Panel over the lower right corner of the picture with the few parameters that visitors of an exhibition may change:
/// those of the visited exhibit, and those of the hall.
class KioskPanel final : public QFrame {
    Q_OBJECT

public:
    /// Index of an exhibit, or the hall, and index of one of its parameters.
    using Place = std::pair<std::size_t, std::size_t>;

    /// All must outlive the panel, which is a child of the picture.
    KioskPanel(Viewport&, const Museum&, History&, const std::vector<Place>&);

    /// Shows the parameters of this exhibit and the hall. Hides the panel if there are none.
    void follow(std::size_t exhibit);

protected:
    bool eventFilter(QObject*, QEvent*) override;
    void paintEvent(QPaintEvent*) override;

private:
    void place();

    QWidget& picture_;
    std::vector<std::pair<std::size_t, QWidget*>> parts_;  ///< Headings and rows, each with its exhibit.
};

}  // namespace vitrine::ui
