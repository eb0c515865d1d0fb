#pragma once

#include <QObject>
#include <QTimer>

#include <cstdint>

namespace vitrine {
class Museum;
}

namespace vitrine::ui {

class History;

/// Watch of the files that the present scene state names: looks once a second whether one of them changed on disk.
/// While no file is named, it does nothing.
class FileWatch final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object. Call `renew` before the first look.
    FileWatch(const Museum&, const History&);

    /// Takes the files that the scene state names now, as they are now. Call after values changed.
    void renew();

signals:
    /// Emitted when a file that the scene state names, or one beside it, changed on disk.
    void changed();

private:
    void look();
    [[nodiscard]] std::uint64_t state() const;

    const Museum& museum_;
    const History& history_;
    QTimer timer_;
    std::uint64_t known_ = 0;  ///< State of the files at the last look.
};

}  // namespace vitrine::ui
