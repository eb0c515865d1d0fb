#pragma once

#include "ui/kit/export_bar.h"

namespace vitrine::ui {

/// An export bar for prints, whose settings can be loaded and saved. A print and a chart have names of their own, so
/// that neither takes the other's place.
class PrintExportBar final : public ExportBar {
    Q_OBJECT

public:
    explicit PrintExportBar(QWidget* parent);

    /// Names in this folder that are not taken yet, for a print and for a chart.
    void suggest(const QString& folder);
    /// Shows the name of the print, or of the chart.
    void setChart(bool);
    /// Asks before the print, its settings or the first of several files is replaced, then `exportAsked`.
    void askForPrint();
    void showPossible(bool exporting, bool possible);

signals:
    void settingsLoaded(const QString& path);
    void settingsSaved(const QString& path);

private:
    void askSettings(bool save);

    QString otherPath_;  ///< Of the chart while the print is set up, and the other way round.
    bool chart_ = false;
    QPushButton* load_;
};

}  // namespace vitrine::ui
