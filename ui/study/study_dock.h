#pragma once

#include "ui/model/history.h"
#include "ui/viewport/gallery.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace vitrine::ui {

class StudyChart;
class StudyPictures;

/// What accuracy costs: measures a parameter of the chosen exhibit, or all of them together, between the window's
/// other work, shows every point as it is measured, and applies the one that is clicked or searched for.
class StudyDock final : public QWidget {
    Q_OBJECT

public:
    /// Calls its argument with the viewport's context current; returns whether there is one.
    using WithContext = std::function<bool(const std::function<void()>&)>;

    /// Gallery and history must outlive it.
    StudyDock(Gallery&, History&, WithContext, QWidget* parent = nullptr);
    ~StudyDock() override;

    /// Whose parameters are offered; what is shown stays until the next study.
    void setSubject(std::size_t exhibit);
    /// Measures one parameter at once: a row of the exhibit's table.
    void ask(std::size_t exhibit, std::size_t row);
    /// Ends the study that runs; what it measured stays to be seen.
    void stop();
    [[nodiscard]] bool running() const { return job_.study != nullptr; }
    /// What is shown: of the study that runs as soon as it has a point, until then of the one before.
    [[nodiscard]] const StudyResult& result() const { return showsRunning_ ? job_.study->result() : result_; }
    /// Everything shown that was measured, as a file: .csv, .json (with `machine` beside it), or the chart as .png or .svg.
    [[nodiscard]] QByteArray exported(const QString& suffix) const;
    [[nodiscard]] StudyChart& chart() const { return *chart_; }

    /// Side of the pictures that it measures with, and how often each is timed.
    void setEffort(glm::ivec2 size, int runs);

signals:
    void failed(const QString& why);
    void finished();

protected:
    void showEvent(QShowEvent*) override;

private:
    void setTexts();
    [[nodiscard]] QLayout* measuring();
    [[nodiscard]] QLayout* choosing();
    [[nodiscard]] QWidget* chartAndPictures();
    void connectParts();
    void measure();
    void find(bool byError);
    void start(StudyRequest);
    void step();
    void refresh();
    void showPoint(int point);
    void apply(std::size_t point);
    void showIdle();
    void showRunningOnceItHasAPoint();
    void save();
    void suggestTime();
    [[nodiscard]] StudyRequest requestFor(std::vector<StudyAxis>) const;
    [[nodiscard]] std::optional<std::size_t> presentPoint() const;

    Gallery& gallery_;
    History& history_;
    WithContext withContext_;
    StudyJob job_;
    StudyRequest request_;   ///< Of what is shown.
    StudyRequest running_;   ///< Of the study that runs.
    bool showsRunning_ = false;
    StudyResult result_;     ///< Of the study that ended last.
    std::size_t subject_ = 0;
    glm::ivec2 size_{320, 180};
    int runs_ = 5;
    QTimer timer_;
    QElapsedTimer sinceRefresh_, elapsed_;
    int shownPoint_ = -1;

    QComboBox* parameter_;
    QComboBox* view_;
    QPushButton* go_;
    QToolButton* copy_;
    QToolButton* save_;
    QProgressBar* progress_;
    QLabel* doing_;
    QLabel* words_;
    QLabel* caption_;
    QLineEdit* error_;
    QLineEdit* milliseconds_;
    StudyChart* chart_;
    StudyPictures* pictures_;
};

}  // namespace vitrine::ui
