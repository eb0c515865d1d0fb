#pragma once

#include <QDialog>

class QListWidget;
class QPushButton;

namespace vitrine::ui {

class Bookmarks;

/// Dialog with the nine bookmarks: goes to one, sets it to the current view, deletes it, saves all as a tour.
class BookmarksDialog final : public QDialog {
    Q_OBJECT

public:
    /// The bookmarks must outlive the dialog, which deletes itself when it is closed.
    explicit BookmarksDialog(Bookmarks&, QWidget* parent = nullptr);

signals:
    void tourAsked();

private:
    [[nodiscard]] int number() const;
    void fill();
    void showButtons();

    Bookmarks& bookmarks_;
    QListWidget* list_;
    QPushButton *go_, *set_, *delete_, *tour_, *deleteAll_;
};

}  // namespace vitrine::ui
