#pragma once

#include "exhibits/printing/print_desk.h"
#include "ui/print/newest_job.h"
#include "ui/kit/message_strip.h"
#include "ui/kit/progress_job.h"
#include "ui/model/history.h"

#include <QDialog>
#include <QTimer>

#include <memory>
#include <optional>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTabBar;
class QToolButton;
class QVBoxLayout;

namespace vitrine::ui {

class EyesPreview;
class ParameterPanel;
class PrintNumbersView;
class SheetBar;
class ShownViews;
class SourceBar;
class StripPreview;

/// Sets up a lenticular print or a calibration chart, shows the raster and what both eyes will see of it, says
/// what a printer wants to know, and writes it. Blocks nothing; what was set comes back the next time.
class PrintDialog final : public QDialog {
    Q_OBJECT

public:
    /// `shown` renders views of what the window shows; taken over, and null where there is no such window.
    PrintDialog(std::unique_ptr<PrintDesk>, ShownViews* shown, QWidget* parent);
    ~PrintDialog() override;

    [[nodiscard]] const PrintDesk& desk() const { return *desk_; }
    [[nodiscard]] const ParameterValues& values() const { return *values_; }
    void setValues(const ParameterValues&);
    [[nodiscard]] const QStringList& files() const { return files_; }
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
    void build();
    void connectParts();
    void remember();
    void recall();
    void takeSettings(const std::string& text, const std::string& fileName);
    void say(MessageStrip::Mood, const QString&);

    void showRows();
    void showSheets();
    void getViews();
    void readFiles();
    void takeViews(std::shared_ptr<const PrintViews>, const std::optional<SceneDepth>&, bool draft);
    void refresh();
    void showButtons();
    [[nodiscard]] bool hasViews() const;

    void write(std::shared_ptr<const PrintViews>);
    void begin(const QString& path);
    void endExport(const QString& words);
    void browse();
    void askSettings(bool save);

    std::unique_ptr<PrintDesk> desk_;
    std::optional<ParameterValues> values_;
    History settings_{Look()};  ///< The values once more, as the panel shows and sets them.
    QStringList files_;
    std::shared_ptr<const PrintViews> views_;
    std::optional<SceneDepth> depth_;
    PrintSummary summary_;
    std::string sheet_;       ///< Chosen or saved last: of sheets that are alike, the one that is meant.
    bool draft_ = false;      ///< The views are small ones, to look at.
    bool chart_ = false;
    bool exporting_ = false;
    bool remembered_ = false;
    bool wantsViews_ = false; ///< To be rendered as soon as the print is possible.
    int asked_ = 0, shown_ = 0;  ///< Refreshes asked for and shown.

    ShownViews* live_;
    NewestJob look_, count_;  ///< Previews; numbers, which take longer with many views.
    ProgressJob read_, write_;
    QTimer renderSoon_;

    MessageStrip* messages_;
    QTabBar* tabs_;
    SourceBar* source_;
    SheetBar* sheets_;
    ParameterPanel* panel_;
    StripPreview* strips_;
    EyesPreview* eyes_;
    PrintNumbersView* numbers_;
    QLineEdit* path_;
    QString otherPath_;  ///< Of the chart while the print is set up, and the other way round.
    QString replaced_;   ///< The visitor agreed that this file may be replaced.
    QToolButton* browse_;
    QProgressBar* progress_;
    QLabel* status_;
    QPushButton *load_, *save_, *stop_, *go_;
};

}  // namespace vitrine::ui
