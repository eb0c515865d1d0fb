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

/// Request to export a picture.
struct ExportRequest {
    std::filesystem::path path;
    render::PictureFormat format = render::PictureFormat::png8;
    glm::ivec2 size{1280, 720};
    int samples = 16;
    bool transparent = false;  ///< Draws only the chosen exhibit, on a transparent background.
    bool asShown = false;      ///< Exports the viewport's finished picture. Size, samples and transparency are ignored.
    bool replaces = false;     ///< The file exists already and is valid; this picture is only finer.
};

/// Export of one picture: draws the present scene state step by step on the render thread, then writes the file, which
/// contains the scene state as a preset.
class PictureExport final : public QObject {
    Q_OBJECT

public:
    /// The window must outlive this object.
    PictureExport(Workbench&, ExportRequest, QObject* parent);
    ~PictureExport() override;

    void start();
    /// Cancels the export without leaving a file, and deletes this object. Returns false if the file is being written
    /// already: `finished` follows.
    bool cancel();
    /// Returns whether the export is not yet finished, failed or canceled.
    [[nodiscard]] bool running() const { return running_; }
    [[nodiscard]] const std::filesystem::path& path() const { return exportRequest_.path; }
    /// Returns whether the file exists already, less fine.
    [[nodiscard]] bool replaces() const { return exportRequest_.replaces; }
    /// Returns the text of the preset inside the file.
    [[nodiscard]] const std::string& preset() const { return preset_; }

signals:
    /// `part` is 0 to 1; `secondsLeft` is negative while unknown.
    void progressed(double part, double secondsLeft);
    /// Emitted when the file is written and checked, or with the reason why not; an old file then stays unchanged.
    void finished(const QString& path);
    void failed(const QString& why);

private:
    /// State shared by both threads. The first one to leave `drawing` decides between writing and canceling.
    enum class Stage : std::uint8_t { drawing, writing, canceled };

    [[nodiscard]] PictureRequest request() const;
    /// Reads the viewport's picture before anything else is drawn, and writes it.
    void writeShown();
    void note(double part);
    void end(const QString& failure);

    Workbench& window_;
    ExportRequest exportRequest_;
    std::string preset_;
    SceneState sceneState_;
    PictureRequest request_;
    std::shared_ptr<std::atomic<Stage>> stage_ = std::make_shared<std::atomic<Stage>>(Stage::drawing);
    RenderThread::Task task_;
    QElapsedTimer elapsed_;
    bool running_ = false;
};

/// Returns "<Pictures>/<exhibit>-<date>-<time>.png". The path is neither in use nor that of an export of this window.
[[nodiscard]] std::filesystem::path freeScreenshotPath(const QObject& window, const QString& exhibit);

}  // namespace vitrine::ui
