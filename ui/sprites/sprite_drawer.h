#pragma once

#include "exhibits/sprites/sprite_files.h"
#include "ui/viewport/render_thread.h"

#include <QElapsedTimer>
#include <QObject>

#include <memory>
#include <string>
#include <vector>

namespace vitrine::ui {

class Renderers;

/// Draws the frames of a sprite on the render thread, one a step, beside what else is drawn there.
class SpriteDrawer final : public QObject {
    Q_OBJECT

public:
    using Frames = std::shared_ptr<std::vector<SpriteFrame>>;

    /// Both must outlive it.
    SpriteDrawer(Renderers&, RenderThread&, QObject* parent);
    ~SpriteDrawer() override;

    /// Draws these in place of what is being drawn. `look`: values of `spriteLookName`.
    void start(const ParameterValues& look, std::shared_ptr<const SpriteSubject>, const SpriteRequest&);
    /// Nothing more is told.
    void stop();
    [[nodiscard]] bool running() const { return running_; }

signals:
    /// `part` is 0 to 1; `secondsLeft` is negative while unknown.
    void progressed(double part, double secondsLeft);
    void finished(const vitrine::ui::SpriteDrawer::Frames& frames);
    void failed(const QString& why);

private:
    struct Work;
    void note(double part);
    void end(const QString& failure);

    Renderers& renderers_;
    RenderThread& thread_;
    RenderThread::Task task_;
    QElapsedTimer elapsed_;
    Frames frames_;
    bool running_ = false;
};

}  // namespace vitrine::ui
