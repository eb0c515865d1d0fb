#pragma once

#include "exhibits/museum/scene_state.h"
#include "render/image/image_io.h"
#include "ui/viewport/render_thread.h"
#include "ui/viewport/renderers.h"

#include <QElapsedTimer>
#include <QObject>

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

namespace vitrine::ui {

class Workbench;

/// What to export.
struct ExportWish {
    std::filesystem::path path;
    render::PictureFormat format = render::PictureFormat::png8;
    glm::ivec2 size{1280, 720};
    int samples = 16;
    bool transparent = false;  ///< Only the chosen exhibit, cut out of the hall.
    bool asShown = false;      ///< The viewport's finished picture as it is; size, samples and the rest do not count.
    bool replaces = false;     ///< The file is there already and good; this one is only finer.
};

/// Export of one picture: draws what is shown when it is made, step by step on the render thread, then writes it with
/// the scene state inside.
class PictureExport final : public QObject {
    Q_OBJECT

public:
    /// The window must outlive it.
    PictureExport(Workbench&, ExportWish, QObject* parent);
    ~PictureExport() override;

    void start();
    /// Leaves no file, and deletes itself. Returns false when the file is being written already: `finished` follows.
    bool cancel();
    /// Until it is finished, failed or canceled.
    [[nodiscard]] bool running() const { return running_; }
    [[nodiscard]] const std::filesystem::path& path() const { return wish_.path; }
    /// Whether the file is there already, less fine.
    [[nodiscard]] bool replaces() const { return wish_.replaces; }
    /// The preset that the file carries.
    [[nodiscard]] const std::string& preset() const { return preset_; }

signals:
    /// `part` is 0 to 1; `secondsLeft` is negative while unknown.
    void progressed(double part, double secondsLeft);
    /// The file is written and checked; or why it is not: then the old file, if any, is as it was.
    void finished(const QString& path);
    void failed(const QString& why);

private:
    /// Whoever takes the first step from `drawing` decides.
    enum class Stage : std::uint8_t { drawing, writing, canceled };

    [[nodiscard]] PictureRequest request() const;
    /// Reads the viewport's picture before anything else is drawn, and writes it.
    void writeShown();
    void note(double part);
    void end(const QString& failure);

    Workbench& window_;
    ExportWish wish_;
    std::string preset_;
    SceneState sceneState_;
    PictureRequest request_;
    std::shared_ptr<std::atomic<Stage>> stage_ = std::make_shared<std::atomic<Stage>>(Stage::drawing);
    RenderThread::Task task_;
    QElapsedTimer elapsed_;
    bool running_ = false;
};

/// "<Pictures>/<exhibit>-<date>-<time>.png", neither taken yet nor by an export that is this window's child.
[[nodiscard]] std::filesystem::path freeScreenshotPath(const QObject& window, const QString& exhibit);

}  // namespace vitrine::ui
