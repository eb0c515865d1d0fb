#include "ui/window/serving_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace vitrine::ui {

ServingBar::ServingBar(const QString& socket, QWidget* parent) : QWidget(parent)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 8, 0);
    layout->setSpacing(6);
    auto* words = new QLabel(tr("Serving"), this);
    words->setTextFormat(Qt::PlainText);
    auto* button = new QPushButton(tr("Stop serving"), this);
    button->setFocusPolicy(Qt::TabFocus);
    const QString tip =
        tr("Your other programs can read and change the values of this window, at the socket %1.").arg(socket);
    words->setToolTip(tip);
    button->setToolTip(tip);
    button->setAccessibleDescription(tip);
    layout->addWidget(words);
    layout->addWidget(button);
    connect(button, &QPushButton::clicked, this, &ServingBar::stopAsked);
}

}  // namespace vitrine::ui

#include "moc_serving_bar.cpp"
