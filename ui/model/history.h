#pragma once

#include "exhibits/museum/museum.h"

#include <QObject>
#include <QUndoStack>

#include <functional>

namespace vitrine::ui {

/// Edits with the same number, other than 0, are one undo step: one drag, one held key.
using Gesture = int;
[[nodiscard]] Gesture newGesture();

/// The look on show and all the looks before it: the one place where values of the window change.
///
/// Whoever shows a value listens to `changed` and `replaced`; nobody keeps a copy of the values. The camera walks
/// freely and is no step of its own; a change that moves it (a preset) takes it back when undone.
class History : public QObject {
    Q_OBJECT

public:
    enum class Camera { stays, moves };

    explicit History(SceneState start, QObject* parent = nullptr);

    [[nodiscard]] const SceneState& sceneState() const { return sceneState_; }
    /// The values after the first `step` undo steps, 0 to the stack's count; the camera is the present one.
    [[nodiscard]] SceneState valuesAt(int step) const;
    /// Sets one value, or the nearest legal one. `text` names the step for people; empty: "Change roughness". A value
    /// equal to the one on show is no step. A row that moves stops and keeps the value: whoever sets it has taken it
    /// over.
    void set(std::size_t exhibit, std::size_t row, const Value&, Gesture, const QString& text = {});
    /// Sets several values at once: shows `after`, under the tables on show where it names the same files for them. A
    /// look equal to the one on show is no step.
    void change(const QString& text, const SceneState& after, Gesture = 0, Camera = Camera::stays);
    /// A step that is no change of the look, such as deleting a preset; `redo` is called now.
    void record(const QString& text, std::function<void()> redo, std::function<void()> undo);
    /// The same where the look becomes `after` as well, once `redo` was called; `undo` is called before it goes back.
    void record(const QString& text, const SceneState& after, std::function<void()> redo, std::function<void()> undo,
                Camera = Camera::stays);
    /// The visitor moved: no step, and no signal but `walked`.
    void setCamera(const render::Camera& camera)
    {
        if (sceneState_.camera == camera) return;
        sceneState_.camera = camera;
        emit walked();
    }
    /// Exchanges the tables of exhibits that name the same files as in `tabled`, which has read them. No step of its
    /// own: undo takes it back with the step that stands last, which is the one that named the files.
    void exchangeTables(const SceneState& tabled);
    /// Shows `after`, which looks the same: a document that was written to its file. No step, and undo and redo show
    /// what they showed.
    void settle(const SceneState& after);
    /// Starts over from `look`, with nothing to undo: a session that comes back.
    void restart(const SceneState&);

    /// Of the change that `changed` or `replaced` says now, or said last.
    [[nodiscard]] Gesture gesture() const { return gesture_; }
    [[nodiscard]] QUndoStack& stack() { return stack_; }

signals:
    /// This value changed, and no other: by an edit, undo or redo.
    void changed(std::size_t exhibit, std::size_t row);
    /// Several values changed at once, or none but the camera.
    void replaced();
    /// ... and the camera is to go to `look().camera`.
    void cameraMoved();
    /// The visitor took the camera somewhere else; many times a second while he walks.
    void walked();

private:
    friend class SceneStateStep;

    SceneState sceneState_;
    Gesture gesture_ = 0;
    QUndoStack stack_;
};

}  // namespace vitrine::ui
