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

/// Renders the views of a print from the window's scene state, step by step on the render thread.
class ShownViews final : public QObject {
    Q_OBJECT

public:
    ShownViews(Workbench&, QObject* parent);
    ~ShownViews() override;

    /// Renders with the visitor's present camera. Stops a rendering that is running.
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
    /// Data that the render thread works on.
    struct Work {
        std::optional<printing::RenderedViews> rendered;
        std::vector<printing::ViewShot> pictures;  ///< First a quick picture for the depth, then the views.
        std::size_t next = 0;
        std::shared_ptr<printing::PrintViews> views;
        PictureJob job;
        QElapsedTimer told;
    };
    /// Renders one sample of a tile. Returns whether more is to be done. Runs on the render thread; functions given to
    /// `Notify` run in the window's.
    static bool step(Renderers&, Work&, const RenderThread::Notify&, ShownViews& told);
    /// Takes the cameras that fit to the depth of the first picture, if the values say so.
    static void fitCameras(Work&);
    void note(double part);
    void end(const QString& failure);

    Workbench& window_;
    std::optional<ParameterValues> values_;
    SceneState sceneState_;  ///< State of the quick picture.
    std::shared_ptr<printing::PrintViews> views_;
    printing::SceneDepth depth_;
    RenderThread::Task task_;
    QElapsedTimer elapsed_;
};

}  // namespace vitrine::ui
