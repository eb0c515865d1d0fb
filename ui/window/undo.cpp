#include "ui/window/undo.h"

#include <QUndoCommand>

#include <algorithm>
#include <utility>
#include <vector>

namespace vitrine::ui {

Gesture newGesture()
{
    static Gesture last = 0;
    return ++last;
}

/// What an undo step keeps of a row.
struct RowChange {
    std::size_t exhibit = 0, row = 0;
    Value before, after;
};

namespace {

std::vector<RowChange> changesBetween(const Look& before, const Look& after)
{
    std::vector<RowChange> changes;
    for (std::size_t e = 0; e < before.values.size(); ++e)
        for (std::size_t r = 0; r < before.values[e].rows().size(); ++r)
            if (before.values[e].row(r) != after.values[e].row(r)) changes.push_back({e, r, before.values[e].row(r), after.values[e].row(r)});
    return changes;
}

}  // namespace

/// From one look to another. Keeps the rows that differ: looks are large, and an afternoon has thousands of steps.
class LookStep final : public QUndoCommand {
public:
    LookStep(History& history, const QString& text, const Look& after, Gesture gesture, History::Camera camera)
        : QUndoCommand(text), history_(history), changes_(changesBetween(history.look(), after)), cameraBefore_(history.look().camera),
          cameraAfter_(after.camera), gesture_(gesture), camera_(camera)
    {
    }

    [[nodiscard]] int id() const override { return gesture_ == 0 ? -1 : gesture_; }
    void redo() override
    {
        Look look = history_.look();
        for (const RowChange& change : changes_) look.values[change.exhibit].setRow(change.row, change.after);
        look.camera = cameraAfter_;
        history_.show(look, camera_);
    }
    void undo() override
    {
        Look look = history_.look();
        for (const RowChange& change : changes_) look.values[change.exhibit].setRow(change.row, change.before);
        look.camera = cameraBefore_;
        history_.show(look, camera_);
    }

    bool mergeWith(const QUndoCommand* next) override
    {
        const auto& later = *static_cast<const LookStep*>(next);
        for (const RowChange& change : later.changes_) {
            const auto known = std::find_if(changes_.begin(), changes_.end(), [&](const RowChange& c) { return c.exhibit == change.exhibit && c.row == change.row; });
            if (known == changes_.end()) changes_.push_back(change);
            else known->after = change.after;
        }
        std::erase_if(changes_, [](const RowChange& change) { return change.before == change.after; });
        cameraAfter_ = later.cameraAfter_;
        setObsolete(changes_.empty() && camera_ == History::Camera::stays);
        return true;
    }

private:
    History& history_;
    std::vector<RowChange> changes_;
    render::Camera cameraBefore_, cameraAfter_;
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
    stack_.push(new LookStep(*this, text, after, gesture, camera));
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
