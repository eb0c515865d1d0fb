#pragma once

#include "ui/viewport/render_thread.h"

namespace vitrine::ui {

class PresentScene;

/// Orders of the viewport's pictures: one at a time is with the render thread.
class PictureOrders {
public:
    /// Both must outlive this object.
    PictureOrders(const PresentScene&, RenderThread&);

    /// Orders a sample of the whole picture. A first sample shows the present time, later ones show the same time.
    void orderWhole(const DrawOrder&);
    /// Orders a region of the picture at the present time, with all its samples.
    void orderRegion(const PictureRegion&, int samples);
    /// Returns whether a picture is ordered and has not arrived yet.
    [[nodiscard]] bool isUnderway() const { return underway_ != Underway::nothing; }
    /// Returns whether a region is being drawn that no longer fits the scene.
    [[nodiscard]] bool drawsOldRegion() const;
    void abandon() { thread_.abandon(); }
    /// Call when the ordered picture has arrived.
    void noteArrival(const DrawnPicture&);

    /// The camera jumped: the next whole picture uses nothing of earlier frames.
    void cut() { cut_ = true; }
    [[nodiscard]] bool hasCut() const { return cut_; }
    /// Earlier frames of the present motion show another scene and must not be averaged in.
    void restartMotion() { motionFrames_ = 0; }
    /// Scene state number of the last ordered picture.
    [[nodiscard]] long long sceneStateNumber() const { return sceneStateNumber_; }

private:
    enum class Underway { nothing, whole, region };

    const PresentScene& scene_;
    RenderThread& thread_;
    Underway underway_ = Underway::nothing;
    bool cut_ = true;         // The camera jumped since the last whole picture, or there was none.
    int motionFrames_ = 0;    // Number of frames of the present motion; 0: static picture.
    double pictureTime_ = 0;  // Time that the whole picture shows, on the exhibits' clock.
    long long sceneStateNumber_ = 0;
};

}  // namespace vitrine::ui
