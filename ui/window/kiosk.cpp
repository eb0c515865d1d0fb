#include "ui/window/kiosk.h"

#include "render/failure.h"
#include "render/text/nearest_word.h"
#include "ui/controllers/controllers.h"
#include "ui/gamepad/gamepad_control.h"
#include "ui/viewport/parameter_drag.h"
#include "ui/viewport/viewport.h"
#include "ui/window/kiosk_panel.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QKeyEvent>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::ui {
namespace {

/// Keys that walk, visit and leave exhibits, press their buttons, zoom, and move the focus.
constexpr std::array kioskKeys{Qt::Key_W,     Qt::Key_A,       Qt::Key_S,      Qt::Key_D,     Qt::Key_E,
                               Qt::Key_Up,    Qt::Key_Down,    Qt::Key_Left,   Qt::Key_Right, Qt::Key_Shift,
                               Qt::Key_Tab,   Qt::Key_Backtab, Qt::Key_Return, Qt::Key_Enter, Qt::Key_Plus,
                               Qt::Key_Minus, Qt::Key_Escape};

constexpr auto commandModifiers = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;

bool leaves(const QKeyEvent& event)
{
    return event.key() == Qt::Key_Q && event.modifiers() == (Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier);
}

/// Returns the place of a parameter "exhibit.parameter". Throws Failure (ErrorKind::usage) naming what is wrong.
KioskPanel::Place placeOf(const Museum& museum, const std::string& name)
{
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos)
        throw Failure(ErrorKind::usage, "--kiosk-parameters " + name + ": give it as exhibit.parameter.");
    const std::string exhibit = name.substr(0, dot), parameter = name.substr(dot + 1);
    std::vector<std::string> names;
    for (const SceneObject* each : museum.subjects()) names.emplace_back(each->name());
    const auto subject = museum.find(exhibit);
    if (!subject)
        throw Failure(ErrorKind::usage, "--kiosk-parameters " + name + ": there is no exhibit \"" + exhibit + '"' +
                                            didYouMean(exhibit, names) + " `vitrine list` names them.");
    const Parameters& table = museum.subject(*subject).parameters();
    names.clear();
    for (const ParameterInfo& row : table.rows()) names.emplace_back(row.name);
    const auto row = table.find(parameter);
    if (!row)
        throw Failure(ErrorKind::usage, "--kiosk-parameters " + name + ": " + exhibit +
                                            " has no parameter of that name" + didYouMean(parameter, names) +
                                            " `vitrine list " + exhibit + "` names them.");
    if (table.rows()[*row].isWritten())
        throw Failure(ErrorKind::usage,
                      "--kiosk-parameters " + name + ": visitors cannot choose files or texts; leave it out.");
    return {*subject, *row};
}

/// Returns whether mouse input is a walk, a click or a turn of the wheel, and no command.
bool isPlainMouse(const QEvent& event)
{
    if (event.type() == QEvent::Wheel) return !(static_cast<const QWheelEvent&>(event).modifiers() & commandModifiers);
    const auto& mouse = static_cast<const QMouseEvent&>(event);
    return mouse.button() == Qt::LeftButton && !(mouse.modifiers() & commandModifiers);
}

}  // namespace

Kiosk::Kiosk(MainWindow& window, const KioskOptions& options) : window_(window), start_(window.history().sceneState())
{
    std::vector<KioskPanel::Place> places;
    for (const std::string& name : options.parameters) places.push_back(placeOf(window_.museum(), name));
    window_.hidePanels(true);
    window_.setWindowState(window_.windowState() | Qt::WindowFullScreen);
    if (!places.empty()) panel_ = new KioskPanel(window_.viewport(), window_.museum(), window_.history(), places);
    ignoreOtherInput();
    QStringList allowed;
    for (const std::string& name : options.parameters)
        allowed << QString::fromStdString(name).replace(QLatin1Char('.'), QLatin1Char('/'));
    if (auto* controllers = window_.findChild<Controllers*>()) controllers->limitTo(allowed);
    idle_.setSingleShot(true);
    idle_.setInterval(static_cast<int>(std::lround(options.minutes * 60'000)));
    connect(&idle_, &QTimer::timeout, this, &Kiosk::beginAnew);
    // Gamepads and services change the state without events of this window.
    connect(&window_.history(), &History::walked, this, &Kiosk::noteChange);
    connect(&window_.history(), &History::changesSettled, this, &Kiosk::noteChange);
    connect(&window_.viewport().visitor(), &Visitor::visited, this, &Kiosk::follow);
    connect(&window_.viewport().visitor(), &Visitor::headedFor, this, &Kiosk::follow);
    connect(&window_.viewport().visitor(), &Visitor::walkedOn, this, &Kiosk::follow);
    qApp->installEventFilter(this);
    follow();
}

Kiosk::~Kiosk()
{
    delete panel_;
}

void Kiosk::ignoreOtherInput()
{
    window_.setAcceptDrops(false);
    if (auto* drag = window_.findChild<ParameterDrag*>()) window_.viewport().removeEventFilter(drag);
    auto* gamepad = window_.findChild<GamepadControl*>();
    if (!gamepad) return;
    disconnect(gamepad, &GamepadControl::pauseAsked, &window_, nullptr);
    disconnect(gamepad, &GamepadControl::parameterRequested, &window_, nullptr);
    disconnect(gamepad, &GamepadControl::changeAsked, &window_, nullptr);
}

void Kiosk::noteInput()
{
    idle_.start();
}

void Kiosk::noteChange()
{
    if (!(window_.history().sceneState() == start_)) noteInput();  // Beginning anew is no input.
}

void Kiosk::follow()
{
    if (panel_) panel_->follow(window_.chosen());
}

void Kiosk::beginAnew()
{
    if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    if (QWidget* dialog = QApplication::activeModalWidget()) dialog->close();
    window_.history().restart(start_);
    window_.choose(hallIndex);
    window_.viewport().setFocus();
    follow();
    idle_.stop();
}

bool Kiosk::passes(const QKeyEvent& event) const
{
    if (event.modifiers() & commandModifiers) return false;
    const QWidget* focused = QApplication::focusWidget();
    if (focused && focused != &window_.viewport() && focused != &window_) return true;  // In the panel.
    return std::find(kioskKeys.begin(), kioskKeys.end(), event.key()) != kioskKeys.end();
}

bool Kiosk::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::KeyPress: {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (leaves(key)) {
            leaving_ = true;
            window_.close();
            return true;
        }
        noteInput();
        return !passes(key);
    }
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::Wheel: noteInput(); return !isPlainMouse(*event);
    case QEvent::MouseMove:
    case QEvent::TouchBegin: noteInput(); return false;
    case QEvent::Shortcut:
    case QEvent::ContextMenu: return true;
    case QEvent::Close:
        if (watched != &window_ || leaving_) return false;
        event->ignore();
        return true;
    default: return false;
    }
}

}  // namespace vitrine::ui

#include "moc_kiosk.cpp"
