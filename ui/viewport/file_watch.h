#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include <cstdint>

namespace vitrine {
class Museum;
}

namespace vitrine::ui {

class History;

/// Watch of the files that the present scene state names. The system notifies it of changes on disk; since it does not
/// on every file system, the watch also looks once a second. While no file is named, it does nothing.
class FileWatch final : public QObject {
    Q_OBJECT

public:
    /// Milliseconds between two looks, and from a notification to its look: programs write a file in several steps.
    static constexpr int usualInterval = 1000, pause = 30;

    /// Both must outlive this object. Call `renew` before the first look. `interval`: milliseconds between two looks.
    FileWatch(const Museum&, const History&, int interval = usualInterval);

    /// Takes the files that the scene state names now, as they are now. Call after values changed.
    void renew();

signals:
    /// Emitted when a file that the scene state names, or one beside it, changed on disk.
    void changed();

private:
    void look();
    /// The same for the files alone, after a notification.
    void lookAtFiles();
    /// Asks the system for notifications: of the named files, or of none.
    void watch(bool named);
    [[nodiscard]] std::uint64_t state(bool withNeighbors) const;

    const Museum& museum_;
    const History& history_;
    QTimer timer_, soon_;
    QFileSystemWatcher watcher_;
    std::uint64_t known_ = 0;       ///< State of the files and their neighbors at the last look.
    std::uint64_t knownFiles_ = 0;  ///< State of the files alone.
};

}  // namespace vitrine::ui
