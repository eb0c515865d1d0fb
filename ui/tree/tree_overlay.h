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

/// Overlay for the selected node: its outline, computed on another thread, and handles to drag. A click on the exhibit
/// selects the node there.
class TreeOverlay final : public QWidget {
    Q_OBJECT

public:
    /// All must outlive the overlay, which lies over the viewport.
    TreeOverlay(const Museum&, TreeEditor&, Viewport&);
    ~TreeOverlay() override;

    void setMode(HandleMode);
    [[nodiscard]] HandleMode mode() const { return mode_; }
    /// Returns the handles as painted last.
    [[nodiscard]] const std::vector<Handle>& handles() const { return handles_; }
    [[nodiscard]] const std::vector<QLineF>& outline() const { return outline_; }

signals:
    /// Emitted when another outline is shown.
    void outlined();

protected:
    void paintEvent(QPaintEvent*) override;
    bool eventFilter(QObject*, QEvent*) override;

private:
    void pick(std::size_t exhibit, const QPointF& at);
    /// Updates outline and handles after a change of the scene state or selection.
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
    glm::dmat4 outlineView_{0};  ///< `View::clipFromWorld` of the outline. In another view the outline is wrong.
    std::optional<Drag> drag_;
    QTimer soon_;  // Delays the outline until changes stop.
    ProgressJob* job_;
};

}  // namespace vitrine::ui
