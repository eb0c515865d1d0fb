#include "ui/model/history.h"

#include "exhibits/framework/files/table_change.h"
#include "ui/kit/language.h"
#include "ui/model/scene_state_change.h"

#include <QUndoCommand>

#include <memory>
#include <utility>

namespace vitrine::ui {

Gesture newGesture()
{
    static Gesture last = 0;
    return ++last;
}

/// Further work of an undo step, called before its change of the scene state.
struct SideEffects {
    std::function<void()> redo, undo;
};

/// Undo step: from one scene state to another, or another piece of work, such as deleting a preset.
class SceneStateStep final : public QUndoCommand {
public:
    SceneStateStep(History& history, const QString& text, SceneStateChange change, const render::Camera& cameraAfter,
                   Gesture gesture, History::Camera camera)
        : QUndoCommand(text), history_(history), change_(std::make_unique<SceneStateChange>(std::move(change))),
          cameraBefore_(history.sceneState().camera), cameraAfter_(cameraAfter), gesture_(gesture), camera_(camera)
    {
    }
    SceneStateStep(History& history, const QString& text, SceneStateChange change, const render::Camera& cameraAfter,
                   History::Camera camera, SideEffects effects)
        : SceneStateStep(history, text, std::move(change), cameraAfter, 0, camera)
    {
        effects_ = std::move(effects);
    }

    [[nodiscard]] int id() const override { return gesture_ == 0 ? -1 : gesture_; }
    void redo() override
    {
        if (effects_.redo) effects_.redo();
        change_->apply(history_.sceneState_);
        show(cameraAfter_);
    }
    void undo() override
    {
        if (effects_.undo) effects_.undo();
        change_->revert(history_.sceneState_);
        show(cameraBefore_);
    }

    bool mergeWith(const QUndoCommand* next) override
    {
        const auto& later = *static_cast<const SceneStateStep*>(next);
        change_->append(*later.change_);
        cameraAfter_ = later.cameraAfter_;
        setObsolete(change_->empty() && camera_ == History::Camera::stays);
        return true;
    }

    /// Change of the scene state; `History::exchangeTables` appends to it.
    [[nodiscard]] SceneStateChange& change() const { return *change_; }

private:
    void show(const render::Camera& camera)
    {
        if (camera_ == History::Camera::moves) history_.sceneState_.camera = camera;
        history_.noteChange(*change_, camera_);
    }

