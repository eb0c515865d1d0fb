#pragma once

#include "exhibits/museum/museum.h"
#include "ui/model/history.h"
#include "ui/viewport/file_watch.h"
#include "ui/viewport/prepared_state.h"

#include <QObject>
#include <QSize>
#include <QTimer>

#include <vector>

class QWidget;

namespace vitrine::ui {

class ExhibitClock;
class Visitor;

/// Scene of this moment: the values, the time, the camera and the size of the picture. Tells when any of them changed
/// other than by the passing of time.
class PresentScene final : public QObject {
    Q_OBJECT

public:
    /// All must outlive the scene. `viewport` is the widget that shows it.
    PresentScene(const QWidget& viewport, const Museum&, const History&, const Visitor&, const ExhibitClock&);

    [[nodiscard]] const Museum& museum() const { return museum_; }
    [[nodiscard]] const SceneState& state() const { return history_.sceneState(); }
    /// Number of the present scene state: grows with every change of values, camera or size.
    [[nodiscard]] long long number() const { return number_; }
    /// Returns the request for the whole viewport at full resolution: now, or at another time of the exhibits' clock.
    [[nodiscard]] FrameRequest request() const;
    [[nodiscard]] FrameRequest request(double time) const;
    /// Returns the present view; raster in device pixels.
    [[nodiscard]] render::View view() const;
    [[nodiscard]] QSize devicePixels() const;
    /// Returns whether the viewport is on the screen.
    [[nodiscard]] bool canBeSeen() const;
    /// Runs every pass, even if it is not needed. The picture must stay the same.
    void setRunEverything(bool);
    [[nodiscard]] bool runsEverything() const { return runEverything_; }

    /// Returns the prepared scene, cached for queries to the museum.
    [[nodiscard]] const Prepared& prepared() const;
    /// Missing files may have been read: the next query prepares again.
    void lookAgain() { prepared_.lookAgain(); }
    /// Number of preparations for queries since the start. Tests use it to check that one scene state and time takes
    /// one.
    [[nodiscard]] long long preparations() const { return prepared_.preparations(); }

    /// Call when the camera changed. `cut`: it jumped.
    void changeCamera(bool cut);

public slots:
    /// Call when anything else visible changed.
    void change();

signals:
    void changed();
    /// Emitted when the camera changed, and nothing else.
    void cameraChanged(bool cut);
    /// Emitted when values with an effect changed: earlier frames show other values. `changed` follows.
    void valuesChanged();
    /// Emitted when no value has changed for a while.
    void rested();
    /// Emitted when a file that the scene state names, or one beside it, changed on disk. `changed` came before.
    void filesChanged();
    /// Emitted when the scene was prepared while files are still to be read.
    void reading() const;

private:
    static constexpr int restsAfter = 2000;  // Milliseconds without a changed value.

    void takeValues();

    const QWidget& viewport_;
    const Museum& museum_;
    const History& history_;
    const Visitor& visitor_;
    const ExhibitClock& clock_;
    FileWatch files_;
    QTimer rest_;  // Runs while values have changed lately.
    bool runEverything_ = false;
    long long number_ = 0;
    std::vector<ParameterValues> acting_;  // Effective values of the present scene state.
    mutable PreparedState prepared_;       // Cache of the last preparation.
};

}  // namespace vitrine::ui
