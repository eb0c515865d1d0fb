#include "ui/session_keeper.h"

#include "exhibits/framework/preset.h"
#include "exhibits/framework/state_folder.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"
#include "ui/look_text.h"
#include "ui/main_window.h"
#include "ui/parameter_panel.h"
#include "ui/viewport.h"

#include <QSettings>

namespace vitrine::ui {
namespace {

constexpr int quietTime = 2000;  // Milliseconds.
constexpr int longestWait = 10000;
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
    quiet_.setInterval(quietTime);
    connect(&quiet_, &QTimer::timeout, this, &SessionKeeper::writeJournal);
}

void SessionKeeper::noteChange()
{
    // Restarts the quiet time, unless that would put it off for too long.
    if (!quiet_.isActive()) sinceWritten_.start();
    if (!quiet_.isActive() || sinceWritten_.elapsed() < longestWait - quietTime) quiet_.start();
}

void SessionKeeper::writeJournal()
{
    try {
        journal_.write(textOf(window_.gallery(), window_.history().look(), window_.chosen(), "Journal"));
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, QString::fromUtf8(failure.what()));
    }
}

bool SessionKeeper::restoreLook(const std::string& text, const std::string& fileName)
{
    try {
        std::vector<std::string> notes;
        std::size_t chosen = 0;
        window_.history().restart(lookFrom(window_.gallery(), text, fileName, notes, &chosen));
        window_.choose(chosen);
        return true;
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, QString::fromUtf8(failure.what()));
        return false;
    }
}

bool SessionKeeper::restore()
{
    restoreLayout();
    const std::vector<AbandonedSession> abandoned = journal_.abandoned();
    for (const AbandonedSession& session : abandoned) {
        const bool back = restoreLook(session.text, session.path.string());
        journal_.discard(session);
        if (!back) continue;
        window_.say(MessageStrip::Mood::notice, tr("The last session did not end by itself; what was on show is back."));
        return true;
    }
    const std::filesystem::path file = folder_ / "session.json";
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return false;
    try {
        return restoreLook(render::readFile(file, presetLimits.bytes), file.string());
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, QString::fromUtf8(failure.what()));
        return false;
    }
}

void SessionKeeper::close()
{
    quiet_.stop();
    try {
        std::filesystem::create_directories(folder_);
        render::atomicWrite(folder_ / "session.json", textOf(window_.gallery(), window_.history().look(), window_.chosen(), "Last session"));
        saveLayout();
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
    settings.setValue(QStringLiteral("docks"), window_.saveState(layoutVersion));
    settings.setValue(QStringLiteral("folded"), window_.panel().foldedGroups());
    settings.setValue(QStringLiteral("chosen"),
                      QString::fromUtf8(window_.gallery().exhibits()[window_.chosen()]->name().data(),
                                        static_cast<qsizetype>(window_.gallery().exhibits()[window_.chosen()]->name().size())));
}

void SessionKeeper::restoreLayout()
{
    QSettings settings(settingsPath(folder_), QSettings::IniFormat);
    window_.restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
    window_.restoreState(settings.value(QStringLiteral("docks")).toByteArray(), layoutVersion);
    window_.panel().setFoldedGroups(settings.value(QStringLiteral("folded")).toStringList());
    const std::string chosen = settings.value(QStringLiteral("chosen")).toString().toStdString();
    for (std::size_t i = 0; i < window_.gallery().exhibits().size(); ++i)
        if (window_.gallery().exhibits()[i]->name() == chosen) window_.choose(i);
}

}  // namespace vitrine::ui

#include "moc_session_keeper.cpp"
