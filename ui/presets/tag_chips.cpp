#include "ui/presets/tag_chips.h"

#include "ui/kit/flow_layout.h"
#include "ui/kit/menu_text.h"
#include "ui/kit/type_size.h"

#include <QMap>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr const char* tagOf = "tag";  // Property of a chip that holds its tag.

}  // namespace

TagChips::TagChips(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Tags"));
    new FlowLayout(this);
    // A font set on a widget does not follow the application's font size, so it is set again.
    followType(*this, [this] {
        for (QToolButton* chip : findChildren<QToolButton*>()) chip->setFont(chipFont());
        keepRoom();
    });
}

void TagChips::keepRoom()
{
    // Outer layouts ask for the minimum size only, and not for a height that depends on the width.
    setMinimumHeight(layout()->heightForWidth(width()));
}

void TagChips::resizeEvent(QResizeEvent*)
{
    keepRoom();
}

QFont TagChips::chipFont() const
{
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.9);
    return small;
}

void TagChips::addChip(const QString& tag, int uses, bool pressed)
{
    auto* chip = new QToolButton(this);
    chip->setText(menuText(tag));
    chip->setProperty(tagOf, tag);
    chip->setCheckable(true);
    chip->setChecked(pressed);
    chip->setFocusPolicy(Qt::StrongFocus);
    chip->setAccessibleName(tr("Tag %1").arg(tag));
    chip->setToolTip(tr("Presets with this tag: %1").arg(uses));
    chip->setFont(chipFont());
    connect(chip, &QToolButton::toggled, this, &TagChips::changed);
    layout()->addWidget(chip);
    chip->show();  // Until it is shown, a layout gives it no room.
}

void TagChips::setTags(const QStringList& uses, int most)
{
    const QStringList before = pressed();
    while (QLayoutItem* item = layout()->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();  // The chip may be the sender of the present signal.
        delete item;
    }
    QMap<QString, int> counts;  // Sorted by tag.
    for (const QString& tag : uses) ++counts[tag];
    QStringList sorted = counts.keys();
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const QString& a, const QString& b) { return counts[a] > counts[b]; });
    for (int i = 0; i < sorted.size(); ++i)
        if (i < most || before.contains(sorted[i])) addChip(sorted[i], counts[sorted[i]], before.contains(sorted[i]));
    setVisible(layout()->count() > 0);
    keepRoom();
}

QStringList TagChips::shown() const
{
    QStringList tags;
    for (int i = 0; i < layout()->count(); ++i) tags << layout()->itemAt(i)->widget()->property(tagOf).toString();
    return tags;
}

QStringList TagChips::pressed() const
{
    QStringList tags;
    for (int i = 0; i < layout()->count(); ++i)
        if (const auto* chip = static_cast<QToolButton*>(layout()->itemAt(i)->widget()); chip->isChecked())
            tags << chip->property(tagOf).toString();
    return tags;
}

void TagChips::setPressed(const QStringList& tags)
{
    for (int i = 0; i < layout()->count(); ++i) {
        auto* chip = static_cast<QToolButton*>(layout()->itemAt(i)->widget());
        const QSignalBlocker quiet(chip);
        chip->setChecked(tags.contains(chip->property(tagOf).toString(), Qt::CaseInsensitive));
    }
}

}  // namespace vitrine::ui

#include "moc_tag_chips.cpp"
