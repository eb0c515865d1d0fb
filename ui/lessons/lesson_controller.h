#pragma once

#include "exhibits/framework/files/lesson.h"
#include "exhibits/museum/scene_state.h"

#include <QList>
#include <QObject>
#include <QSize>
#include <QString>

#include <map>
#include <memory>
#include <optional>

class QAction;

namespace vitrine::render {
struct FrameReport;
}

namespace vitrine::ui {

class LessonBar;
class Workbench;

/// The open lesson: applies its steps to the present settings, each as one undo step. Leaving it restores the settings
/// from before. Undo and redo also change the step.
class LessonController final : public QObject {
    Q_OBJECT

public:
    /// The window must outlive this object.
    LessonController(Workbench&, QObject* parent);

    /// Returns the bar above the picture. Put it into a layout, which then owns it.
    [[nodiscard]] LessonBar& bar() const { return *bar_; }
    /// Returns the commands in the order of the menu; null is a separator.
    [[nodiscard]] const QList<QAction*>& menu() const { return menu_; }
    /// Returns the commands of the strip with the steps, which have keys and are in no menu.
    [[nodiscard]] const QList<QAction*>& steps() const { return steps_; }
    [[nodiscard]] QAction& nextAction() const { return *next_; }
    [[nodiscard]] QAction& backAction() const { return *back_; }
    [[nodiscard]] QAction& leaveAction() const { return *leave_; }
    /// Returns the command that shows or hides the answer to the step's question.
    [[nodiscard]] QAction& answerAction() const { return *answer_; }

    /// Opens a lesson file. An error in it is reported in the message strip, and nothing changes.
    void open(const QString& path);
    /// Opens the lesson that comes with this exhibit.
    void start(std::size_t exhibit);
    void next();
    void back();
    /// Closes the lesson and restores the settings from before it was opened.
    void leave();

    /// Returns the open lesson; null if there is none.
    [[nodiscard]] const Lesson* lesson() const { return place_.opened ? &place_.opened->lesson : nullptr; }
    /// Returns the page: 0 is the introduction, others are numbers of steps.
    [[nodiscard]] std::size_t page() const { return place_.page; }
    /// Returns the page's text as rich text. Parameters in it are links: "row:samples".
    [[nodiscard]] QString pageText() const;
    /// Returns what to do in the present step, as rich text; empty if there is nothing.
    [[nodiscard]] QString taskText() const;
    /// Returns the question of the present step as rich text; empty if there is none.
    [[nodiscard]] QString questionText() const;
    /// Returns the answer to the question as rich text while it is open; else empty.
    [[nodiscard]] QString answerText() const;
    /// Returns the number that the step asks to read, with its value in the step before; empty if there is none. An
    /// ellipsis stands for the value until the present settings are drawn at full resolution.
    [[nodiscard]] QString numberText() const;

signals:
    /// Asks to show this parameter of the lesson's exhibit; "hall.exposure" is one of the hall.
    void parameterRequested(const QString& row);
    /// Asks to show the page with the order of the lessons.
    void syllabusAsked();
    /// Emitted when a file that the visitor chose was opened.
    void opened(const QString& path);

private:
    /// Open lesson, with the state from before it was opened.
    struct Opened {
        Lesson lesson;
        std::size_t exhibit = 0;
        SceneState before;
        NamedValues tables;
        std::size_t chosenBefore = 0;
    };
    struct Place {
        std::shared_ptr<const Opened> opened;  ///< Null: no lesson is open.
        std::size_t page = 0;
    };

    void addActions();
    QAction* add(const QString& id, const QString& text, const QList<QKeySequence>&, const QString& tip);
    void load(const QString& path);
    void askForFile();
    void goTo(const Place&, const QString& step);
    void stand(const Place&);
    void noteFrame(const render::FrameReport&, const QSize& pixels);
    void show();
    [[nodiscard]] SceneState stateAt(const Place&, bool& movesCamera) const;
    [[nodiscard]] const LessonNumber* asked(std::size_t page) const;
    [[nodiscard]] QString nameOf(const LessonNumber&) const;
    [[nodiscard]] const LessonStep* presentStep() const;
    [[nodiscard]] QString shown(const std::string& text) const;

    Workbench& window_;
    Place place_;
    LessonBar* bar_ = nullptr;
    QList<QAction*> menu_, steps_;
    QAction* next_ = nullptr;
    QAction* back_ = nullptr;
    QAction* leave_ = nullptr;
    QAction* answer_ = nullptr;
    /// Value as it was read, with the number of its scene state (`PresentScene::number`).
    struct ReadNumber {
        QString text;
        long long sceneState = 0;
    };
    std::map<std::size_t, ReadNumber> numbers_;  ///< Latest value of each page of the open lesson.
};

}  // namespace vitrine::ui
