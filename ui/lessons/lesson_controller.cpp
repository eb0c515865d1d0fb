#include "ui/lessons/lesson_controller.h"

#include "exhibits/framework/files/lesson_markup.h"
#include "exhibits/framework/files/table_change.h"
#include "exhibits/museum/lesson_scene.h"
#include "exhibits/museum/museum.h"
#include "exhibits/study/study_text.h"
#include "render/plan/render_backend.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/numbers.h"
#include "ui/kit/text.h"
#include "ui/lessons/formula_text.h"
#include "ui/lessons/lesson_bar.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/parameters/shown_text.h"
#include "ui/viewport/viewport.h"

#include <QAction>
#include <QFileDialog>
#include <QImageReader>
#include <QLocale>
#include <QWidget>

#include <filesystem>

namespace vitrine::ui {
namespace {

QString words(const std::string& s)
{
    return QString::fromStdString(s);
}

/// Largest picture of a lesson in the strip, in pixels.
constexpr QSize largestPicture(480, 160);

/// Returns a picture of the lesson as rich text, made smaller if it is too large for the strip.
std::string pictureText(const std::filesystem::path& file, const std::string& alternative)
{
    const QString path = QString::fromStdString(std::filesystem::absolute(file).string());
    const QSize size = QImageReader(path).size();
    if (!size.isValid()) return alternative;
    const QSize shown = size.width() <= largestPicture.width() && size.height() <= largestPicture.height()
                            ? size
                            : size.scaled(largestPicture, Qt::KeepAspectRatio);
    return QStringLiteral("<img src=\"%1\" width=\"%2\" height=\"%3\" alt=\"%4\">")
        .arg(path.toHtmlEscaped())
        .arg(shown.width())
        .arg(shown.height())
        .arg(words(alternative).toHtmlEscaped())
        .toStdString();
}

/// Replaces blocks of code (`<pre>`) by paragraphs with line breaks. QLabel would cut off the last lines of a block.
QString withCodeAsLines(const QString& html)
{
    const QString begin = QStringLiteral("<pre>"), end = QStringLiteral("</pre>");
    QString result;
    qsizetype from = 0;
    for (qsizetype at = html.indexOf(begin); at >= 0; at = html.indexOf(begin, from)) {
        const qsizetype close = html.indexOf(end, at);
        if (close < 0) break;
        QStringList lines = html.mid(at + begin.size(), close - at - begin.size()).trimmed().split(QLatin1Char('\n'));
        for (QString& line : lines) {
            qsizetype indent = 0;
            while (indent < line.size() && line[indent] == QLatin1Char(' ')) ++indent;
            line.replace(0, indent, QStringLiteral("&nbsp;").repeated(indent));
        }
        result += html.mid(from, at - from) + QStringLiteral("<p><code>") + lines.join(QStringLiteral("<br/>")) +
                  QStringLiteral("</code></p>");
        from = close + end.size();
    }
    return result + html.mid(from);
}

/// Converts the HTML of a lesson's text to rich text of the strip, which is low: paragraphs without lists, code and the
/// like are separated by line breaks, without space.
QString stripText(const std::string& html)
{
    QString rich = withFormulasAsText(words(html)).trimmed();
    rich.replace(QLatin1String("<strong>"), QLatin1String("<b>"))
        .replace(QLatin1String("</strong>"), QLatin1String("</b>"));
    rich = withCodeAsLines(rich);
    rich.replace(QLatin1String("</p>\n<p>"), QLatin1String("<br/>"));
    if (rich.startsWith(QLatin1String("<p>")) && rich.indexOf(QLatin1String("</p>")) == rich.size() - 4)
        return rich.mid(3, rich.size() - 7);
    rich.replace(QLatin1String("<p>"), QLatin1String("<p style=\"margin-top: 0; margin-bottom: 2px\">"));
    return rich;
}

}  // namespace

LessonController::LessonController(Workbench& window, QObject* parent) : QObject(parent), window_(window)
{
    addActions();
    bar_ = new LessonBar(*this);
    connect(&window.viewport().pictures(), &ViewportPictures::drawn, this, &LessonController::noteFrame);
    connect(&window.viewport(), &Viewport::looked, this, &LessonController::show);
    connect(&window.history(), &History::changesSettled, this, &LessonController::show);
    show();
}

QAction* LessonController::add(const QString& id, const QString& text, const QList<QKeySequence>& keys,
                               const QString& tip)
{
    auto* action = new QAction(text, this);
    action->setObjectName(QStringLiteral("lesson-") + id);
    action->setShortcuts(keys);
    action->setToolTip(tip);
    action->setStatusTip(tip);
    menu_ << action;
    return action;
}

void LessonController::addActions()
{
    connect(add(QStringLiteral("start"), tr("&Start the lesson"), {QKeySequence(Qt::CTRL | Qt::Key_L)},
                tr("Starts the step-by-step lesson about the visited exhibit.")),
            &QAction::triggered, this, [this] {
                if (window_.chosen() != hallIndex) return start(window_.chosen());
                window_.say(MessageStrip::Mood::notice,
                            tr("Visit an exhibit first; each lesson is about one exhibit."));
            });
    connect(add(QStringLiteral("open"), tr("&Open lesson…"), {},
                tr("Opens a lesson of your own (Markdown); the manual explains the format.")),
            &QAction::triggered, this, &LessonController::askForFile);
    connect(add(QStringLiteral("syllabus"), tr("Order of the lessons (for &teachers)"), {},
                tr("Opens a page with all lessons: their order, aims, times and prerequisites.")),
            &QAction::triggered, this, &LessonController::syllabusAsked);
    back_ = add(QStringLiteral("back"), tr("Step &back"), {QKeySequence(Qt::CTRL | Qt::Key_PageUp)},
                tr("Goes to the previous step of the lesson."));
    connect(back_, &QAction::triggered, this, &LessonController::back);
    next_ = add(QStringLiteral("next"), tr("&Next step"), {QKeySequence(Qt::CTRL | Qt::Key_PageDown)},
                tr("Goes to the next step of the lesson."));
    connect(next_, &QAction::triggered, this, &LessonController::next);
    leave_ = add(QStringLiteral("leave"), tr("&Leave the lesson"), {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L)},
                 tr("Leaves the lesson and restores your settings."));
    connect(leave_, &QAction::triggered, this, &LessonController::leave);
    answer_ = add(QStringLiteral("answer"), tr("Show the &answer"), {},
                  tr("Shows or hides the answer to the question of this step."));
    answer_->setCheckable(true);
    connect(answer_, &QAction::toggled, this, &LessonController::show);
    for (QAction* step : {back_, next_, leave_, answer_}) {
        menu_.removeOne(step);
        steps_ << step;
    }
}

