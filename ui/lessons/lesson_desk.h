#pragma once

#include "exhibits/framework/lesson.h"
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

/// The lesson that is open: applies its steps to the settings on show, each as one undo step, and brings back what was
/// open before when it is left. Undo and redo lead through the lesson, too.
class LessonDesk final : public QObject {
    Q_OBJECT

public:
    /// The window must outlive it.
    LessonDesk(Workbench&, QObject* parent);

    /// The strip over the picture; in a layout from then on.
    [[nodiscard]] LessonBar& bar() const { return *bar_; }
    /// In the order of the menu; null is a separator.
    [[nodiscard]] const QList<QAction*>& actions() const { return actions_; }
    [[nodiscard]] QAction& nextAction() const { return *next_; }
    [[nodiscard]] QAction& backAction() const { return *back_; }
    [[nodiscard]] QAction& leaveAction() const { return *leave_; }

    /// Opens a lesson; what is wrong with the file is said in the message strip, and nothing changes.
    void open(const QString& path);
    /// The lesson that comes with this exhibit.
    void start(std::size_t exhibit);
    void next();
    void back();
    /// Closes the lesson and shows what was on show before it was opened.
    void leave();

    /// Null: none is open.
    [[nodiscard]] const Lesson* lesson() const { return place_.opened ? &place_.opened->lesson : nullptr; }
    /// 0: the introduction; else the number of the step.
    [[nodiscard]] std::size_t page() const { return place_.page; }
    /// The text of the page as rich text, its rows as links: "row:samples".
    [[nodiscard]] QString pageText() const;
    /// The number that the step asks the reader to look up, and what it was in the step before; empty: none. An
    /// ellipsis takes its place until the settings on show are drawn at full resolution.
    [[nodiscard]] QString numberText() const;

signals:
    /// Somebody wants to see this row of the lesson's exhibit; "hall.exposure" is one of the hall.
    void rowAsked(const QString& row);
    /// The visitor chose a file, and it was read.
    void opened(const QString& path);

private:
    /// A lesson, and what was on show when it was opened.
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

    Workbench& window_;
    Place place_;
    LessonBar* bar_ = nullptr;
    QList<QAction*> actions_;
    QAction* next_ = nullptr;
    QAction* back_ = nullptr;
    QAction* leave_ = nullptr;
    /// A number as it was read, and the scene state that it was read of (`Viewport::sceneStateNumber`).
    struct ReadNumber {
        QString text;
        long long sceneState = 0;
    };
    std::map<std::size_t, ReadNumber> numbers_;  ///< Read last, by page of the lesson that is open.
};

}  // namespace vitrine::ui
