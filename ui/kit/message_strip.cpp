#include "ui/kit/message_strip.h"

#include "ui/kit/accessible_content.h"
#include "ui/kit/appearance.h"
#include "ui/kit/home_path.h"
#include "ui/kit/show_in_folder.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"

#include <QApplication>
#include <QClipboard>
#include <QDesktopServices>
#include <QEvent>
#include <QGraphicsOpacityEffect>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPropertyAnimation>
#include <QScrollArea>
#include <QScrollBar>
#include <QTextDocument>
#include <QTimer>
#include <QToolButton>
#include <QUrl>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr int highest = 132;    // Largest height in pixels: a few messages; more of them scroll.
constexpr int narrowest = 200;  // Smallest width in pixels to which messages are fitted.

class Line final : public QWidget, public AccessibleContent {
public:
    [[nodiscard]] QAccessible::Role accessibleRole() const override
    {
        return mood_ == MessageStrip::Mood::problem ? QAccessible::AlertMessage : QAccessible::Notification;
    }
    Line(MessageStrip::Mood mood, const QString& text, QWidget* parent)
        : QWidget(parent), mood_(mood), words_(new QLabel(this))
    {
        words_->setTextFormat(Qt::PlainText);
        words_->setWordWrap(true);
        words_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        words_->setAccessibleName(MessageStrip::tr("Message"));
        setText(text);
        auto* copy = button(MessageStrip::tr("Copy"), MessageStrip::tr("Copy this message"));
        open_ = button(MessageStrip::tr("Open"), MessageStrip::tr("Open the file with its usual program"));
        folder_ = button(MessageStrip::tr("Show in folder"), MessageStrip::tr("Show the file in its folder"));
        auto* dismiss = button(QStringLiteral("✕"), MessageStrip::tr("Dismiss this message"));
        auto* layout = new QHBoxLayout(this);
        layout->setContentsMargins(16, 4, 8, 4);
        layout->setSpacing(8);
        layout->addWidget(words_, 1);
        layout->addWidget(open_, 0, Qt::AlignTop);
        layout->addWidget(folder_, 0, Qt::AlignTop);
        layout->addWidget(copy, 0, Qt::AlignTop);
        open_->hide();
        folder_->hide();
        connect(open_, &QToolButton::clicked, this, [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(file_)); });
        connect(folder_, &QToolButton::clicked, this, [this] { showInFolder(file_); });
        layout->addWidget(dismiss, 0, Qt::AlignTop);
        connect(copy, &QToolButton::clicked, this, [this] { QApplication::clipboard()->setText(text_); });
        life_.setSingleShot(true);
        connect(&life_, &QTimer::timeout, this, [this] { fade(); });
        connect(dismiss, &QToolButton::clicked, this, &QObject::deleteLater);
    }
    /// Text with whole paths, as it is copied.
    [[nodiscard]] const QString& text() const { return text_; }
    [[nodiscard]] QString shownText() const { return words_->text(); }

    /// Counts one more notice of the same kind. The text is `several` with the number and the newest notice's `what`.
    void repeat(const QString& several, const QString& what)
    {
        setText(several.arg(++count_).arg(what));
        goAfter(life_.interval());
    }
    [[nodiscard]] const QString& kind() const { return kind_; }
    void setKind(const QString& several) { kind_ = several; }
    /// Sets the file that the message is about; empty: none.
    void setFile(const QString& file)
    {
        file_ = file;
        open_->setVisible(!file.isEmpty());
        folder_->setVisible(!file.isEmpty());
    }
    /// Fades out after this time, once the pointer is elsewhere.
    void goAfter(int milliseconds) { life_.start(milliseconds); }

private:
    void setText(const QString& text)
    {
        text_ = text;
        words_->setText(withShortPaths(text));
        words_->setToolTip(words_->text() == text ? QString() : Qt::convertFromPlainText(text));
        setAccessibleName(words_->text());
    }
    void fade()
    {
        if (underMouse()) {
            life_.start();
            return;
        }
        if (reducedMotion()) return deleteLater();
        auto* veil = new QGraphicsOpacityEffect(this);
        setGraphicsEffect(veil);
        auto* fading = new QPropertyAnimation(veil, "opacity", this);
        fading->setDuration(400);
        fading->setStartValue(1.0);
        fading->setEndValue(0.0);
        connect(fading, &QAbstractAnimation::finished, this, &QObject::deleteLater);
        fading->start();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.fillRect(QRect(0, 0, 4, height()), mood_ == MessageStrip::Mood::problem ? theme().error : theme().good);
    }

