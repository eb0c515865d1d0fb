#include "ui/window/session_keeper.h"

#include "exhibits/framework/preset.h"
#include "exhibits/framework/state_folder.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/presets/scene_text.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QDockWidget>
#include <QEvent>
#include <QSettings>

namespace vitrine::ui {
namespace {

constexpr int quietBeforeWriting = 2000;  // Milliseconds.
constexpr int longestWait = 10000;
constexpr int settledAfter = 60000;
constexpr int mostTimesRestored = 3;
constexpr int layoutVersion = 1;

QString settingsPath(const std::filesystem::path& folder)
{
    return QString::fromStdString((folder / "window.ini").string());
}

}  // namespace

SessionKeeper::SessionKeeper(MainWindow& window)
    : QObject(&window), window_(window), folder_(stateFolder()), journal_(folder_ / "recovery")
{
    quiet_.setSingleShot(true);
    quiet_.setInterval(quietBeforeWriting);
    connect(&quiet_, &QTimer::timeout, this, &SessionKeeper::write);
    settled_.setSingleShot(true);
    settled_.setInterval(settledAfter);
    connect(&settled_, &QTimer::timeout, this, [this] { setTimesRestored(0); });
}

void SessionKeeper::noteChange()
{
    changed_ = true;
    noteLayout();
}

void SessionKeeper::noteLayout()
{
    if (closed_) return;
    // Restarts the quiet time, unless that would put it off for too long.
    if (!quiet_.isActive()) sinceWritten_.start();
    if (!quiet_.isActive() || sinceWritten_.elapsed() < longestWait - quietBeforeWriting) quiet_.start();
}

void SessionKeeper::watch()
{
    connect(&window_.history(), &History::changed, this, &SessionKeeper::noteChange);
    connect(&window_.history(), &History::replaced, this, &SessionKeeper::noteChange);
    window_.installEventFilter(this);
    for (const QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
        connect(dock, &QDockWidget::visibilityChanged, this, &SessionKeeper::noteLayout);
        connect(dock, &QDockWidget::dockLocationChanged, this, &SessionKeeper::noteLayout);
        connect(dock, &QDockWidget::topLevelChanged, this, &SessionKeeper::noteLayout);
    }
}

bool SessionKeeper::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::Move || event->type() == QEvent::WindowStateChange)
        noteLayout();
    return QObject::eventFilter(watched, event);
}

void SessionKeeper::write()
{
    if (!writeJournal()) return;
    saveLayout();
    if (changed_) setTimesRestored(0);
}

bool SessionKeeper::writeJournal()
{
    try {
        journal_.write(textOf(window_.museum(), window_.history().sceneState(), window_.chosen(), "Journal"));
        return true;
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, said(failure.what()));
        return false;
    }
}

bool SessionKeeper::restoreSceneState(const std::string& text, const std::string& fileName)
{
    try {
        std::vector<std::string> notes;
        std::size_t chosen = 0;
        window_.history().restart(lookFrom(window_.museum(), text, fileName, notes, &chosen));
        window_.choose(chosen);
        return true;
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, said(failure.what()));
        return false;
    }
}

bool SessionKeeper::restoreCrash()
{
    for (const AbandonedSession& session : journal_.abandoned()) {
        const int before = timesRestored();
        const bool again = before < mostTimesRestored;
        if (again && restoreSceneState(session.text, session.path.string())) {
            setTimesRestored(before + 1);
            settled_.start();
            if (writeJournal()) journal_.discard(session);  // Before that, it is all there is.
            window_.say(MessageStrip::Mood::notice,
                        tr("Vitrine crashed or was stopped; your last state was restored."));
            return true;
        }
        const QString kept = QString::fromStdString(journal_.putAside(session).string());
        if (again) continue;
        setTimesRestored(0);
        window_.say(MessageStrip::Mood::problem, tr("Your last state was restored %1 times, and each time Vitrine "
                                                    "crashed or was stopped soon after. It is not restored again; "
                                                    "File > Open brings it back from %2.")
                                                     .arg(mostTimesRestored)
                                                     .arg(kept));
    }
    return false;
}

bool SessionKeeper::restore()
{
    restoreLayout();
    if (restoreCrash()) return true;
    const std::filesystem::path file = folder_ / "session.json";
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return false;
    try {
        return restoreSceneState(render::readFile(file, presetLimits.bytes), file.string());
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, said(failure.what()));
        return false;
    }
}

void SessionKeeper::close()
{
    closed_ = true;
    quiet_.stop();
    settled_.stop();
    try {
        render::atomicWriteMakingFolder(
            folder_ / "session.json",
            textOf(window_.museum(), window_.history().sceneState(), window_.chosen(), "Last session"));
        saveLayout();
        setTimesRestored(0);
        journal_.cleanExit();
    } catch (const std::exception& failure) {
        // The window is closing: the journal stays and brings everything back.
        writeJournal();
        qWarning("%s", failure.what());
    }
}

void SessionKeeper::saveLayout() const
{
    QSettings settings(settingsPath(folder_), QSettings::IniFormat);
    settings.setValue(QStringLiteral("geometry"), window_.saveGeometry());
    if (!window_.bare()) settings.setValue(QStringLiteral("docks"), window_.saveState(layoutVersion));
    settings.setValue(QStringLiteral("folded"), window_.panel().foldedGroups());
    settings.setValue(QStringLiteral("locked"), window_.panel().lockedRows());
    settings.setValue(QStringLiteral("chosen"), text(window_.museum().subject(window_.chosen()).name()));
}

void SessionKeeper::restoreLayout()
{
    QSettings settings(settingsPath(folder_), QSettings::IniFormat);
    window_.restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
    window_.restoreState(settings.value(QStringLiteral("docks")).toByteArray(), layoutVersion);
    window_.panel().setLockedRows(settings.value(QStringLiteral("locked")).toStringList());
    window_.panel().setFoldedGroups(settings.value(QStringLiteral("folded")).toStringList());
    const std::string chosen = settings.value(QStringLiteral("chosen")).toString().toStdString();
    if (const auto found = window_.museum().find(chosen)) window_.choose(*found);
}

int SessionKeeper::timesRestored() const
{
    return QSettings(settingsPath(folder_), QSettings::IniFormat).value(QStringLiteral("timesRestored")).toInt();
}

void SessionKeeper::setTimesRestored(int times) const
{
    QSettings(settingsPath(folder_), QSettings::IniFormat).setValue(QStringLiteral("timesRestored"), times);
}

}  // namespace vitrine::ui

#include "moc_session_keeper.cpp"
