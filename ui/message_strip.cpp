#include "ui/message_strip.h"

#include "ui/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr int highest = 132;  // Pixels: a few messages; more of them scroll.

class Line final : public QWidget {
public:
    Line(MessageStrip::Mood mood, const QString& text, QWidget* parent)
        : QWidget(parent), mood_(mood), words_(new QLabel(text, this))
    {
        words_->setTextFormat(Qt::PlainText);
        words_->setWordWrap(true);
        words_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        words_->setAccessibleName(MessageStrip::tr("Message"));
        auto* copy = button(MessageStrip::tr("Copy"), MessageStrip::tr("Copy this message"));
        auto* dismiss = button(QStringLiteral("✕"), MessageStrip::tr("Dismiss this message"));
        auto* layout = new QHBoxLayout(this);
        layout->setContentsMargins(16, 4, 8, 4);
        layout->setSpacing(8);
        layout->addWidget(words_, 1);
        layout->addWidget(copy, 0, Qt::AlignTop);
        layout->addWidget(dismiss, 0, Qt::AlignTop);
        connect(copy, &QToolButton::clicked, this, [this] { QApplication::clipboard()->setText(words_->text()); });
        connect(dismiss, &QToolButton::clicked, this, &QObject::deleteLater);
    }
    [[nodiscard]] QString text() const { return words_->text(); }

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
};

}  // namespace

MessageStrip::MessageStrip(QWidget* parent)
    : QWidget(parent), scroll_(new QScrollArea(this)), content_(new QWidget), list_(new QVBoxLayout(content_))
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
    layout->addWidget(scroll_);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    hide();
}

void MessageStrip::say(Mood mood, const QString& text)
{
    emit said(text);
    if (texts().contains(text)) return;
    auto* line = new Line(mood, text, content_);
    list_->addWidget(line);
    connect(line, &QObject::destroyed, this, [this] { QTimer::singleShot(0, this, &MessageStrip::fit); });
    fit();
    QTimer::singleShot(0, this, &MessageStrip::fit);  // Once the width is known, wrapped lines know their height.
}

QStringList MessageStrip::texts() const
{
    QStringList all;
    for (int i = 0; i < list_->count(); ++i)
        if (const auto* line = dynamic_cast<Line*>(list_->itemAt(i)->widget())) all << line->text();
    return all;
}

void MessageStrip::dismissAll()
{
    for (int i = 0; i < list_->count(); ++i) list_->itemAt(i)->widget()->deleteLater();
}

void MessageStrip::fit()
{
    setVisible(list_->count() > 0);
    const int wanted = list_->hasHeightForWidth() ? list_->heightForWidth(std::max(200, width())) : list_->sizeHint().height();
    setFixedHeight(std::min(highest, wanted));
}

}  // namespace vitrine::ui

#include "moc_message_strip.cpp"
