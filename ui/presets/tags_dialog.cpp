#include "ui/presets/tags_dialog.h"

#include "exhibits/framework/files/preset_tags.h"
#include "ui/kit/message_of.h"
#include "ui/kit/theme.h"
#include "ui/presets/tag_chips.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace vitrine::ui {
namespace {

constexpr int mostOffered = 24;

QString joined(const QStringList& tags)
{
    return tags.join(QStringLiteral(", "));
}

}  // namespace

TagsDialog::TagsDialog(const QString& preset, const QStringList& tags, const QStringList& inUse, QWidget* parent)
    : InlineDialog(tr("Tags of %1").arg(preset), tr("Save"), parent), text_(new QLineEdit(joined(tags), this)),
      why_(new QLabel(this)), chips_(new TagChips(this))
{
    text_->setAccessibleName(tr("Tags, separated by commas"));
    text_->setPlaceholderText(tr("night, water"));
    why_->setWordWrap(true);
    why_->setTextFormat(Qt::PlainText);
    QPalette colors = why_->palette();
    colors.setColor(QPalette::WindowText, theme().error);
    why_->setPalette(colors);
    why_->hide();
    chips_->setTags(inUse, mostOffered);
    body().addWidget(text_);
    body().addWidget(why_);
    body().addWidget(chips_);
    connect(text_, &QLineEdit::textChanged, this, &TagsDialog::check);
    connect(chips_, &TagChips::changed, this, &TagsDialog::pick);
    connect(this, &QDialog::accepted, this, [this] { emit given(tags_); });
    check();
    text_->setFocus();
}

void TagsDialog::check()
{
    QString why;
    try {
        const PresetTags read = tagsFromText(text_->text().toStdString());
        tags_.clear();
        for (const std::string& tag : read) tags_ << QString::fromStdString(tag);
        chips_->setPressed(tags_);
    } catch (const std::exception& thrown) {
        why = messageOf(thrown);
    }
    why_->setText(why);
    why_->setVisible(!why.isEmpty());
    acceptButton().setEnabled(why.isEmpty());
}

void TagsDialog::pick()
{
    QStringList tags = tags_;
    const QStringList pressed = chips_->pressed();
    for (const QString& tag : chips_->shown())
        if (!pressed.contains(tag)) tags.removeAll(tag);
    for (const QString& tag : pressed)
        if (!tags.contains(tag, Qt::CaseInsensitive)) tags << tag;
    text_->setText(joined(tags));
}

}  // namespace vitrine::ui

#include "moc_tags_dialog.cpp"
