#include "ui/viewport/picture_input.h"

#include "exhibits/framework/scene/takes_input.h"
#include "ui/viewport/viewport.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <cmath>
#include <map>
#include <utility>

namespace vitrine::ui {
namespace {

/// Returns the code that browsers give a key; nothing for keys without one.
std::optional<int> browserCode(int key)
{
    if ((key >= Qt::Key_A && key <= Qt::Key_Z) || (key >= Qt::Key_0 && key <= Qt::Key_9) || key == Qt::Key_Space)
        return key;
    static const std::map<int, int> codes{
        {Qt::Key_Backspace, 8},     {Qt::Key_Return, 13},       {Qt::Key_Enter, 13},  {Qt::Key_Shift, 16},
        {Qt::Key_PageUp, 33},       {Qt::Key_PageDown, 34},     {Qt::Key_End, 35},    {Qt::Key_Home, 36},
        {Qt::Key_Left, 37},         {Qt::Key_Up, 38},           {Qt::Key_Right, 39},  {Qt::Key_Down, 40},
        {Qt::Key_Insert, 45},       {Qt::Key_Delete, 46},       {Qt::Key_Comma, 188}, {Qt::Key_Minus, 189},
        {Qt::Key_Period, 190},      {Qt::Key_Slash, 191},       {Qt::Key_Equal, 187}, {Qt::Key_Semicolon, 186},
        {Qt::Key_BracketLeft, 219}, {Qt::Key_BracketRight, 221}};
    const auto found = codes.find(key);
    return found == codes.end() ? std::nullopt : std::optional(found->second);
}

constexpr double grabHandleWithin = 12;  ///< Pixels between pointer and handle.

}  // namespace

PictureInput::PictureInput(const Museum& museum, History& history, Viewport& viewport,
                           std::function<std::size_t()> chosen, QObject* parent)
    : QObject(parent), museum_(museum), history_(history), viewport_(viewport), chosen_(std::move(chosen))
{
    viewport.installEventFilter(this);
}

const TakesInput* PictureInput::source() const
{
    return capability<TakesInput>(museum_.subject(chosen_()));
}

ExhibitState PictureInput::state(std::size_t exhibit) const
{
    return {history_.sceneState().values[exhibit], viewport_.clock().time()};
}

render::Ray PictureInput::rayAt(std::size_t exhibit, const QPointF& at) const
{
    const render::View view = viewport_.scene().view();
    const glm::dvec2 ndc(2 * at.x() / viewport_.width() - 1, 1 - 2 * at.y() / viewport_.height());
    const render::Ray ray{view.eye, glm::normalize(view.direction(ndc))};
    return ray.transformed(glm::inverse(museum_.worldFromExhibit(exhibit)));
}

bool PictureInput::press(const QPointF& at)
{
    const TakesInput* source = this->source();
    if (!source) return false;
    const std::size_t exhibit = chosen_();
    const render::Ray ray = rayAt(exhibit, at), beside = rayAt(exhibit, at + QPointF(grabHandleWithin, 0));
    // Meters that the pixels cover at the distance of the exhibit's origin.
    const double distance = glm::length(ray.origin);
    const double reach = distance * glm::length(ray.direction - beside.direction) / glm::length(ray.direction);
    const std::optional<std::size_t> grip = source->gripUnder(state(exhibit), ray, reach);
    if (!grip) return false;
    drag_ = Drag{exhibit, *grip, at, newGesture()};
    return point(at, PointerEvent::press);
}

bool PictureInput::point(const QPointF& at, PointerEvent event)
{
    const TakesInput* source = this->source();
    if (!drag_) return false;
    drag_->last = at;
    if (source && drag_->exhibit == chosen_()) {
        SceneState after = history_.sceneState();
        for (const auto& [row, value] :
             source->pointed(state(drag_->exhibit), drag_->grip, event, rayAt(drag_->exhibit, at)))
            after.values[drag_->exhibit].setParameter(row, value);
        history_.change(tr("Point in the picture"), after, drag_->gesture);
    }
    if (event == PointerEvent::release) drag_.reset();
    return true;
}

bool PictureInput::takesKey(const QKeyEvent& event) const
{
    const bool isPlain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    const TakesInput* source = this->source();
    return isPlain && source && browserCode(event.key()) && source->takesKeys(state(chosen_()));
}

bool PictureInput::key(const QKeyEvent& event, bool isDown)
{
    const std::optional<int> code = browserCode(event.key());
    if (isDown ? !takesKey(event) : !code || !held_.contains(*code)) return false;
    if (event.isAutoRepeat()) return true;
    if (held_.empty()) keyed_ = chosen_();
    if (typing_ == 0) typing_ = newGesture();
    const TakesInput* source = capability<TakesInput>(museum_.subject(keyed_));
    SceneState after = history_.sceneState();
    for (const auto& [row, value] : source->keyed(state(keyed_), *code, isDown))
        after.values[keyed_].setParameter(row, value);
    history_.change(tr("Keys in the picture"), after, typing_);
    if (isDown)
        held_.insert(*code);
    else
        held_.erase(*code);
    return true;
}

void PictureInput::letGo()
{
    const TakesInput* source = held_.empty() ? nullptr : capability<TakesInput>(museum_.subject(keyed_));
    if (source) {
        SceneState after = history_.sceneState();
        for (const int code : held_)
            for (const auto& [row, value] :
                 source->keyed({after.values[keyed_], viewport_.clock().time()}, code, false))
                after.values[keyed_].setParameter(row, value);
        history_.change(tr("Keys in the picture"), after, typing_);
    }
    held_.clear();
    typing_ = 0;
    if (drag_) point(drag_->last, PointerEvent::release);
}

bool PictureInput::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress: {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        if (mouse.button() == Qt::LeftButton && !drag_ && press(mouse.position())) return true;
        break;
    }
    case QEvent::MouseMove:
        if (drag_) return point(static_cast<QMouseEvent*>(event)->position(), PointerEvent::move);
        break;
    case QEvent::MouseButtonRelease:
        if (drag_ && static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton)
            return point(static_cast<QMouseEvent*>(event)->position(), PointerEvent::release);
        break;
    case QEvent::ShortcutOverride:
        if (!takesKey(*static_cast<QKeyEvent*>(event))) break;
        event->accept();
        return true;
    case QEvent::KeyPress:
        if (key(*static_cast<QKeyEvent*>(event), true)) return true;
        break;
    case QEvent::KeyRelease:
        if (key(*static_cast<QKeyEvent*>(event), false)) return true;
        break;
    case QEvent::FocusOut: letGo(); break;
    default: break;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace vitrine::ui

#include "moc_picture_input.cpp"
