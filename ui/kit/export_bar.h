#pragma once

#include <QList>
#include <QStringList>
#include <QWidget>

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace vitrine::ui {

class FlowLayout;

/// Lower part of an export dialog: the file or folder to write, the progress, and the buttons.
class ExportBar : public QWidget {
    Q_OBJECT

public:
    struct Words {
        QString help;           ///< Tooltip of the file name.
        QString title;          ///< Title of the file dialog.
        QString filter;         ///< File types in the file dialog.
        QString suffix;         ///< Suffix added to a chosen name without one; empty: none.
        bool isFolder = false;  ///< Whether a folder is written.
    };
    ExportBar(Words, QWidget* parent);

    [[nodiscard]] QString path() const;
    void setPath(const QString&);
    [[nodiscard]] QString status() const;

    /// Asks whether to replace the file, or files of `beside` next to it, if they exist. Emits `exportAsked` if the
    /// visitor agrees.
    void ask(const QStringList& beside);
    void showPossible(bool exporting, bool possible);
    void showProgress(double part, double secondsLeft);
    /// Shows a text beside the buttons, such as the end of the export.
    void showStatus(const QString& words, double part = 0);
    /// Adds a button on the left.
    QPushButton* addButton(const QString& text, const QString& help);

signals:
    void pathChanged();
    /// Emitted when the export button was pressed. The dialog then calls `ask`.
    void goAsked();
    void exportAsked(const QString& path);
    void stopAsked();

protected:
    [[nodiscard]] QPushButton& goButton() { return *go_; }

private:
    QPushButton* makeButton(const QString& text);
    void layOut();
    /// Puts the added buttons beside the others, or above them if the type is large.
    void placeAdded();
    void browse();

    Words words_;
    QLineEdit* path_;
    QToolButton* browse_;
    QProgressBar* progress_;
    QLabel* status_;
    FlowLayout* line_;  ///< Added buttons while the type is large.
    QHBoxLayout* buttons_;
    QList<QPushButton*> added_;
    QPushButton *stop_, *go_;
    QString replaced_;  ///< File that the visitor agreed to replace.
};

}  // namespace vitrine::ui
