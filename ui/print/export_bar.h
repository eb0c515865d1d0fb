#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace vitrine::ui {

/// To which file a print goes, how far the export is, and the dialog's buttons. A print and a chart have names of their
/// own, so that neither takes the other's place.
class ExportBar final : public QWidget {
    Q_OBJECT

public:
    explicit ExportBar(QWidget* parent);

    [[nodiscard]] QString path() const;
    void setPath(const QString&);
    /// Names in this folder that are not taken yet, for a print and for a chart.
    void suggest(const QString& folder);
    /// Shows the name of the print, or of the chart.
    void setChart(bool);

    /// Asks before a file is replaced, then `exportAsked`.
    void ask();
    void showPossible(bool exporting, bool possible);
    void showProgress(double part, double secondsLeft);
    /// The export is over, or something else is to be read beside the buttons.
    void showStatus(const QString& words, double part = 0);

signals:
    void pathChanged();
    void exportAsked(const QString& path);
    void stopAsked();
    void settingsLoaded(const QString& path);
    void settingsSaved(const QString& path);

private:
    QPushButton* addButton(const QString& text, const QString& help);
    void layOut();
    void connectParts();
    void browse();
    void askSettings(bool save);

    QLineEdit* path_;
    QString otherPath_;  ///< Of the chart while the print is set up, and the other way round.
    QString replaced_;   ///< The visitor agreed that this file may be replaced.
    bool chart_ = false;
    QToolButton* browse_;
    QProgressBar* progress_;
    QLabel* status_;
    QPushButton *load_, *save_, *stop_, *go_;
};

}  // namespace vitrine::ui
