#pragma once

#include "exhibits/museum/museum.h"
#include "ui/viewport/render_thread.h"

#include <QObject>
#include <QPointF>
#include <QTimer>

#include <memory>
#include <optional>

namespace vitrine::ui {

class History;
class Overlay;
class Renderers;
class Viewport;
struct PictureJob;

/// Light and surface at the center of one pixel.
struct InspectedPixel {
    glm::dvec3 radiance{0};  ///< Scene-linear light.
    glm::dvec3 normal{0};    ///< In world space; 0 if the surface has none.
    /// Point of the surface in world space, in meters, and its distance from the eye; unset: only the sky is there.
    std::optional<glm::dvec3> position;
    double distance = 0;
    std::string object;      ///< Name of the exhibit or object; empty: the building.
    double evaluations = 0;  ///< Number of evaluations of a field; 0: none were counted.
};

/// While the key I is held, shows what is at the pixel below the pointer: color, light, position, normal, distance,
/// object and cost. The pixel is drawn again by the render thread, with one sample through its center.
class PixelInspector final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object.
    PixelInspector(const Museum&, const History&, Renderers&, Viewport&, QObject* parent);

    /// Text beside the pointer; empty while the key is not held, or until the pixel is drawn.
    [[nodiscard]] QString text() const;

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    void begin();
    void end();
    void ask();
    void show(const QPointF& at, const InspectedPixel&);

    const Museum& museum_;
    const History& history_;
    Renderers& renderers_;
    Viewport& viewport_;
    Overlay* label_;
    QTimer soon_;  ///< Delays the next pixel, so that a moving pointer asks for few of them.
    /// Delays the end: some X servers send a repeated key as releases and presses that look like those of a visitor.
    QTimer released_;
    bool held_ = false;
    QPointF pointer_;
    /// Job of the render thread, kept while the key is held.
    std::shared_ptr<PictureJob> job_;
    RenderThread::Task task_;
};

}  // namespace vitrine::ui
