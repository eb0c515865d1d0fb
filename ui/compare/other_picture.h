#pragma once

#include "ui/viewport/render_thread.h"

#include <QImage>
#include <QObject>
#include <QSize>

#include <optional>
#include <vector>

namespace vitrine::ui {

class OtherSettings;
class Viewport;

/// The picture of B: seen by the camera, at the moment and at the resolution of the viewport's last whole picture, and
/// refined while that one is at rest. Drawn only while it is wanted.
class OtherPicture final : public QObject {
    Q_OBJECT

public:
    /// All must outlive it.
    OtherPicture(Viewport&, Renderers&, const OtherSettings&, QObject* parent);

    /// While on, there is always a picture of B, or one on the way. Off: nothing is drawn, and what drawing kept goes.
    void setWanted(bool wanted);
    [[nodiscard]] bool wanted() const { return wanted_; }

    /// Null until one is drawn, and where drawing it failed.
    [[nodiscard]] const QImage& image() const { return image_; }
    /// It shows the B that is held now.
    [[nodiscard]] bool upToDate() const { return pictured_.has_value(); }
    /// It is that, and shows what the viewport's last whole picture shows, as finely at least.
    [[nodiscard]] bool present() const;
    /// Why the last one could not be drawn; empty where it could, or is not drawn yet.
    [[nodiscard]] const QString& failure() const { return failure_; }
    /// Of the last picture.
    [[nodiscard]] const render::FrameReport& report() const { return report_; }
    /// All that is to be drawn of it is drawn.
    [[nodiscard]] bool finished() const { return finished_; }
    /// Since the start, every sample counts: tests count that nothing is drawn that nobody sees.
    [[nodiscard]] long long picturesDrawn() const { return picturesDrawn_; }

signals:
    void drawn();
    /// There is none any more.
    void gone();
    /// Said once for each B, after `gone`.
    void failed(const QString& why);

private:
    /// From where, when and how finely B is drawn.
    struct Sight {
        render::Camera camera;
        double time = 0;
        std::vector<double> sincePressed;
        QSize screen;
        bool runEverything = false;
        double scale = 1;
        bool rests = false;

        /// A picture from there serves for this sight, too: it is as fine at least.
        [[nodiscard]] bool serves(const Sight& wanted) const;
    };
    [[nodiscard]] Sight sight() const;
    /// A drew a picture, whose settings may have changed: B is drawn anew only where it would look otherwise.
    void follow(const render::FrameReport&);
    void order();
    void forget();
    void fail(const QString& why);

    Viewport& viewport_;
    Renderers& renderers_;
    const OtherSettings& other_;
    bool wanted_ = false;
    bool finished_ = false;
    std::optional<Sight> ordered_;  // Of the picture that is there or on the way.
    QImage image_;
    render::FrameReport report_;
    std::optional<Sight> pictured_;  // Of the image; none: it shows a former B, or there is none.
    QString failure_;
    long long picturesDrawn_ = 0;
    RenderThread::Task task_;
};

}  // namespace vitrine::ui
