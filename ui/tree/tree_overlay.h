#pragma once

#include "ui/model/history.h"
#include "ui/tree/tree_handles.h"

#include <QLineF>
#include <QTimer>
#include <QWidget>

#include <optional>
#include <vector>

namespace vitrine {
class Museum;
}

namespace vitrine::ui {

class ProgressJob;
class TreeEditor;
class Viewport;

/// The selected node in the picture: its outline, which another thread finds, and handles to drag. A click on the
/// exhibit selects what it shows.
class TreeOverlay final : public QWidget {
    Q_OBJECT

public:
    /// All must outlive it; it lies over the viewport.
    TreeOverlay(const Museum&, TreeEditor&, Viewport&);
    ~TreeOverlay() override;

    void setMode(HandleMode);
    [[nodiscard]] HandleMode mode() const { return mode_; }
    /// As painted now.
    [[nodiscard]] const std::vector<Handle>& handles() const { return handles_; }
    [[nodiscard]] const std::vector<QLineF>& outline() const { return outline_; }

signals:
    /// Another outline is shown.
    void outlined();

protected:
    void paintEvent(QPaintEvent*) override;
    bool eventFilter(QObject*, QEvent*) override;

private:
    void pick(std::size_t exhibit, const QPointF& at);
    /// The look is another one, or what is selected.
    void renew();
    void askForOutline();
    void findHandles();
    [[nodiscard]] std::optional<TreePlace> place() const;
    [[nodiscard]] bool press(const QPointF&);
    void drag(const QPointF&);

    struct Drag {
        Handle handle;
        std::size_t point = 0;
        QPointF from;
        TreePlace place;
        Gesture gesture = 0;
    };

    const Museum& museum_;
    TreeEditor& editor_;
    Viewport& viewport_;
    HandleMode mode_ = HandleMode::move;
    std::vector<Handle> handles_;
    std::vector<QLineF> outline_;
    glm::dmat4 outlineView_{0};  ///< `View::clipFromWorld` of the outline: seen from elsewhere it lies elsewhere.
    std::optional<Drag> drag_;
    QTimer soon_;  // So that what moves asks for an outline when it rests.
    ProgressJob* job_;
};

}  // namespace vitrine::ui
