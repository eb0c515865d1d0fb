#include "ui/model/history.h"

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
            if (before.values[e].row(r) != after.values[e].row(r))
                changes.push_back({e, r, before.values[e].row(r), after.values[e].row(r)});
    return changes;
}

}  // namespace

/// From one look to another. Keeps the rows that differ: looks are large, and an afternoon has thousands of steps.
class LookStep final : public QUndoCommand {
public:
    LookStep(History& history, const QString& text, std::vector<RowChange> changes, const render::Camera& cameraAfter,
             Gesture gesture, History::Camera camera)
        : QUndoCommand(text), history_(history), changes_(std::move(changes)), cameraBefore_(history.look().camera),
          cameraAfter_(cameraAfter), gesture_(gesture), camera_(camera)
    {
    }

    [[nodiscard]] int id() const override { return gesture_ == 0 ? -1 : gesture_; }
    void redo() override { show(&RowChange::after, cameraAfter_); }
    void undo() override { show(&RowChange::before, cameraBefore_); }

    bool mergeWith(const QUndoCommand* next) override
    {
        const auto& later = *static_cast<const LookStep*>(next);
        for (const RowChange& change : later.changes_) {
            const auto known = std::find_if(changes_.begin(), changes_.end(), [&](const RowChange& c) {
                return c.exhibit == change.exhibit && c.row == change.row;
            });
            if (known == changes_.end())
                changes_.push_back(change);
            else
                known->after = change.after;
        }
        std::erase_if(changes_, [](const RowChange& change) { return change.before == change.after; });
        cameraAfter_ = later.cameraAfter_;
        setObsolete(changes_.empty() && camera_ == History::Camera::stays);
        return true;
    }

private:
    void show(Value RowChange::*value, const render::Camera& camera)
    {
        Look& look = history_.look_;
        for (const RowChange& change : changes_) look.values[change.exhibit].setRow(change.row, change.*value);
        if (camera_ == History::Camera::moves) look.camera = camera;
        if (changes_.size() == 1)
            emit history_.changed(changes_.front().exhibit, changes_.front().row);
        else
            emit history_.replaced();
        if (camera_ == History::Camera::moves) emit history_.cameraMoved();
    }

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

void History::set(std::size_t exhibit, std::size_t row, const Value& value, Gesture gesture, const QString& text)
{
    const ParameterValues& values = look_.values[exhibit];
    const ParameterInfo& info = values.rows()[row];
    const std::optional<Value> legal = nearestLegal(info, value);
    if (!legal || *legal == values.row(row)) return;
    gesture_ = gesture;
    const QString step = text.isEmpty() ? tr("Change %1").arg(QString::fromStdString(label(info)).toLower()) : text;
    stack_.push(
        new LookStep(*this, step, {{exhibit, row, values.row(row), *legal}}, look_.camera, gesture, Camera::stays));
}

void History::change(const QString& text, const Look& after, Gesture gesture, Camera camera)
{
    std::vector<RowChange> changes = changesBetween(look_, after);
    if (changes.empty() && (camera == Camera::stays || after.camera == look_.camera)) return;
    gesture_ = gesture;
    stack_.push(new LookStep(*this, text, std::move(changes), after.camera, gesture, camera));
}

void History::record(const QString& text, std::function<void()> redo, std::function<void()> undo)
{
    stack_.push(new OtherStep(text, std::move(redo), std::move(undo)));
}

void History::restart(const Look& look)
{
    stack_.clear();
    look_ = look;
    emit replaced();
    emit cameraMoved();
}

}  // namespace vitrine::ui

#include "moc_history.cpp"