    History& history_;
    std::unique_ptr<SceneStateChange> change_;
    render::Camera cameraBefore_, cameraAfter_;
    Gesture gesture_;
    History::Camera camera_;
    SideEffects effects_;
};

History::History(SceneState start, QObject* parent) : QObject(parent), sceneState_(std::move(start)) {}

QMetaObject::Connection History::watch(std::size_t exhibit, const QObject* owner,
                                       std::function<void(std::optional<std::size_t> row)> callback)
{
    ExhibitChanges*& changes = watched_[exhibit];
    if (!changes) changes = new ExhibitChanges(this);
    return connect(changes, &ExhibitChanges::changed, owner, std::move(callback));
}

void History::noteChange(const SceneStateChange& change, Camera camera)
{
    const std::set<std::size_t> exhibits = change.exhibits();
    if (const auto one = change.onlyParameter(sceneState_)) {
        emit changed(one->first, one->second);
        tellWatchers(one->first, one->second);
        settleSoon(exhibits);
    } else if (camera == Camera::moves || !change.empty()) {
        noteReplaced(exhibits);
    } else {
        settleSoon({});
    }
    if (camera == Camera::moves) emit cameraMoved();
}

void History::noteReplaced(const std::set<std::size_t>& exhibits)
{
    emit replaced();
    for (const std::size_t exhibit : exhibits) tellWatchers(exhibit, std::nullopt);
    settleSoon(exhibits);
}

void History::tellWatchers(std::size_t exhibit, std::optional<std::size_t> row)
{
    if (const auto found = watched_.find(exhibit); found != watched_.end()) emit found->second->changed(row);
}

void History::settleSoon(const std::set<std::size_t>& exhibits)
{
    unsettled_.insert(exhibits.begin(), exhibits.end());
    if (std::exchange(settling_, true)) return;
    const auto settle = [this] {
        settling_ = false;
        emit changesSettled(std::exchange(unsettled_, {}));
    };
    QMetaObject::invokeMethod(this, settle, Qt::QueuedConnection);
}

SceneState History::valuesAt(int step) const
{
    const auto changeOf = [this](int i) -> const SceneStateChange& {
        return static_cast<const SceneStateStep*>(stack_.command(i))->change();  // Only `SceneStateStep`s are pushed.
    };
    SceneState state = sceneState_;
    for (int i = stack_.index(); i > step; --i) changeOf(i - 1).revert(state);
    for (int i = stack_.index(); i < step; ++i) changeOf(i).apply(state);
    return state;
}

void History::set(std::size_t exhibit, std::size_t row, const Value& value, Gesture gesture, const QString& text)
{
    const ParameterValues& values = sceneState_.values[exhibit];
    const ParameterInfo& info = values.rows()[row];
    const std::optional<Value> legal = nearestLegal(info, value);
    const bool moves = values.motion(row) != nullptr;
    if (!legal || (*legal == values.row(row) && !moves)) return;
    gesture_ = gesture;
    SceneStateChange change(sceneState_, exhibit, row, *legal);
    if (info.kind == Kind::file || moves) {
        SceneState after = sceneState_;
        after.values[exhibit].setMotion(row, std::nullopt);
        after.values[exhibit].chooseFile(row, *legal);
        change = SceneStateChange(sceneState_, after);
    }
    const QString step = text.isEmpty() ? tr("Change %1").arg(midSentence(translatedText(label(info)))) : text;
    stack_.push(new SceneStateStep(*this, step, std::move(change), sceneState_.camera, gesture, Camera::stays));
}

void History::change(const QString& text, const SceneState& wanted, Gesture gesture, Camera camera)
{
    SceneState after = wanted;
    for (std::size_t e = 0; e < after.values.size(); ++e)
        after.values[e] = withTableOf(sceneState_.values[e], after.values[e]);
    SceneStateChange change(sceneState_, after);
    if (change.empty() && (camera == Camera::stays || after.camera == sceneState_.camera)) return;
    gesture_ = gesture;
    stack_.push(new SceneStateStep(*this, text, std::move(change), after.camera, gesture, camera));
}

void History::record(const QString& text, std::function<void()> redo, std::function<void()> undo)
{
    record(text, sceneState_, std::move(redo), std::move(undo));
}

void History::record(const QString& text, const SceneState& after, std::function<void()> redo,
                     std::function<void()> undo, Camera camera)
{
    gesture_ = 0;
    stack_.push(new SceneStateStep(*this, text, SceneStateChange(sceneState_, after), after.camera, camera,
                                   SideEffects{std::move(redo), std::move(undo)}));
}

void History::exchangeTables(const SceneState& tabled)
{
    SceneState after = sceneState_;
    for (std::size_t e = 0; e < after.values.size(); ++e)
        after.values[e] = withTableOf(tabled.values[e], after.values[e]);
    const SceneStateChange change(sceneState_, after);
    if (change.empty()) return;
    if (const QUndoCommand* last = stack_.index() > 0 ? stack_.command(stack_.index() - 1) : nullptr)
        static_cast<const SceneStateStep*>(last)->change().append(change);  // Only `SceneStateStep`s are pushed.
    change.apply(sceneState_);
    gesture_ = 0;
    noteReplaced(change.exhibits());
}

void History::settle(const SceneState& after)
{
    if (sceneState_.values == after.values) return;
    const std::set<std::size_t> exhibits = SceneStateChange(sceneState_, after).exhibits();
    sceneState_.values = after.values;
    gesture_ = 0;
    noteReplaced(exhibits);
}

void History::restart(const SceneState& sceneState)
{
    stack_.clear();
    sceneState_ = sceneState;
    std::set<std::size_t> all;
    for (std::size_t e = 0; e < sceneState_.values.size(); ++e) all.insert(e);
    noteReplaced(all);
    emit cameraMoved();
}

}  // namespace vitrine::ui

#include "moc_history.cpp"
