#include "ui/window/session_keeper.h"

#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/files/state_folder.h"
#include "render/files/read_file.h"
#include "ui/kit/ini_file.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/text.h"
#include "ui/kit/window_place.h"
#include "ui/parameters/panel_choices.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/presets/scene_text.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QDockWidget>
#include <QEvent>
#include <QFile>
#include <QSettings>

#include <algorithm>
#include <array>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int oldestUnwritten = 2000;  // Milliseconds from a change to its writing.
constexpr int settledAfter = 60000;
constexpr int mostTimesRestored = 3;
constexpr int layoutVersion = 1;

/// Choices of the parameter panel that are kept between sessions, each with its key in the settings.
constexpr std::array<std::pair<PanelChoice, const char*>, 3> keptChoices{
    {{PanelChoice::toggled, "toggledGroups"}, {PanelChoice::locked, "locked"}, {PanelChoice::pinned, "pinned"}}};

QString settingsPath(const std::filesystem::path& folder)
{
    return QString::fromStdString((folder / "window.ini").string());
}

}  // namespace

SessionKeeper::SessionKeeper(MainWindow& window)
    : QObject(&window), window_(window), folder_(stateFolder()), journal_(folder_ / "recovery")
{
    due_.setSingleShot(true);
    due_.setInterval(oldestUnwritten);
    due_.setTimerType(Qt::PreciseTimer);
    connect(&due_, &QTimer::timeout, this, &SessionKeeper::write);
    settled_.setSingleShot(true);
    settled_.setInterval(settledAfter);
    connect(&settled_, &QTimer::timeout, this, [this] { setTimesRestored(0); });
}

void SessionKeeper::noteChange()
{
    changed_ = true;
    noteLayout();
}

void SessionKeeper::noteWalk()
{
    if (!closed_ && !due_.isActive()) due_.start();
}

void SessionKeeper::noteLayout()
{
    layoutChanged_ = true;
    noteWalk();
}

void SessionKeeper::watch()
{
    connect(&window_.history(), &History::changed, this, &SessionKeeper::noteChange);
    connect(&window_.history(), &History::replaced, this, &SessionKeeper::noteChange);
    connect(&window_.history(), &History::cameraMoved, this, &SessionKeeper::noteWalk);
    connect(&window_.history(), &History::walked, this, &SessionKeeper::noteWalk);
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
    writeJournalLater();
    if (std::exchange(layoutChanged_, false)) saveLayout();
    if (changed_) setTimesRestored(0);
}

void SessionKeeper::writeJournalLater()
{
    if (writing_.valid()) writing_.get();
    // On a thread, because a slow disk would block walking.
    writing_ = std::async(std::launch::async, [this, text = journalText()] {
        std::string why;
        try {
            journal_.write(text);
        } catch (const std::exception& failure) {
            why = failure.what();
        }
        // One message for all attempts; it is removed after the first success.
        QMetaObject::invokeMethod(
            this,
            [this, why] {
                window_.setProblems(QStringLiteral("journal"),
                                    why.empty() ? QStringList() : QStringList(translatedText(why)));
            },
            Qt::QueuedConnection);
    });
}

std::string SessionKeeper::journalText() const
{
    return textOf(window_.museum(), window_.history().sceneState(), window_.chosen(), "Journal");
}

bool SessionKeeper::writeJournal()
{
    if (writing_.valid()) writing_.get();
    try {
        journal_.write(journalText());
        return true;
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, messageOf(failure));
        return false;
    }
}

std::optional<std::vector<std::string>> SessionKeeper::restoreSceneState(const std::string& text,
                                                                         const std::string& fileName)
{
    try {
        std::vector<std::string> notes;
        std::size_t chosen = 0;
        window_.history().restart(lookFrom(window_.museum(), text, fileName, notes, &chosen));
        window_.choose(chosen);
        return notes;
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, messageOf(failure));
        return std::nullopt;
    }
}

QString SessionKeeper::changesText(const std::vector<std::string>& notes)
{
    constexpr std::size_t mostNamed = 8;
    QStringList lines;
    for (std::size_t i = 0; i < std::min(notes.size(), mostNamed); ++i) lines << translatedText(notes[i]);
    if (notes.size() > mostNamed) lines << tr("and %1 more").arg(notes.size() - mostNamed);
    return lines.join(QStringLiteral("\n    "));
}

