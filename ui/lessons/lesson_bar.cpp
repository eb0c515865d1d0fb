#include "ui/lessons/lesson_bar.h"

#include "exhibits/framework/files/lesson.h"
#include "ui/kit/accessible_widget.h"
#include "ui/kit/flow_layout.h"
#include "ui/kit/menu_text.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/lessons/lesson_controller.h"

#include <QAction>
#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QTimer>
#include <QToolButton>
#include <QUrl>

#include <utility>

namespace vitrine::ui {
namespace {

/// Changes the text only if it differs, so that selecting or reading it aloud is not interrupted.
void setWords(QLabel& label, const QString& words)
{
    if (label.text() != words) {
        label.setText(words);
        // The height of a text with code or pictures is known only after it was laid out once. Without a second layout,
        // the strip kept the height of the first one, and the last lines were cut off.
        QTimer::singleShot(0, &label, [&label] { label.updateGeometry(); });
    }
    label.setVisible(!words.isEmpty());
}

}  // namespace

LessonBar::LessonBar(LessonController& controller)
    : controller_(controller), title_(new QLabel(this)), count_(new QLabel(this)), text_(new QLabel(this)),
      task_(new QLabel(this)), number_(new QLabel(this)), question_(new QLabel(this)), answer_(new QLabel(this)),
      answerButton_(button(controller.answerAction(), tr("Answer ▸")))
{
    setAccessibleName(tr("Lesson"));
    title_->setTextFormat(Qt::PlainText);
    QFont heading = title_->font();
    heading.setWeight(QFont::DemiBold);
    title_->setFont(heading);
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    count_->setTextFormat(Qt::PlainText);
    addText(*text_, tr("What to see"));
    addText(*task_, tr("What to do"));
    addText(*question_, tr("Question"));
    addText(*answer_, tr("Answer"));
    number_->setTextFormat(Qt::PlainText);
    number_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    number_->setAccessibleName(tr("Number to read"));
    number_->setWordWrap(true);

    auto* top = new QHBoxLayout;
    top->setSpacing(4);
    top->addWidget(title_, 1);
    auto* below = new FlowLayout;
    const QList<QWidget*> parts{count_, button(controller.backAction(), tr("◂ Back")),
                                button(controller.nextAction(), tr("Next ▸")),
                                button(controller.leaveAction(), tr("✕ Leave"))};
    // Beside the title, or below it if the type is large.
    followType(*this, [this, top, below, parts] {
        const bool isLarge = isLargeType(*this);
        title_->setWordWrap(isLarge);
        for (QWidget* part : parts) {
            top->removeWidget(part);
            below->removeWidget(part);
            QLayout* place = below;
            if (!isLarge) place = top;
            place->addWidget(part);
        }
    });
    auto* asking = new QHBoxLayout;
    asking->setSpacing(8);
    asking->addWidget(question_, 1);
    asking->addWidget(answerButton_, 0, Qt::AlignTop);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 4, 8, 8);
    layout->setSpacing(2);
    layout->addLayout(top);
    layout->addLayout(below);
    layout->addWidget(text_);
    layout->addWidget(task_);
    layout->addWidget(number_);
    layout->addLayout(asking);
    layout->addWidget(answer_);
    setVisible(false);
}

void LessonBar::addText(QLabel& label, const QString& name)
{
    label.setTextFormat(Qt::RichText);
    label.setWordWrap(true);
    label.setTextInteractionFlags(Qt::TextBrowserInteraction);
    label.setAccessibleName(name);
    connect(&label, &QLabel::linkActivated, this, [this](const QString& link) {
        if (link.startsWith(QLatin1String("row:"))) emit controller_.parameterRequested(link.mid(4));
        // Other links are pages of the web: reading the lesson has refused all others.
        const QUrl page(link);
        if (page.scheme() == QLatin1String("https") || page.scheme() == QLatin1String("http"))
            QDesktopServices::openUrl(page);
    });
}

QToolButton* LessonBar::button(QAction& action, const QString& words)
{
    auto* made = new QToolButton(this);
    made->setAutoRaise(true);
    made->setFocusPolicy(Qt::TabFocus);
    made->setText(words);
    const auto showKey = [made, &action] { made->setToolTip(tipWithKey(action)); };
    showKey();
    connect(&action, &QAction::changed, made, showKey);
    made->setAccessibleName(action.text().remove(QLatin1Char('&')));
    made->setEnabled(action.isEnabled());
    connect(&action, &QAction::enabledChanged, made, &QToolButton::setEnabled);
    connect(made, &QToolButton::clicked, &action, &QAction::trigger);
    made->setCheckable(action.isCheckable());
    connect(&action, &QAction::toggled, made, &QToolButton::setChecked);
    return made;
}

void LessonBar::refresh()
{
    const Lesson* lesson = controller_.lesson();
    setVisible(lesson && !banned_);
    if (!lesson) {
        told_.clear();
        return;
    }
    const QString title = QString::fromStdString(lesson->title);
    const std::size_t page = controller_.page();
    setWords(*title_,
             page == 0 ? title : tr("%1: %2").arg(title, QString::fromStdString(lesson->steps[page - 1].title)));
    title_->setToolTip(title_->text());
    setWords(*count_, page == 0 ? tr("%1 steps").arg(lesson->steps.size())
                                : tr("Step %1 of %2").arg(page).arg(lesson->steps.size()));
    setWords(*text_, controller_.pageText());
    setWords(*task_, controller_.taskText());
    setWords(*number_, controller_.numberText());
    setWords(*question_, controller_.questionText());
    setWords(*answer_, controller_.answerText());
    answerButton_->setVisible(controller_.answerAction().isEnabled());
    answerButton_->setText(controller_.answerAction().isChecked() ? tr("Answer ▾") : tr("Answer ▸"));
    announceStep();
}

/// Announces the page to screen readers once, and again with an answer that was opened: the number on it may change all
/// the time.
void LessonBar::announceStep()
{
    QStringList page;
    for (const QLabel* each : {count_, title_, text_, task_, question_, answer_})
        if (!each->text().isEmpty()) page << plainText(*each);
    const QString words = page.join(QLatin1Char('\n'));
    if (isHidden() || std::exchange(told_, words) == words) return;
    setAccessibleName(words);
    announce(*this, words);
}

void LessonBar::setBanned(bool banned)
{
    banned_ = banned;
    refresh();
}

void LessonBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), theme().base);
    painter.fillRect(QRect(0, 0, 3, height()), theme().accent);
}

}  // namespace vitrine::ui

#include "moc_lesson_bar.cpp"
