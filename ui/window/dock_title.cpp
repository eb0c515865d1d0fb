#include "ui/window/dock_title.h"

#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QMainWindow>
#include <QMenu>
#include <QPainter>
#include <QPointer>
#include <QToolButton>

namespace vitrine::ui {
namespace {

constexpr int growth = 40;  // Pixels by which a panel grows and shrinks.

}  // namespace

DockTitle::DockTitle(QDockWidget* dock) : QWidget(dock), dock_(dock), menu_(new QMenu(this))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 4, 2);
    layout->setSpacing(0);
    layout->addStretch(1);
    const auto button = [&](const QString& face, const QString& name) {
        auto* made = new QToolButton(this);
        made->setText(face);
        made->setAutoRaise(true);
        growSize(*made, 22, 22);
        made->setAccessibleName(name);
        made->setToolTip(name);
        made->setFocusPolicy(Qt::TabFocus);
        layout->addWidget(made);
        return made;
    };
    const QString name = dock->windowTitle();
    QToolButton* moves = button(QStringLiteral("⋯"), tr("Move or resize %1").arg(name));
    moves->setMenu(menu_);
    moves->setPopupMode(QToolButton::InstantPopup);
    moves->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    addMoves();
    connect(button(QStringLiteral("✕"), tr("Close %1").arg(name)), &QToolButton::clicked, dock, &QDockWidget::close);
    showTheme();
}

void DockTitle::addMoves()
{
    const auto addSide = [&](const QString& text, Qt::DockWidgetArea side) {
        menu_->addAction(text, this, [this, side] {
            // Moving the dock takes the focus from its content.
            const QPointer<QWidget> focus = QApplication::focusWidget();
            dock_->setFloating(false);
            if (auto* window = qobject_cast<QMainWindow*>(dock_->parentWidget())) window->addDockWidget(side, dock_);
            if (focus) focus->setFocus(Qt::OtherFocusReason);
        });
    };
    const auto addSize = [&](const QString& text, Qt::Orientation along, int by) {
        menu_->addAction(text, this, [this, along, by] {
            const int size = along == Qt::Horizontal ? dock_->width() : dock_->height();
            if (auto* window = qobject_cast<QMainWindow*>(dock_->parentWidget()))
                window->resizeDocks({dock_}, {size + by}, along);
        });
    };
    menu_->setAccessibleName(tr("Move or resize %1").arg(dock_->windowTitle()));
    addSide(tr("To the &left"), Qt::LeftDockWidgetArea);
    addSide(tr("To the &right"), Qt::RightDockWidgetArea);
    addSide(tr("To the &bottom"), Qt::BottomDockWidgetArea);
    menu_->addAction(tr("&Float or dock"), this, [this] { dock_->setFloating(!dock_->isFloating()); });
    menu_->addSeparator();
    addSize(tr("&Wider"), Qt::Horizontal, growth);
    addSize(tr("&Narrower"), Qt::Horizontal, -growth);
    addSize(tr("&Taller"), Qt::Vertical, growth);
    addSize(tr("&Shorter"), Qt::Vertical, -growth);
}

void DockTitle::contextMenuEvent(QContextMenuEvent* event)
{
    menu_->popup(event->globalPos());
}

QSize DockTitle::sizeHint() const
{
    return {grown(80, *this), grown(28, *this)};
}

void DockTitle::showTheme()
{
    for (QToolButton* button : findChildren<QToolButton*>()) {
        QPalette quiet = button->palette();
        quiet.setColor(QPalette::ButtonText, theme().dim);
        button->setPalette(quiet);
    }
}

void DockTitle::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) showTheme();
    QWidget::changeEvent(event);
}

void DockTitle::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    QFont font = painter.font();
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    painter.setPen(theme().text);
    painter.drawText(rect().adjusted(12, 0, -grown(56, *this), 0), Qt::AlignLeft | Qt::AlignVCenter,
                     dock_->windowTitle());
    QColor line = theme().text;
    line.setAlphaF(0.1F);
    painter.fillRect(QRect(0, height() - 1, width(), 1), line);
}

}  // namespace vitrine::ui

#include "moc_dock_title.cpp"
