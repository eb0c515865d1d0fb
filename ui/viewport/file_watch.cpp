#include "ui/viewport/file_watch.h"

#include "exhibits/museum/museum.h"
#include "exhibits/museum/named_files.h"
#include "ui/model/history.h"

#include <QFileInfo>

namespace vitrine::ui {

FileWatch::FileWatch(const Museum& museum, const History& history, int interval) : museum_(museum), history_(history)
{
    timer_.setInterval(interval);
    soon_.setInterval(pause);
    soon_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &FileWatch::look);
    connect(&soon_, &QTimer::timeout, this, &FileWatch::lookAtFiles);
    const auto notify = [this] { soon_.start(); };
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, notify);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, notify);
}

std::uint64_t FileWatch::state(bool withNeighbors) const
{
    return stateOfFiles(museum_.subjects(), history_.sceneState(), withNeighbors);
}

void FileWatch::renew()
{
    const bool named = namesFiles(history_.sceneState());
    known_ = named ? state(true) : 0;
    knownFiles_ = named ? state(false) : 0;
    if (named && !timer_.isActive()) timer_.start();
    if (!named) timer_.stop();
    watch(named);
}

void FileWatch::watch(bool named)
{
    // A file that is replaced is no longer watched, but its folder is.
    QStringList wanted;
    const auto want = [&](const QString& path) {
        if (!wanted.contains(path) && QFileInfo::exists(path)) wanted.append(path);
    };
    if (named)
        for (const std::string& path : watchedFiles(museum_.subjects(), history_.sceneState())) {
            want(QString::fromStdString(path));
            want(QFileInfo(QString::fromStdString(path)).path());
        }
    const QStringList known = watcher_.files() + watcher_.directories();
    for (const QString& path : known)
        if (!wanted.contains(path)) watcher_.removePath(path);
    for (const QString& path : wanted)
        if (!known.contains(path)) watcher_.addPath(path);
}

void FileWatch::look()
{
    if (state(true) == known_) return watch(namesFiles(history_.sceneState()));
    renew();
    emit changed();
}

void FileWatch::lookAtFiles()
{
    if (state(false) == knownFiles_) return watch(namesFiles(history_.sceneState()));
    renew();
    emit changed();
}

}  // namespace vitrine::ui

#include "moc_file_watch.cpp"
