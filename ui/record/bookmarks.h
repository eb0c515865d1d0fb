#pragma once

#include "exhibits/recording/tour.h"

#include <QObject>
#include <QString>

#include <array>
#include <filesystem>
#include <functional>
#include <optional>

namespace vitrine::ui {

class Workbench;

/// Views that the visitor keeps under the numbers 1 to 9, in a file of their own: a tour, which `vitrine record` takes.
class Bookmarks final : public QObject {
    Q_OBJECT

public:
    static constexpr int most = 9;

    /// Reads what was kept before. The window must outlive it.
    Bookmarks(Workbench&, QObject* parent);

    /// Number 1 to `most`: keeps where the visitor is, in place of what was there.
    void set(int number);
    /// Glides there; says so where there is none.
    void go(int number);
    void forgetAll();
    /// What it is called; empty: there is none.
    [[nodiscard]] QString name(int number) const;
    /// Those that there are, by number.
    [[nodiscard]] Tour tour() const;
    /// Writes them to another file.
    void saveAs(const QString& path);

signals:
    void changed();

private:
    void read();
    /// Changes the bookmarks as they are in the file now, which another window may have written, under a lock.
    void change(const std::function<void()>& edit);
    void write();
    [[nodiscard]] std::optional<Bookmark>& place(int number)
    {
        return places_.at(static_cast<std::size_t>(number - 1));
    }

    Workbench& window_;
    std::filesystem::path file_;
    bool broken_ = false;  ///< What is in the file could not be read, and is left as it is.
    std::array<std::optional<Bookmark>, most> places_;
};

}  // namespace vitrine::ui
