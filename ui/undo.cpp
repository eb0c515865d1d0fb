#include "ui/undo.h"

#include <QUndoCommand>

#include <utility>

namespace vitrine::ui {

Gesture newGesture()
{
    static Gesture last = 0;
    return ++last;
}

/// From one look to another.
class LookStep final : public QUndoCommand {
public:
    LookStep(History& history, const QString& text, Look after, Gesture gesture, History::Camera camera)
        : QUndoCommand(text), history_(history), before_(history.look()), after_(std::move(after)), gesture_(gesture),
          camera_(camera)
    {
    }

    [[nodiscard]] int id() const override { return gesture_ == 0 ? -1 : gesture_; }
    void redo() override { history_.show(after_, camera_); }
    void undo() override { history_.show(before_, camera_); }

    bool mergeWith(const QUndoCommand* next) override
    {
        after_ = static_cast<const LookStep*>(next)->after_;
        setObsolete(after_.values == before_.values && camera_ == History::Camera::stays);
        return true;
    }

private:
    History& history_;
    Look before_, after_;
    Gesture gesture_;
    History::Camera camera_;
};

namespace {

class OtherStep final : public QUndoCommand {
public:
    OtherStep(const QString& text, std::function<void()> redo, std::function<void()> undo)
        : QUndoCommand(text), redo_(std::move(redo)), undo_(std::move(undo))
    {
    }
    void redo() override { redo_(); }
    void undo() override { undo_(); }

private:
    std::function<void()> redo_, undo_;
};

}  // namespace

History::History(Look start, QObject* parent) : QObject(parent), look_(std::move(start)) {}

void History::change(const QString& text, Look after, Gesture gesture, Camera camera)
{
    const bool sameCamera = camera == Camera::stays || after.camera == look_.camera;
    if (after.values == look_.values && sameCamera) return;
    stack_.push(new LookStep(*this, text, std::move(after), gesture, camera));
}

void History::record(const QString& text, std::function<void()> redo, std::function<void()> undo)
{
    stack_.push(new OtherStep(text, std::move(redo), std::move(undo)));
}

void History::restart(Look look)
{
    stack_.clear();
    show(look, Camera::moves);
}

void History::show(const Look& look, Camera camera)
{
    look_.values = look.values;
    if (camera == Camera::moves) look_.camera = look.camera;
    emit changed();
    if (camera == Camera::moves) emit cameraMoved();
}

}  // namespace vitrine::ui

#include "moc_undo.cpp"
