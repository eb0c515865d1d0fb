#include "ui/record/bookmarks.h"

#include "exhibits/framework/files/state_folder.h"
#include "render/files/atomic_write.h"
#include "ui/kit/message_of.h"
#include "ui/kit/text.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

#include <QLockFile>

#include <algorithm>

namespace vitrine::ui {

Bookmarks::Bookmarks(Workbench& window, QObject* parent)
    : QObject(parent), window_(window), file_(recording::bookmarksFile())
{
    read();
}

void Bookmarks::read()
{
    if (broken_) return;
    std::error_code ignored;
    if (!std::filesystem::exists(file_, ignored)) {
        places_.fill(std::nullopt);
        return;
    }
    try {
        const recording::Tour kept = recording::readTour(file_);
        places_.fill(std::nullopt);
        // The name of a bookmark begins with its number.
        for (const recording::Bookmark& bookmark : kept.bookmarks) {
            const int number = bookmark.name.empty() ? 0 : bookmark.name.front() - '0';
            if (number >= 1 && number <= most) place(number) = bookmark;
        }
    } catch (const std::exception& failure) {
        broken_ = true;
        window_.say(MessageStrip::Mood::problem,
                    tr("Your bookmarks are kept for this session only: %1").arg(messageOf(failure)));
    }
}

void Bookmarks::change(const std::function<void()>& edit)
{
    constexpr int longestWait =
        5000;  // In milliseconds. A lock held for longer is stale: nine bookmarks are written in far less.
    std::error_code ignored;
    std::filesystem::create_directories(file_.parent_path(), ignored);
    QLockFile lock(QString::fromStdString(file_.string() + ".lock"));
    lock.tryLock(longestWait);
    read();
    edit();
    write();
    emit changed();
}

void Bookmarks::write()
{
    if (broken_) return;
    try {
        std::error_code ignored;
        if (const recording::Tour all = tour(); all.bookmarks.empty())
            std::filesystem::remove(file_, ignored);
        else
            writeOwnFile(file_, recording::tourText(all));
        window_.setProblems(QStringLiteral("bookmarks"), {});
    } catch (const std::exception& failure) {
        window_.setProblems(QStringLiteral("bookmarks"), {messageOf(failure)});
    }
}

void Bookmarks::set(int number)
{
    const std::string title(window_.museum().subject(window_.chosen()).title());
    change([&] { place(number) = {std::to_string(number) + ' ' + title, window_.history().sceneState().camera}; });
    window_.say(MessageStrip::Mood::notice, tr("Bookmark %1 is where you are now.").arg(number));
}

void Bookmarks::go(int number)
{
    if (const std::optional<recording::Bookmark>& there = place(number))
        window_.viewport().visitor().goTo(there->camera);
    else
        window_.say(MessageStrip::Mood::notice,
                    tr("There is no bookmark %1 yet: Ctrl+Alt+%1 makes one of where you are.").arg(number));
}

void Bookmarks::add()
{
    const auto free = std::find(places_.begin(), places_.end(), std::nullopt);
    if (free != places_.end())
        set(static_cast<int>(free - places_.begin()) + 1);
    else
        window_.say(MessageStrip::Mood::notice,
                    tr("All nine bookmarks are set: replace or delete one in View > Manage bookmarks."));
}

void Bookmarks::forget(int number)
{
    change([&] { place(number).reset(); });
}

bool Bookmarks::hasSome() const
{
    return std::any_of(places_.begin(), places_.end(), [](const auto& there) { return there.has_value(); });
}

void Bookmarks::forgetAll()
{
    change([&] { places_.fill(std::nullopt); });
}

QString Bookmarks::name(int number) const
{
    const std::optional<recording::Bookmark>& there = places_.at(static_cast<std::size_t>(number - 1));
    return there ? QString::fromStdString(there->name) : QString();
}

recording::Tour Bookmarks::tour() const
{
    recording::Tour tour{"Bookmarks", {}, false, recording::Pace::eased};
    for (const std::optional<recording::Bookmark>& there : places_)
        if (there) tour.bookmarks.push_back(*there);
    return tour;
}

void Bookmarks::saveAs(const QString& path)
{
    try {
        render::atomicWrite(path.toStdString(), recording::tourText(tour()));
        window_.say(MessageStrip::Mood::notice, tr("Saved %1.").arg(path));
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, messageOf(failure));
    }
}

}  // namespace vitrine::ui

#include "moc_bookmarks.cpp"
