#pragma once

#include "ui/kit/message_strip.h"
#include "ui/kit/progress_job.h"
#include "ui/model/history.h"
#include "ui/print/print_planner.h"
#include "ui/print/print_setup.h"
#include "ui/print/view_loader.h"

#include <QDialog>

#include <memory>

namespace vitrine::ui {

class PrintExportBar;
class PrintResults;
class PrintSide;

/// Dialog for a lenticular print or a calibration chart: previews the raster and the picture for both eyes, lists the
/// numbers that a printer asks for, and writes the print. Does not block. Settings are restored the next time.
class PrintDialog final : public QDialog {
    Q_OBJECT

public:
    /// `shown` renders views of the window's picture; the dialog owns it. Null if there is no such window.
    PrintDialog(ShownViews* shown, QWidget* parent);
    ~PrintDialog() override;

    [[nodiscard]] const ParameterValues& values() const { return setup_.values(); }
    void setValues(const ParameterValues&);
    /// Sets the values in one undo step with this name. While a print is written, shows a message instead.
    void change(const QString& undoText, const ParameterValues&);
    [[nodiscard]] QStringList files() const { return setup_.pictures(); }
    /// Opens views, or loads the settings of a print or its JSON. Used for drops on the dialog.
    void openFiles(const QStringList& paths);
    void setChart(bool);
    /// Sets the path of the print or of the chart, whichever is shown.
    void setPath(const QString&);
    [[nodiscard]] QString path() const;
    /// Returns whether numbers and previews are up to date.
    [[nodiscard]] bool settled() const;
    [[nodiscard]] bool exporting() const { return exporting_; }

public slots:
    void startExport();
    void stopExport();
    void loadSettings(const QString& path);
    void saveSettings(const QString& path);
    void done(int) override;
    /// Cancels the running export, or closes the dialog if there is none.
    void reject() override;

signals:
    /// Emitted when an export has ended. `saved`: the file was written.
    void exportEnded(bool saved);

protected:
    void dragEnterEvent(QDragEnterEvent*) override;
    void dropEvent(QDropEvent*) override;

private:
    /// Loads the settings of a print, or of a settings file. Throws Failure.
    void loadPrint(const std::string& path);
    void build(bool canShow);
    [[nodiscard]] QWidget* buildRight();
    void buildUndo();
    void connectSetup();
    void connectViews();
    void connectExport();
    void remember();
    void recall();

    /// Runs `work`, and shows a message if it throws. Returns whether it succeeded.
    bool trySaying(const std::function<void()>& work);
    void say(MessageStrip::Mood, const QString&, const QString& file = {});
    void showState(bool views);
    void refresh();
    void showPlan();
    void showButtons();
    [[nodiscard]] bool fromWindow() const;
    /// Returns the values of the print, or of the chart, whichever is shown.
    [[nodiscard]] ParameterValues printed() const;

    void begin(const QString& path);
    void write(std::shared_ptr<const printing::PrintViews>);
    void endExport(const QString& words);

    PrintSetup setup_;
    ViewLoader loader_;
    PrintPlanner planner_;
    bool chart_ = false;
    bool exporting_ = false;
    bool remembered_ = false;
    ProgressJob write_;

    MessageStrip* messages_;
    PrintSide* side_;
    PrintResults* results_;
    PrintExportBar* export_;
    QAction *undo_, *redo_;
};

}  // namespace vitrine::ui
