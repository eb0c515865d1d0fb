#pragma once

#include "exhibits/museum/museum.h"

#include <QListWidget>

#include <vector>

namespace vitrine::ui {

/// List of the hall and all exhibits in the order of their places: picture, number, title. Empty places are gray.
/// Exhibits without a place follow as the depot. The current row has buttons that open its lesson and its page.
class ExhibitList final : public QListWidget {
    Q_OBJECT

public:
    explicit ExhibitList(QWidget* parent = nullptr);

    void fill(const Museum&);
    void setThumbnail(std::size_t exhibit, const QPixmap&);
    [[nodiscard]] bool hasThumbnail(std::size_t exhibit) const;
    /// Selects the exhibit without emitting a signal.
    void choose(std::size_t exhibit);

signals:
    void chosen(std::size_t exhibit);
    void lessonAsked(std::size_t exhibit);
    void pageAsked(std::size_t exhibit);

private:
    /// Moves the buttons from one row to another.
    void showButtons(QListWidgetItem* row, QListWidgetItem* before);
    [[nodiscard]] QListWidgetItem* itemOf(std::size_t exhibit) const;
};

}  // namespace vitrine::ui
