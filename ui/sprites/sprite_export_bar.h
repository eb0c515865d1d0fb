#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace vitrine::ui {

/// To which file a sheet goes, how far it is, and the dialog's buttons.
class SpriteExportBar final : public QWidget {
    Q_OBJECT

public:
    explicit SpriteExportBar(QWidget* parent);

    [[nodiscard]] QString path() const;
    void setPath(const QString&);
    /// Asks before one of these files beside the sheet, or the sheet itself, is replaced; then `exportAsked`.
    void ask(const QStringList& beside);
    void showPossible(bool exporting, bool possible);
    void showProgress(double part, double secondsLeft);
    void showStatus(const QString& words, double part = 0);
    [[nodiscard]] QString status() const;

signals:
    void goAsked();
    void exportAsked(const QString& path);
    void stopAsked();

private:
    void layOut();
    void browse();

    QLineEdit* path_;
    QToolButton* browse_;
    QProgressBar* progress_;
    QLabel* status_;
    QPushButton *stop_, *go_;
    QString replaced_;  ///< The visitor agreed that this file may be replaced.
};

}  // namespace vitrine::ui