private:
    QToolButton* button(const QString& face, const QString& name)
    {
        auto* made = new QToolButton(this);
        made->setText(face);
        made->setAutoRaise(true);
        made->setAccessibleName(name);
        made->setToolTip(name);
        made->setFocusPolicy(Qt::StrongFocus);
        return made;
    }

    MessageStrip::Mood mood_;
    QLabel* words_;
    QToolButton *open_, *folder_;
    QString text_, kind_, file_;
    int count_ = 1;
    QTimer life_;
};

}  // namespace

MessageStrip::MessageStrip(QWidget* parent)
    : QWidget(parent), scroll_(new QScrollArea(this)), content_(new QWidget), list_(new QVBoxLayout(content_)),
      closeAll_(new QToolButton(this))
{
    list_->setContentsMargins(0, 0, 0, 0);
    list_->setSpacing(1);
    scroll_->setWidget(content_);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setFocusPolicy(Qt::NoFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(scroll_);
    layout->addWidget(closeAll_, 0, Qt::AlignRight);
    closeAll_->setText(tr("Close all"));
    closeAll_->setAccessibleName(tr("Close all"));
    closeAll_->setToolTip(tr("Dismisses all messages."));
    closeAll_->setAutoRaise(true);
    closeAll_->setFocusPolicy(Qt::StrongFocus);
    connect(closeAll_, &QToolButton::clicked, this, &MessageStrip::dismissAll);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    hide();
}

void MessageStrip::lieOver(QWidget* under)
{
    under_ = under;
    setParent(under->parentWidget());
    under->installEventFilter(this);
    fit();
}

void MessageStrip::say(Mood mood, const QString& text, const QString& several, const QString& what, const QString& file)
{
    emit said(text);
    Line *line = nullptr, *same = nullptr;
    for (int i = 0; i < list_->count(); ++i) {
        auto* other = dynamic_cast<Line*>(list_->itemAt(i)->widget());
        if (!other) continue;
        if (other->text() == text) same = other;
        if (!several.isEmpty() && other->kind() == several) line = other;
    }
    if (same) line = same;
    if (line) {
        if (!same) line->repeat(several, what);
        list_->removeWidget(line);
        list_->insertWidget(0, line);
        scroll_->verticalScrollBar()->setValue(0);
        if (same) return;
    } else {
        line = new Line(mood, text, content_);
        line->setKind(several);
        list_->insertWidget(0, line);
        scroll_->verticalScrollBar()->setValue(0);
        connect(line, &QObject::destroyed, this, [this] { QTimer::singleShot(0, this, &MessageStrip::fit); });
        if (mood == Mood::notice) line->goAfter(noticeTime_);
    }
    line->setFile(file);
    fit();
    announce(*line, line->shownText());
    QTimer::singleShot(0, this, &MessageStrip::fit);  // Wrapped lines know their height only once their width is set.
}

void MessageStrip::setBanned(bool banned)
{
    banned_ = banned;
    fit();
}

bool MessageStrip::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == under_ && (event->type() == QEvent::Resize || event->type() == QEvent::Move)) fit();
    return QWidget::eventFilter(watched, event);
}

void MessageStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), theme().window);
}

QStringList MessageStrip::texts() const
{
    QStringList all;
    for (int i = 0; i < list_->count(); ++i)
        if (const auto* line = dynamic_cast<Line*>(list_->itemAt(i)->widget())) all << line->text();
    return all;
}

void MessageStrip::setProblems(const QString& cause, const QStringList& texts)
{
    const QStringList before = problems_.value(cause);
    if (texts.isEmpty())
        problems_.remove(cause);
    else
        problems_.insert(cause, texts);
    for (const QString& text : before)
        if (!texts.contains(text)) takeBack(text);
    for (const QString& text : texts)
        if (!before.contains(text)) say(Mood::problem, text);
}

void MessageStrip::takeBack(const QString& text)
{
    for (int i = list_->count() - 1; i >= 0; --i)
        if (const auto* line = dynamic_cast<Line*>(list_->itemAt(i)->widget()); line && line->text() == text)
            delete line;
}

void MessageStrip::dismissAll()
{
    for (int i = 0; i < list_->count(); ++i) list_->itemAt(i)->widget()->deleteLater();
}

void MessageStrip::fit()
{
    setVisible(list_->count() > 0 && !banned_);
    closeAll_->setVisible(list_->count() > 1);
    const int wide = under_ ? under_->width() : width();
    const int wanted =
        list_->hasHeightForWidth() ? list_->heightForWidth(std::max(narrowest, wide)) : list_->sizeHint().height();
    const int below = list_->count() > 1 ? closeAll_->sizeHint().height() : 0;
    setFixedHeight(std::min(grown(highest, *this), wanted) + below);
    if (!under_) return;
    setGeometry(under_->x(), under_->y(), wide, height());
    raise();
}

}  // namespace vitrine::ui

#include "moc_message_strip.cpp"
