#pragma once

#include "exhibits/museum/museum.h"

#include <QObject>
#include <QUndoStack>

#include <functional>
#include <map>
#include <optional>
#include <set>

namespace vitrine::ui {

class SceneStateChange;

/// Number of a gesture, such as one drag or one held key. Edits with the same number, other than 0, are one undo step.
using Gesture = int;
[[nodiscard]] Gesture newGesture();

/// Signal of one exhibit's changes, see `History::watch`.
class ExhibitChanges final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

signals:
    void changed(std::optional<std::size_t> row);
};

/// The window's scene state and its undo stack. All values of the window are changed here.
///
/// Views of a value keep no copy of it. A view of one exhibit calls `watch`. Marks, bars and docks, which need not
/// follow each move of a slider, listen to `changesSettled`. Only what must know each change of any exhibit at once
/// listens to `changed` and `replaced`. Camera moves of the visitor are no undo
/// steps. A step that moves the camera (such as applying a preset) moves it back when undone.
class History : public QObject {
    Q_OBJECT

public:
    enum class Camera { stays, moves };

    explicit History(SceneState start, QObject* parent = nullptr);

    [[nodiscard]] const SceneState& sceneState() const { return sceneState_; }
    /// Returns the values after the first `step` undo steps, 0 to the stack's count. The camera is the present one.
    [[nodiscard]] SceneState valuesAt(int step) const;
    /// Sets one value, or the nearest legal one, as one undo step. `text` is the step's label; empty: "Change
    /// roughness". A value that equals the present one makes no step. Setting an animated parameter ends its animation.
    void set(std::size_t exhibit, std::size_t row, const Value&, Gesture, const QString& text = {});
    /// Sets several values at once to those of `after`. Exhibits that name the same files as now keep the tables in
    /// use. A state that equals the present one makes no step.
    void change(const QString& text, const SceneState& after, Gesture = 0, Camera = Camera::stays);
    /// Adds a step that leaves the scene state alone, such as deleting a preset. `redo` is called now.
    void record(const QString& text, std::function<void()> redo, std::function<void()> undo);
    /// The same for a step that also changes the scene state to `after`. `redo` is called before each change to
    /// `after`, `undo` before each change back.
    void record(const QString& text, const SceneState& after, std::function<void()> redo, std::function<void()> undo,
                Camera = Camera::stays);
    /// Sets the camera after a move of the visitor. Makes no step and emits `walked` only.
    void setCamera(const render::Camera& camera)
    {
        if (sceneState_.camera == camera) return;
        sceneState_.camera = camera;
        emit walked();
    }
    /// Takes the parameter tables of `tabled`, which has read the files, for all exhibits that name the same files.
    /// Makes no step of its own. Undoing the last step, which named the files, also takes this back.
    void exchangeTables(const SceneState& tabled);
    /// Replaces the values by those of `after`, which has the same appearance: a document was written to its file.
    /// Makes no step; undo and redo restore the same pictures as before.
    void settle(const SceneState& after);
    /// Clears the undo stack and shows this state: a session is restored.
    void restart(const SceneState&);

    /// Calls `callback` right after values of this exhibit changed, until the owner is destroyed or the connection
    /// ends. Passes the parameter's index if one value alone changed, else nullopt.
    QMetaObject::Connection watch(std::size_t exhibit, const QObject* owner,
                                  std::function<void(std::optional<std::size_t> row)> callback);

    /// Returns the gesture of the change that `changed` or `replaced` reports, or has reported last.
    [[nodiscard]] Gesture gesture() const { return gesture_; }
    [[nodiscard]] QUndoStack& stack() { return stack_; }

signals:
    /// Emitted when this value changed, and no other: by an edit, undo or redo.
    void changed(std::size_t exhibit, std::size_t row);
    /// Emitted when several values changed at once, or the camera alone.
    void replaced();
    /// Emitted in the turn of the event loop after steps were done or undone: once for all of them. `exhibits` are
    /// those whose values changed; empty for steps without one, such as deleting a preset.
    void changesSettled(const std::set<std::size_t>& exhibits);
    /// Emitted after `changed` or `replaced` when the camera has to move to `sceneState().camera`.
    void cameraMoved();
    /// Emitted when the visitor moved the camera: many times a second while walking.
    void walked();

private:
    friend class SceneStateStep;

    /// Tells all listeners about a change that was made. `camera`: the camera was set, too.
    void noteChange(const SceneStateChange&, Camera);
    void noteReplaced(const std::set<std::size_t>& exhibits);
    void tellWatchers(std::size_t exhibit, std::optional<std::size_t> row);
    void settleSoon(const std::set<std::size_t>& exhibits);

    SceneState sceneState_;
    Gesture gesture_ = 0;
    std::map<std::size_t, ExhibitChanges*> watched_;
    std::set<std::size_t> unsettled_;  ///< Exhibits that `changesSettled` will report.
    bool settling_ = false;            ///< `changesSettled` will be emitted in the next turn of the event loop.
    QUndoStack stack_;
};

}  // namespace vitrine::ui
