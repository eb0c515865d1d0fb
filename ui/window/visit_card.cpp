#include "ui/window/visit_card.h"

#include "exhibits/framework/files/state_folder.h"
#include "exhibits/framework/scene/scene_object.h"
#include "ui/kit/flat_style.h"
#include "ui/kit/flow_layout.h"
#include "ui/kit/ini_file.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/model/history.h"
#include "ui/viewport/viewport.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSettings>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int cardWidth = 340;
constexpr int margin = 16;
const QString visitedKey = QStringLiteral("visitedExhibits");

/// Notes that the exhibit was visited. Returns whether this was the first time.
bool noteVisit(const QString& exhibit)
{
    QSettings settings(iniPath(QString::fromStdString((stateFolder() / "window.ini").string())), QSettings::IniFormat);
    QStringList visited = settings.value(visitedKey).toStringList();
    if (visited.contains(exhibit)) return false;
    visited << exhibit;
    visited.sort();
    settings.setValue(visitedKey, visited);
    return true;
}

}  // namespace

VisitCard::VisitCard(Viewport& picture, History& history,
                     std::function<std::vector<VisitOffer>(std::size_t exhibit)> offers)
    : QFrame(&picture), picture_(picture), offers_(std::move(offers)), title_(new QLabel(this)),
      summary_(new QLabel(this)), buttons_(new FlowLayout)
{
    setObjectName(QStringLiteral("visitCard"));
    setCursor(Qt::ArrowCursor);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(14, 6, 8, 8);
    layout->setSpacing(4);
    auto* top = new QHBoxLayout;
    top->setSpacing(8);
    title_->setTextFormat(Qt::PlainText);
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    top->addWidget(title_, 1);
    auto* close = new QToolButton(this);
    close->setText(QStringLiteral("✕"));
    close->setAutoRaise(true);
    close->setAccessibleName(tr("Close this card"));
    close->setToolTip(close->accessibleName());
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    top->addWidget(close);
    layout->addLayout(top);
    summary_->setTextFormat(Qt::PlainText);
    summary_->setWordWrap(true);
    layout->addWidget(summary_);
    buttons_->setSpacing(4);
    layout->addLayout(buttons_);
    hide();
    picture.installEventFilter(this);
    connect(&history, &History::changesSettled, this, [this](const auto& exhibits) {
        if (exhibits.contains(exhibit_)) hide();
    });
}

void VisitCard::follow(std::size_t exhibit, const SceneObject& subject)
{
    hide();
    if (banned_) return;
    const std::vector<VisitOffer> offers = offers_(exhibit);
    if (offers.empty() || !noteVisit(text(subject.name()))) return;
    exhibit_ = exhibit;
    title_->setText(translatedText(subject.title()));
    summary_->setText(translatedText(subject.summary()));
    setAccessibleName(tr("First visit of %1").arg(title_->text()));
    fill(offers);
    place();
    show();
}

void VisitCard::fill(const std::vector<VisitOffer>& offers)
{
    while (QLayoutItem* item = buttons_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const VisitOffer& offer : offers) {
        auto* button = new QToolButton(this);
        button->setText(offer.face);
        button->setToolTip(offer.tip);
        button->setAccessibleName(offer.tip);
        button->setFocusPolicy(Qt::StrongFocus);
        buttons_->addWidget(button);
        // The card is hidden first, because what follows may visit another exhibit.
        connect(button, &QToolButton::clicked, this, [this, act = offer.act] {
            hide();
            act();
        });
    }
}

void VisitCard::setBanned(bool banned)
{
    banned_ = banned;
    if (banned) hide();
}

void VisitCard::place()
{
    const QSize room = picture_.size();
    const int width = std::min(grown(cardWidth, *this), room.width() - 2 * margin);
    const int height =
        std::max(layout()->hasHeightForWidth() ? layout()->heightForWidth(width) : 0, layout()->minimumSize().height());
    // A small picture is not hidden behind the card.
    setGeometry(margin, room.height() - height - margin, width, height);
    if (height > room.height() / 2) hide();
}

void VisitCard::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(theme().outline);
    painter.setBrush(theme().window);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

bool VisitCard::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && isVisible()) place();
    return QFrame::eventFilter(watched, event);
}

}  // namespace vitrine::ui

#include "moc_visit_card.cpp"
