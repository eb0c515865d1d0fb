#pragma once

#include "ui/kit/export_bar.h"

namespace vitrine::ui {

/// Export bar for prints, with buttons that load and save settings. A print and a chart have different file names, so
/// that neither replaces the other.
class PrintExportBar final : public ExportBar {
    Q_OBJECT

public:
    explicit PrintExportBar(QWidget* parent);

    /// Sets file names in this folder that are not taken yet, for a print and for a chart.
    void suggest(const QString& folder);
    /// Shows the file name of the print or of the chart.
    void setChart(bool);
    /// Asks before replacing the print, its settings or the first of several files. Then emits `exportAsked`.
    void askForPrint();
    void showPossible(bool exporting, bool possible);

signals:
    void settingsLoaded(const QString& path);
    void settingsSaved(const QString& path);

private:
    void askSettings(bool save);

    QString otherPath_;  ///< File of the chart while the print is shown, and the reverse.
    bool chart_ = false;
    QPushButton* load_;
};

}  // namespace vitrine::ui
