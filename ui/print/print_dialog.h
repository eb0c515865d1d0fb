#pragma once

#include "exhibits/printing/print_plan.h"
#include "ui/kit/message_strip.h"
#include "ui/kit/progress_job.h"
#include "ui/model/history.h"
#include "ui/print/newest_job.h"
#include "ui/print/print_setup.h"
#include "ui/print/view_loader.h"

#include <QDialog>

#include <memory>

class QTabBar;

namespace vitrine::ui {

class EyesPreview;
class ParameterPanel;
class PrintExportBar;
class PrintNumbersView;
class SheetBar;
class SourceBar;
class StripPreview;

/// Sets up a lenticular print or a calibration chart, shows the raster and what both eyes will see of it, says
/// what a printer wants to know, and writes it. Blocks nothing; what was set comes back the next time.
class PrintDialog final : public QDialog {
    Q_OBJECT

public:
    /// `shown` renders views of what the window shows; taken over, and null where there is no such window.
    PrintDialog(ShownViews* shown, QWidget* parent);
    ~PrintDialog() override;

    [[nodiscard]] const ParameterValues& values() const { return setup_.values(); }
    void setValues(const ParameterValues&);
    [[nodiscard]] const QStringList& files() const { return setup_.state().files; }
    /// Views, or a print or its JSON whose settings come back: what a drop on the dialog does.
    void open(const QStringList& paths);
    void setChart(bool);
    /// Of the print, or of the chart: each keeps its own.
    void setPath(const QString&);
    [[nodiscard]] QString path() const;
    /// Whether the numbers and pictures are those of the values.
    [[nodiscard]] bool settled() const;
    [[nodiscard]] bool exporting() const { return exporting_; }

public slots:
    void startExport();
    void stopExport();
    void loadSettings(const QString& path);
    void saveSettings(const QString& path);
    void done(int) override;
    /// Cancels what runs; closes the dialog where nothing does.
    void reject() override;

signals:
    /// The export is over; what was saved was asked for.
    void exportEnded(bool saved);

protected:
    void dragEnterEvent(QDragEnterEvent*) override;
    void dropEvent(QDropEvent*) override;

private:
    /// Takes the settings of a print, or of a file of settings. Throws Failure.
    void loadPrint(const std::string& path);
    void build(bool canShow);
    [[nodiscard]] QWidget* buildLeft(bool canShow);
    [[nodiscard]] QWidget* buildRight();
    void buildUndo();
    void connectSetup();
    void connectViews();
    void connectExport();
    void remember();
    void recall();

    /// Does `work`; says why where it throws. Returns whether it did not.
    bool trySaying(const std::function<void()>& work);
    void say(MessageStrip::Mood, const QString&, const QString& file = {});
    void showState(bool views);
    void showRows();
    void refresh();
    void lookAgain();
    void countAgain();
    void showButtons();
    [[nodiscard]] bool fromWindow() const;

    void begin(const QString& path);
    void write(std::shared_ptr<const printing::PrintViews>);
    void endExport(const QString& words);

    PrintSetup setup_;
    ViewLoader loader_;
    printing::PrintPlan plan_;
    bool chart_ = false;
    bool exporting_ = false;
    bool remembered_ = false;
    int asked_ = 0, shown_ = 0;  ///< Refreshes asked for and shown.
    NewestJob preview_, count_;  ///< Previews; numbers, which take longer with many views.
    ProgressJob write_;

    MessageStrip* messages_;
    QTabBar* tabs_;
    SourceBar* source_;
    SheetBar* sheets_;
    ParameterPanel* panel_;
    StripPreview* strips_;
    EyesPreview* eyes_;
    PrintNumbersView* numbers_;
    PrintExportBar* export_;
    QAction *undo_, *redo_;
};

}  // namespace vitrine::ui
