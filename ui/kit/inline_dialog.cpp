#include "ui/kit/inline_dialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {

InlineDialog::InlineDialog(const QString& heading, const QString& accept, QWidget* parent)
    : QDialog(parent), heading_(new QLabel(heading, this)), body_(new QVBoxLayout),
      accept_(new QPushButton(accept, this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(QStringLiteral("Vitrine"));  // Short enough for any title bar; the heading is inside the dialog.
    setAccessibleName(heading);
    QFont bold = heading_->font();
    bold.setWeight(QFont::DemiBold);
    heading_->setFont(bold);
    heading_->setTextFormat(Qt::PlainText);
    heading_->setWordWrap(true);
    auto* cancel = new QPushButton(tr("Cancel"), this);
    cancel->setAutoDefault(false);
    accept_->setDefault(true);
    connect(accept_, &QPushButton::clicked, this, &QDialog::accept);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(accept_);
    body_->setSpacing(8);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(12);
    layout->addWidget(heading_);
    layout->addLayout(body_);
    layout->addLayout(buttons);
}

void InlineDialog::openOver(const QWidget& anchor)
{
    const QRect over(anchor.mapToGlobal(QPoint(0, 0)), anchor.size());
    const QRect room = anchor.screen()->availableGeometry();
    resize(std::max(over.width(), minimumSizeHint().width()), 10);
    const int wide = width();
    const int high = layout()->hasHeightForWidth() ? layout()->heightForWidth(wide) : sizeHint().height();
    // A dialog wider than the panel extends toward the nearer edge of the window, because the picture is in the middle.
    const QWidget* window = anchor.window();
    const bool left = over.center().x() < window->mapToGlobal(window->rect().center()).x();
    const int x = left ? over.left() : over.right() + 1 - wide;
    const int below = over.bottom() + 1;
    const int y = below + high <= room.bottom() ? below : over.top() - high;
    setGeometry(std::clamp(x, room.left(), std::max(room.left(), room.right() - wide)), std::max(y, room.top()), wide,
                high);
    show();
}

}  // namespace vitrine::ui

#include "moc_inline_dialog.cpp"
