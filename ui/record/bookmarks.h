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

/// Bookmarks: views that the visitor stores under the numbers 1 to 9. Their file is a tour, which `vitrine record`
/// accepts.
class Bookmarks final : public QObject {
    Q_OBJECT

public:
    static constexpr int most = 9;

    /// Reads the stored bookmarks. The window must outlive this object.
    Bookmarks(Workbench&, QObject* parent);

    /// Stores the current view as bookmark `number` (1 to `most`), in place of the old one.
    void set(int number);
    /// Glides to a bookmark; shows a message if it is not set.
    void go(int number);
    /// Stores the current view as the first free bookmark; shows a message if there is none.
    void add();
    void forget(int number);
    void forgetAll();
    [[nodiscard]] bool hasSome() const;
    /// Returns the name of a bookmark; empty if it is not set.
    [[nodiscard]] QString name(int number) const;
    /// Returns the bookmarks that are set, by number.
    [[nodiscard]] recording::Tour tour() const;
    /// Writes the bookmarks to another file.
    void saveAs(const QString& path);

signals:
    void changed();

private:
    void read();
    /// Edits the bookmarks under a lock, after reading the file again, because another window may have changed it.
    void change(const std::function<void()>& edit);
    void write();
    [[nodiscard]] std::optional<recording::Bookmark>& place(int number)
    {
        return places_.at(static_cast<std::size_t>(number - 1));
    }

    Workbench& window_;
    std::filesystem::path file_;
    bool broken_ = false;  ///< The file could not be read, and is not overwritten.
    std::array<std::optional<recording::Bookmark>, most> places_;
};

}  // namespace vitrine::ui
