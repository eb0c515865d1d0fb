#pragma once

#include <QList>
#include <QObject>

#include <cstddef>
#include <initializer_list>
#include <utility>

class QDockWidget;
class QTabWidget;
class QMainWindow;

namespace vitrine::ui {

class ChartsDock;
class DocumentFile;
class ExhibitList;
class ExploreDock;
class FrameReportDock;
class LogView;
class ParameterTabs;
class PresetList;
class PresetController;
class ShaderPanel;
class StudyDock;
class TreeDock;
class Workbench;

/// Docks around the picture, with more than 15 members because each dock is one: makes, places, hides and shows them.
class WindowDocks final : public QObject {
    Q_OBJECT

public:
    /// Adds the docks to the window. The window and the workbench must outlive this object.
    WindowDocks(QMainWindow&, Workbench&);

    /// Adds the dock of the exploration; the controller must outlive it.
    void addExplore(PresetController&);

    [[nodiscard]] const QList<QDockWidget*>& all() const { return docks_; }
    [[nodiscard]] ExhibitList& exhibits() const { return *exhibits_; }
    [[nodiscard]] PresetList& presets() const { return *presets_; }
    [[nodiscard]] ParameterTabs& parameters() const { return *parameters_; }
    [[nodiscard]] StudyDock& study() const { return *study_; }
    [[nodiscard]] ChartsDock& charts() const { return *charts_; }
    [[nodiscard]] TreeDock& tree() const { return *tree_; }
    [[nodiscard]] DocumentFile& documentFile() const { return *documentFile_; }
    [[nodiscard]] ShaderPanel& shader() const { return *shader_; }
    [[nodiscard]] FrameReportDock& frameReport() const { return *frameReport_; }
    [[nodiscard]] LogView& log() const { return *log_; }
    [[nodiscard]] ExploreDock& explore() const { return *explore_; }

    /// Hides all visible docks.
    void hideAll();
    /// Shows the docks that `hideAll` hid.
    void showAgain();
    /// Shows this exhibit's tree and shader. Hides the dock of the tree if the exhibit has none.
    void setDocumentSubject(std::size_t exhibit);
    /// Shows the parameters, in front if they are stacked with other docks.
    void showParameters();
    /// Shows the study in the same way, large enough for its chart.
    void showStudy();
    /// Shows it and measures what the accuracy of this parameter costs.
    void measureAccuracy(std::size_t exhibit, std::size_t row);
    /// Does the same, and saves the chart once everything is measured.
    void measureIntoFigure(std::size_t exhibit, std::size_t row);
    /// Shows the charts of the visited exhibit, a tab of the study's dock.
    void showCharts();
    /// Shows the exploration, in front of the docks that it is stacked with.
    void showExplore();
    /// Shows the log, a tab of the frame report's dock.
    void showLog();
    /// Shows the shader of the visited exhibit, another tab there, large enough to be edited.
    void showShader();

private:
    [[nodiscard]] static QTabWidget* tabs(std::initializer_list<std::pair<QString, QWidget*>> pages);
    QDockWidget* add(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea);
    void addLists();
    void addStudy();
    void addFrameReportAndLog();
    void addTree();
    void nameStacks();
    void followType();
    /// Returns the width of the lists in pixels: titles stay whole with a large font, up to 26 % of the window.
    [[nodiscard]] int widthOfLists() const;

    QMainWindow& window_;
    Workbench& workbench_;
    QList<QDockWidget*> docks_, hidden_;
    int typeHeight_ = 0;  // Font height of the window in pixels.
    QDockWidget* parametersDock_ = nullptr;
    QDockWidget* studyDock_ = nullptr;
    QTabWidget* studyTabs_ = nullptr;
    QDockWidget* reportDock_ = nullptr;
    QTabWidget* reportTabs_ = nullptr;
    ExhibitList* exhibits_ = nullptr;
    PresetList* presets_ = nullptr;
    ParameterTabs* parameters_ = nullptr;
    StudyDock* study_ = nullptr;
    QDockWidget* treeDock_ = nullptr;
    TreeDock* tree_ = nullptr;
    DocumentFile* documentFile_ = nullptr;
    bool treeWanted_ = true;  // The visitor has not closed the tree's dock.
    ChartsDock* charts_ = nullptr;
    FrameReportDock* frameReport_ = nullptr;
    LogView* log_ = nullptr;
    ShaderPanel* shader_ = nullptr;
    QDockWidget* exploreDock_ = nullptr;
    ExploreDock* explore_ = nullptr;
};

}  // namespace vitrine::ui