QString SessionKeeper::putSessionAside() const
{
    const QDir folder(QString::fromStdString(folder_.string()));
    QString name = QStringLiteral("aside-session.json");
    for (int i = 2; folder.exists(name); ++i) name = QStringLiteral("aside-session-%1.json").arg(i);
    return QFile::copy(folder.filePath(QStringLiteral("session.json")), folder.filePath(name)) ? folder.filePath(name)
                                                                                               : QString();
}

bool SessionKeeper::restoreCrash()
{
    for (const AbandonedSession& session : journal_.abandoned()) {
        const int before = timesRestored();
        const bool again = before < mostTimesRestored;
        const auto notes = again ? restoreSceneState(session.text, session.path.string()) : std::nullopt;
        if (notes) {
            setTimesRestored(before + 1);
            settled_.start();
            QString message = tr("Vitrine crashed or was stopped; your last state was restored.");
            if (!notes->empty()) {
                const QString kept = QString::fromStdString(journal_.putAside(session).string());
                (message += ' ') +=
                    tr("Parts of the session are unknown to this version; it was kept as %1:").arg(kept);
                (message += QStringLiteral("\n    ")) += changesText(*notes);
                writeJournal();
            } else if (writeJournal()) {
                journal_.discard(session);  // Discarded only now, because before it was the only copy.
            }
            window_.say(MessageStrip::Mood::notice, message);
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
    std::optional<std::vector<std::string>> notes;
    try {
        notes = restoreSceneState(render::readFile(file, presetLimits.bytes), file.string());
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, messageOf(failure));
    }
    if (notes && notes->empty()) return true;
    const QString kept = putSessionAside();
    if (notes)
        window_.say(MessageStrip::Mood::notice,
                    tr("Your last session was restored.") + QLatin1Char(' ') +
                        tr("Parts of the session are unknown to this version; it was kept as %1:").arg(kept) +
                        QStringLiteral("\n    ") + changesText(*notes));
    else if (!kept.isEmpty())
        window_.say(MessageStrip::Mood::problem,
                    tr("Your last session could not be restored and was kept as %1.").arg(kept));
    return notes.has_value();
}

void SessionKeeper::close()
{
    closed_ = true;
    due_.stop();
    settled_.stop();
    if (writing_.valid()) writing_.get();
    try {
        writeOwnFile(folder_ / "session.json",
                     textOf(window_.museum(), window_.history().sceneState(), window_.chosen(), "Last session"));
        saveLayout();
        setTimesRestored(0);
        journal_.cleanExit();
    } catch (const std::exception& failure) {
        // The window is closing: the journal stays and restores everything next time.
        writeJournal();
        qWarning("%s", failure.what());
    }
}

void SessionKeeper::saveLayout() const
{
    QSettings settings(iniPath(settingsPath(folder_)), QSettings::IniFormat);
    settings.setValue(QStringLiteral("geometry"), window_.saveGeometry());
    if (!window_.bare()) settings.setValue(QStringLiteral("docks"), window_.saveState(layoutVersion));
    for (const auto& [choice, key] : keptChoices)
        settings.setValue(QLatin1String(key), window_.panel().choices().list(choice));
    settings.setValue(QStringLiteral("chosen"), text(window_.museum().subject(window_.chosen()).name()));
}

void SessionKeeper::restoreLayout()
{
    QSettings settings(iniPath(settingsPath(folder_)), QSettings::IniFormat);
    restorePlace(window_, settings.value(QStringLiteral("geometry")).toByteArray(), journal_.othersRunning());
    window_.restoreState(settings.value(QStringLiteral("docks")).toByteArray(), layoutVersion);
    for (const auto& [choice, key] : keptChoices)
        window_.panel().choices().setList(choice, settings.value(QLatin1String(key)).toStringList());
    const std::string chosen = settings.value(QStringLiteral("chosen")).toString().toStdString();
    if (const auto found = window_.museum().find(chosen)) window_.choose(*found);
}

int SessionKeeper::timesRestored() const
{
    return QSettings(iniPath(settingsPath(folder_)), QSettings::IniFormat)
        .value(QStringLiteral("timesRestored"))
        .toInt();
}

void SessionKeeper::setTimesRestored(int times) const
{
    QSettings(iniPath(settingsPath(folder_)), QSettings::IniFormat).setValue(QStringLiteral("timesRestored"), times);
}

}  // namespace vitrine::ui

#include "moc_session_keeper.cpp"
