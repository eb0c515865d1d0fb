#pragma once

#include "ui/viewport/render_thread.h"

#include <QImage>
#include <QObject>
#include <QSize>

#include <optional>
#include <vector>

namespace vitrine::ui {

class SettingsB;
class Viewport;

/// Picture of B with the camera, time and resolution of the viewport's last whole picture, refined while that one is
/// static. Drawn only while it is wanted.
class PictureB final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object.
    PictureB(Viewport&, Renderers&, const SettingsB&, QObject* parent);

    /// While on, a picture of B exists or is being drawn. Off: nothing is drawn, and the renderer of B is released.
    void setWanted(bool wanted);
    [[nodiscard]] bool wanted() const { return wanted_; }

    /// Returns the picture of B; null before the first one, and if drawing failed.
    [[nodiscard]] const QImage& image() const { return image_; }
    /// Returns whether the picture shows the present B.
    [[nodiscard]] bool upToDate() const { return pictured_.has_value(); }
    /// Returns whether the picture shows the present B and matches the viewport's last whole picture, at least as
    /// finely.
    [[nodiscard]] bool present() const;
    /// Returns why drawing failed last; empty if it did not.
    [[nodiscard]] const QString& failure() const { return failure_; }
    /// Returns the frame report of the last picture.
    [[nodiscard]] const render::FrameReport& report() const { return report_; }
    /// Returns whether all samples are drawn.
    [[nodiscard]] bool finished() const { return finished_; }
    /// Number of samples drawn since the start. Tests use it to check that nothing invisible is drawn.
    [[nodiscard]] long long picturesDrawn() const { return picturesDrawn_; }

signals:
    void drawn();
    /// Emitted when the picture was discarded.
    void gone();
    /// Emitted once for each B, after `gone`.
    void failed(const QString& why);

private:
    /// Camera, time, size and quality of a picture of B.
    struct Sight {
        render::Camera camera;
        double time = 0;
        std::vector<double> sincePressed;
        QSize screen;
        bool runEverything = false;
        double scale = 1;
        bool idle = false;

        /// Returns whether a picture of this view can also be used for `wanted`: it is the same view and at least as
        /// fine.
        [[nodiscard]] bool serves(const Sight& wanted) const;
    };
    [[nodiscard]] Sight sight() const;
    /// Handles a new picture of A. B is drawn again only if its view differs.
    void follow(const render::FrameReport&);
    void order();
    void forget();
    void fail(const QString& why);

    Viewport& viewport_;
    Renderers& renderers_;
    const SettingsB& other_;
    bool wanted_ = false;
    bool finished_ = false;
    std::optional<Sight> ordered_;  // View of the picture that is drawn or ordered.
    QImage image_;
    render::FrameReport report_;
    std::optional<Sight> pictured_;  // View of the image; unset: it shows an earlier B, or there is none.
    QString failure_;
    long long picturesDrawn_ = 0;
    RenderThread::Task task_;
};

}  // namespace vitrine::ui
