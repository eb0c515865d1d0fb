#pragma once

#include "exhibits/printing/print_views.h"
#include "ui/viewport/render_thread.h"

#include <QElapsedTimer>
#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace vitrine::ui {

class Workbench;

/// Renders the views of a print from what the window shows, step by step on the render thread.
class ShownViews final : public QObject {
    Q_OBJECT

public:
    ShownViews(Workbench&, QObject* parent);
    ~ShownViews() override;

    /// From where the visitor stands now; stops what was being rendered.
    void start(const ParameterValues&, bool draft);
    void stop();
    [[nodiscard]] bool running() const { return views_ != nullptr; }

signals:
    /// `part` is 0 to 1; `secondsLeft` is negative while unknown.
    void progressed(double part, double secondsLeft);
    void finished(std::shared_ptr<const vitrine::printing::PrintViews> views,
                  const vitrine::printing::SceneDepth& depth);
    void failed(const QString& why);

private:
    /// What the render thread works on.
    struct Work {
        std::vector<printing::ViewShot> pictures;  ///< The quick one for depth, then the views.
        std::size_t next = 0;
        std::shared_ptr<printing::PrintViews> views;
        PictureJob job;
        QElapsedTimer told;
    };
    /// One sample of a tile of a picture; returns whether there is more to do. On the render thread: only what is told
    /// touches the window.
    static bool step(Renderers&, Work&, const RenderThread::Tell&, ShownViews& told);
    void note(double part);
    void end(const QString& failure);

    Workbench& window_;
    std::optional<ParameterValues> values_;
    SceneState sceneState_;  ///< Of the quick picture.
    std::shared_ptr<printing::PrintViews> views_;
    printing::SceneDepth depth_;
    RenderThread::Task task_;
    QElapsedTimer elapsed_;
};

}  // namespace vitrine::ui
