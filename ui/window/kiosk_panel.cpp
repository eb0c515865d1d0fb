#include "ui/window/kiosk_panel.h"

#include "exhibits/museum/museum.h"
#include "ui/kit/language.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/model/history.h"
#include "ui/parameters/parameter_row.h"
#include "ui/viewport/viewport.h"

#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {
namespace {

// Pixels at the usual font size.
constexpr int kioskPanelWidth = 380, kioskPanelMargin = 16;

}  // namespace

KioskPanel::KioskPanel(Viewport& viewport, const Museum& museum, History& history, const std::vector<Place>& places)
    : QFrame(&viewport), picture_(viewport)
{
    setCursor(Qt::ArrowCursor);
    setAccessibleName(tr("Parameters"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 8, 6, 8);
    layout->setSpacing(2);
    std::vector<std::size_t> exhibits;
    for (const Place& place : places)
        if (std::find(exhibits.begin(), exhibits.end(), place.first) == exhibits.end()) exhibits.push_back(place.first);
    for (const std::size_t exhibit : exhibits) {
        auto* heading = new QLabel(translatedText(museum.subject(exhibit).title()), this);
        heading->setTextFormat(Qt::PlainText);
        heading->setIndent(16);
        QFont bold = heading->font();
        bold.setBold(true);
        heading->setFont(bold);
        layout->addWidget(heading);
        parts_.emplace_back(exhibit, heading);
        for (const Place& place : places) {
            if (place.first != exhibit) continue;
            const std::size_t index = place.second;
            auto* row = new ParameterRow(ValueRef(history, exhibit, index), this, ParameterRow::Label::whole);
            row->setContextMenuPolicy(Qt::NoContextMenu);
            layout->addWidget(row);
            parts_.emplace_back(exhibit, row);
            history.watch(exhibit, row, [&history, exhibit, index, row](std::optional<std::size_t> changed) {
                if (!changed || *changed == index) row->showValue(history.sceneState().values[exhibit].row(index));
            });
        }
    }
    picture_.installEventFilter(this);
    follow(hallIndex);
}

void KioskPanel::follow(std::size_t exhibit)
{
    bool any = false;
    for (const auto& [owner, part] : parts_) {
        const bool shown = owner == hallIndex || owner == exhibit;
        part->setVisible(shown);
        any = any || shown;
    }
    setVisible(any);
    if (any) place();
}

void KioskPanel::place()
{
    const QSize room = picture_.size();
    const int margin = grown(kioskPanelMargin, *this);
    const int width = std::min(grown(kioskPanelWidth, *this), room.width() - 2 * margin);
    layout()->activate();
    const int height = layout()->minimumSize().height();
    setGeometry(room.width() - width - margin, room.height() - height - margin, width, height);
}

bool KioskPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &picture_ && event->type() == QEvent::Resize && isVisible()) place();
    return QFrame::eventFilter(watched, event);
}

void KioskPanel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(theme().outline);
    painter.setBrush(theme().window);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

}  // namespace vitrine::ui

#include "moc_kiosk_panel.cpp"
