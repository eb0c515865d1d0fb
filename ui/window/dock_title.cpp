#include "ui/window/dock_title.h"

#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

namespace vitrine::ui {

DockTitle::DockTitle(QDockWidget* dock) : QWidget(dock), dock_(dock)
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
    connect(button(QStringLiteral("▫"), tr("Float or dock %1").arg(name)), &QToolButton::clicked, dock,
            [dock] { dock->setFloating(!dock->isFloating()); });
    connect(button(QStringLiteral("✕"), tr("Close %1").arg(name)), &QToolButton::clicked, dock, &QDockWidget::close);
    showTheme();
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
