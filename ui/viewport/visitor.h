#pragma once

#include "exhibits/museum/museum.h"
#include "ui/viewport/camera_control.h"

#include <QObject>

#include <functional>
#include <vector>

namespace vitrine::ui {

class History;

/// Visitor of the museum: the camera, the visited subject, and the standpoints before.
class Visitor final : public QObject {
    Q_OBJECT

public:
    /// Places the visitor at the history's camera. `prepared` returns the prepared scene of this moment. All must
    /// outlive the visitor.
    Visitor(const Museum&, const History&, std::function<const Prepared&()> prepared);

    /// Visits an exhibit: glides to its best view and orbits it. Visiting the hall glides to its best view and walks.
    void visit(std::size_t exhibit);
    /// Glides to one of the user's own objects.
    void visit(const OwnObjectShown&);
    /// Glides to an object that was pointed at.
    void visit(const Pointed&);
    /// Glides to a camera. The visitor then walks if the eye is at a visitor's height on free floor, and orbits the
    /// camera's target otherwise.
    void goTo(const render::Camera&);
    /// Glides back to where the visitor was before the last visit or walk away, and emits `visited` for the subject
    /// there. Does nothing without such a place.
    void goBack();
    [[nodiscard]] bool canGoBack() const { return !former_.empty(); }
    /// Leaves the exhibit and walks on.
    void walkOn();
    void jumpTo(const render::Camera&);
    /// Advances walking and glides by `seconds`.
    void advance(double seconds, const WalkKeys&);

    /// Sets the subject whose parameters are shown. Its button is pressed while it is orbited.
    void setSubject(std::size_t subject) { subject_ = subject; }
    [[nodiscard]] std::size_t subject() const { return subject_; }
    /// True while an exhibit without a place in the hall is visited: it is shown alone, in its own space.
    [[nodiscard]] bool isInDepot() const;
    [[nodiscard]] CameraControl::Mode mode() const { return control_.mode(); }
    [[nodiscard]] CameraControl& control() { return control_; }
    [[nodiscard]] const CameraControl& control() const { return control_; }

signals:
    /// Emitted when the camera changed. `cut`: it jumped.
    void moved(bool cut);
    /// Emitted after a glide or a cut to another standpoint began.
    void departed();
    /// Emitted after `departed` if the destination has a name: the exhibit or the hall.
    void headedFor(std::size_t subject);
    void visited(std::size_t exhibit);
    void walkedOn();

private:
    static constexpr std::size_t mostFormer = 100;

    struct Former {
        CameraControl::Standpoint standpoint;
        std::size_t subject = hallIndex;
    };
    /// Glides to a standpoint and makes `subject` the visited one. Into and out of the depot the camera cuts.
    void glideTo(std::size_t subject, const CameraControl::Standpoint&);
    void depart();
    void remember();

    const Museum& museum_;
    const History& history_;
    std::function<const Prepared&()> prepared_;
    CameraControl control_;
    std::size_t subject_ = hallIndex;
    std::vector<Former> former_;  // Earlier standpoints, the latest at the end.
};

}  // namespace vitrine::ui
