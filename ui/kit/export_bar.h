#pragma once

#include <QStringList>
#include <QWidget>

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace vitrine::ui {

/// To which file something is exported, how far it is, and the dialog's buttons.
class ExportBar : public QWidget {
    Q_OBJECT

public:
    struct Words {
        QString help;    ///< Of the file's name.
        QString title;   ///< Of the dialog that chooses a file.
        QString filter;  ///< Likewise: kinds of files.
        QString suffix;  ///< Given to a name that was chosen without one; empty: none.
    };
    ExportBar(Words, QWidget* parent);

    [[nodiscard]] QString path() const;
    void setPath(const QString&);
    [[nodiscard]] QString status() const;

    /// Asks before the file, or one of those beside it, is replaced; then `exportAsked`.
    void ask(const QStringList& beside);
    void showPossible(bool exporting, bool possible);
    void showProgress(double part, double secondsLeft);
    /// The export is over, or something else is to be read beside the buttons.
    void showStatus(const QString& words, double part = 0);

signals:
    void pathChanged();
    /// The button was pressed: `ask` is for the dialog to call.
    void goAsked();
    void exportAsked(const QString& path);
    void stopAsked();

protected:
    /// One more, on the left.
    QPushButton* addButton(const QString& text, const QString& help);
    [[nodiscard]] QPushButton& goButton() { return *go_; }

private:
    QPushButton* makeButton(const QString& text);
    void layOut();
    void browse();

    Words words_;
    QLineEdit* path_;
    QToolButton* browse_;
    QProgressBar* progress_;
    QLabel* status_;
    QHBoxLayout* buttons_;
    int added_ = 0;
    QPushButton *stop_, *go_;
    QString replaced_;  ///< The visitor agreed that this file may be replaced.
};

}  // namespace vitrine::ui
