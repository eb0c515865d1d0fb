#include "ui/viewport/file_watch.h"

#include "exhibits/museum/museum.h"
#include "exhibits/museum/named_files.h"
#include "ui/model/history.h"

namespace vitrine::ui {

FileWatch::FileWatch(const Museum& museum, const History& history) : museum_(museum), history_(history)
{
    timer_.setInterval(1000);
    connect(&timer_, &QTimer::timeout, this, &FileWatch::look);
}

std::uint64_t FileWatch::state() const
{
    return stateOfFiles(museum_.subjects(), history_.sceneState());
}

void FileWatch::renew()
{
    const bool named = namesFiles(history_.sceneState());
    known_ = named ? state() : 0;
    if (named && !timer_.isActive()) timer_.start();
    if (!named) timer_.stop();
}

void FileWatch::look()
{
    if (state() == known_) return;
    renew();
    emit changed();
}

}  // namespace vitrine::ui

#include "moc_file_watch.cpp"
