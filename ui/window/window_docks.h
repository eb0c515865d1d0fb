#pragma once

#include <QList>
#include <QObject>

#include <cstddef>

class QDockWidget;
class QMainWindow;

namespace vitrine::ui {

class ChartsDock;
class ExhibitList;
class ExploreDock;
class LedgerDock;
class LogView;
class ParameterTabs;
class PresetList;
class PresetShelf;
class StudyDock;
class TreeDock;
class TreeFile;
class Workbench;

/// The panels around the picture: what is in them, where they start, how they go out of sight and come back.
class WindowDocks final : public QObject {
    Q_OBJECT

public:
    /// Builds them into this window, which must outlive them, as must the workbench.
    WindowDocks(QMainWindow&, Workbench&);

    /// The panel to explore looks with; the shelf must outlive it.
    void addExplore(PresetShelf&);

    [[nodiscard]] const QList<QDockWidget*>& all() const { return docks_; }
    [[nodiscard]] ExhibitList& exhibits() const { return *exhibits_; }
    [[nodiscard]] PresetList& presets() const { return *presets_; }
    [[nodiscard]] ParameterTabs& parameters() const { return *parameters_; }
    [[nodiscard]] StudyDock& study() const { return *study_; }
    [[nodiscard]] ChartsDock& charts() const { return *charts_; }
    [[nodiscard]] TreeDock& tree() const { return *tree_; }
    [[nodiscard]] TreeFile& treeFile() const { return *treeFile_; }
    [[nodiscard]] LedgerDock& ledger() const { return *ledger_; }
    [[nodiscard]] LogView& log() const { return *log_; }
    [[nodiscard]] ExploreDock& explore() const { return *explore_; }

    /// Hides those that are open.
    void hideAll();
    /// Shows those again that `hideAll` hid.
    void showAgain();
    /// Shows this exhibit's tree; there is no panel for it where the exhibit has none.
    void setTreeSubject(std::size_t exhibit);
    /// Opens the parameters, in front where they are stacked with others.
    void showParameters();
    /// The same of the study, large enough for its chart.
    void showStudy();

private:
    QDockWidget* add(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea);
    void addLists();
    void addStudy();
    void addLedgerAndLog();
    void addTree();
    void nameStacks();
    void followSmallerType();

    QMainWindow& window_;
    Workbench& workbench_;
    QList<QDockWidget*> docks_, hidden_;
    int typeHeight_ = 0;  // Of the window's type, pixels.
    QDockWidget* parametersDock_ = nullptr;
    QDockWidget* studyDock_ = nullptr;
    ExhibitList* exhibits_ = nullptr;
    PresetList* presets_ = nullptr;
    ParameterTabs* parameters_ = nullptr;
    StudyDock* study_ = nullptr;
    QDockWidget* treeDock_ = nullptr;
    TreeDock* tree_ = nullptr;
    TreeFile* treeFile_ = nullptr;
    bool treeWanted_ = true;  // The visitor did not close it.
    ChartsDock* charts_ = nullptr;
    LedgerDock* ledger_ = nullptr;
    LogView* log_ = nullptr;
    ExploreDock* explore_ = nullptr;
};

}  // namespace vitrine::ui