void LessonController::askForFile()
{
    auto* dialog = new QFileDialog(bar_->window(), tr("Open lesson"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Lessons (*.md)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &LessonController::open);
    dialog->open();
}

void LessonController::open(const QString& path)
{
    try {
        load(path);
        window_.setProblems(openingOf(path), {});
        emit opened(path);
    } catch (const std::exception& failure) {
        window_.setProblems(openingOf(path), {});
        window_.setProblems(openingOf(path), {messageOf(failure)});
    }
}

void LessonController::load(const QString& path)
{
    const Museum& museum = window_.museum();
    NamedValues tables = namedValues(museum.subjects(), museum.initialSceneState().values);
    Lesson lesson = readLesson(path.toStdString(), tables);
    const std::size_t exhibit = *museum.find(lesson.exhibit);
    auto next = std::make_shared<Opened>(
        Opened{std::move(lesson), exhibit, window_.history().sceneState(), std::move(tables), window_.chosen()});
    if (place_.opened) {  // A lesson opened from another one: leaving it restores the state from before both.
        next->before = place_.opened->before;
        next->chosenBefore = place_.opened->chosenBefore;
    }
    for (const std::string& note : next->lesson.notes)
        window_.say(MessageStrip::Mood::notice, tr("%1 was opened, with changes: %2").arg(path, words(note)));
    const QString title = words(next->lesson.title);
    goTo({std::move(next), 0}, tr("Open lesson %1").arg(title));
}

void LessonController::start(std::size_t exhibit)
{
    try {
        load(words(shippedLesson(window_.museum().subject(exhibit).name()).string()));
    } catch (const std::exception& failure) {
        window_.say(MessageStrip::Mood::problem, messageOf(failure));
    }
}

void LessonController::next()
{
    if (!lesson() || place_.page >= lesson()->steps.size()) return;
    goTo({place_.opened, place_.page + 1}, tr("Lesson step %1").arg(place_.page + 1));
}

void LessonController::back()
{
    if (!lesson() || place_.page == 0) return;
    goTo({place_.opened, place_.page - 1}, tr("Lesson step %1").arg(place_.page - 1));
}

void LessonController::leave()
{
    if (lesson()) goTo({}, tr("Leave the lesson"));
}

SceneState LessonController::stateAt(const Place& place, bool& movesCamera) const
{
    movesCamera = true;
    if (!place.opened) return place_.opened->before;  // Without a place, the lesson is being left: there is one open.
    const Opened& opened = *place.opened;
    SceneState state = opened.before;
    state.camera = window_.history().sceneState().camera;
    if (place.page == 0) {
        state.camera = window_.museum().bestView(opened.exhibit, state.values[opened.exhibit]);
        return state;
    }
    const LessonStep& step = opened.lesson.steps[place.page - 1];
    movesCamera = step.camera || step.bestView;
    return sceneOfStep(window_.museum(), opened.exhibit, step, std::move(state));
}

void LessonController::goTo(const Place& to, const QString& step)
{
    History& history = window_.history();
    bool movesCamera = false;
    SceneState after = stateAt(to, movesCamera);
    for (std::size_t i = 0; i < after.values.size(); ++i)
        after.values[i] = withTableOf(history.sceneState().values[i], after.values[i]);
    history.record(
        step, after, [this, to] { stand(to); }, [this, from = place_] { stand(from); },
        movesCamera ? History::Camera::moves : History::Camera::stays);
    show();
}

void LessonController::stand(const Place& to)
{
    const Place from = std::exchange(place_, to);
    answer_->setChecked(false);
    if (from.opened == to.opened) return show();
    numbers_.clear();
    window_.choose(to.opened ? to.opened->exhibit : from.opened->chosenBefore);
    show();
}

const LessonNumber* LessonController::asked(std::size_t page) const
{
    if (!lesson() || page == 0) return nullptr;
    const std::optional<LessonNumber>& read = lesson()->steps[page - 1].read;
    return read ? &*read : nullptr;
}

void LessonController::noteFrame(const render::FrameReport& report, const QSize& pixels)
{
    const LessonNumber* number = asked(place_.page);
    if (!number || number->of == LessonNumber::Of::row) return;
    // The report may belong to a picture of earlier settings, or to an unfinished one with incomplete counters.
    Viewport& viewport = window_.viewport();
    const long long sceneState = viewport.pictures().drawnSceneState();
    if (report.unfinished || sceneState != viewport.scene().number()) return;
    // Pictures in motion have a lower resolution, and their numbers are not comparable.
    if (pixels != (QSizeF(viewport.size()) * viewport.devicePixelRatioF()).toSize()) return;
    const QLocale plain = numberLocale();
    if (number->of == LessonNumber::Of::milliseconds) {
        numbers_[place_.page] = {tr("%1 ms").arg(plain.toString(report.milliseconds, 'f', 1)), sceneState};
    } else {
        const auto found = report.counters.find(number->name);
        if (found == report.counters.end()) return;
        numbers_[place_.page] = {plain.toString(static_cast<qlonglong>(found->second)), sceneState};
    }
    show();
}

QString LessonController::nameOf(const LessonNumber& number) const
{
    switch (number.of) {
    case LessonNumber::Of::counter: return translatedText(study::costTitle(number.name));
    case LessonNumber::Of::milliseconds: return tr("time of a picture");
    case LessonNumber::Of::row: break;
    }
    return words(withLabels("[row:" + number.name + "]", lesson()->exhibit, place_.opened->tables, "", ""));
}

QString LessonController::numberText() const
{
    const LessonNumber* number = asked(place_.page);
    if (!number) return {};
    if (number->of == LessonNumber::Of::row) {
        const bool ofHall = number->name.starts_with("hall.");
        const ParameterValues& values =
            window_.history().sceneState().values[ofHall ? hallIndex : place_.opened->exhibit];
        const auto row = values.table().find(ofHall ? number->name.substr(5) : number->name);
        return row ? tr("Read: %1 %2").arg(nameOf(*number), shownText(values.rows()[*row], values.row(*row)))
                   : QString();
    }
    const auto now = numbers_.find(place_.page);
    const bool isCurrent = now != numbers_.end() && now->second.sceneState == window_.viewport().scene().number();
    QString line = tr("Read: %1 %2").arg(nameOf(*number), isCurrent ? now->second.text : QStringLiteral("…"));
    const LessonNumber* before = asked(place_.page - 1);
    const auto then = numbers_.find(place_.page - 1);
    if (before && before->of == number->of && before->name == number->name && then != numbers_.end())
        line += tr(", previous step %1").arg(then->second.text);
    return line;
}

QString LessonController::pageText() const
{
    if (!lesson()) return {};
    return shown(presentStep() ? presentStep()->text : lesson()->intro);
}

QString LessonController::taskText() const
{
    return presentStep() && !presentStep()->task.empty() ? tr("<b>Try:</b> %1").arg(shown(presentStep()->task))
                                                         : QString();
}

QString LessonController::questionText() const
{
    return presentStep() && !presentStep()->question.empty()
               ? tr("<b>Question:</b> %1").arg(shown(presentStep()->question))
               : QString();
}

QString LessonController::answerText() const
{
    return presentStep() && answer_->isChecked() ? shown(presentStep()->answer) : QString();
}

const LessonStep* LessonController::presentStep() const
{
    return lesson() && place_.page > 0 ? &lesson()->steps[place_.page - 1] : nullptr;
}

QString LessonController::shown(const std::string& text) const
{
    const Lesson& opened = *lesson();
    const auto parameter = [&](std::string_view name) {
        const std::string mark = "[row:" + std::string(name) + ']';
        const std::string label = withLabels(mark, opened.exhibit, place_.opened->tables, "", "");
        return "<a href=\"row:" + std::string(name) + "\"><b>" + words(label).toHtmlEscaped().toStdString() +
               "</b></a>";
    };
    const auto picture = [&](const std::string& file, const std::string& alternative) {
        return pictureText(opened.folder / file, alternative);
    };
    return stripText(lessonHtml(text, {parameter, picture, opened.folder}));
}

void LessonController::show()
{
    const bool open = lesson() != nullptr;
    next_->setEnabled(open && place_.page < lesson()->steps.size());
    back_->setEnabled(open && place_.page > 0);
    leave_->setEnabled(open);
    answer_->setEnabled(presentStep() && !presentStep()->answer.empty());
    if (bar_) bar_->refresh();
}

}  // namespace vitrine::ui

#include "moc_lesson_controller.cpp"
