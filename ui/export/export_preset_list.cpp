#include "ui/export/export_preset_list.h"

#include "ui/export/export_presets.h"
#include "ui/kit/flow_layout.h"
#include "ui/kit/inline_dialog.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/name_dialog.h"

#include <QAction>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace vitrine::ui {

ExportPresetList::ExportPresetList(QWidget* parent)
    : QWidget(parent), heading_(new QLabel(tr("Presets"), this)), list_(new QListWidget(this)),
      save_(new QPushButton(tr("Save…"), this)), delete_(new QPushButton(tr("Delete"), this)),
      reset_(new QPushButton(tr("Reset"), this))
{
    heading_->setBuddy(list_);
    list_->setAccessibleName(tr("Presets of the settings"));
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setFrameShape(QFrame::NoFrame);
    save_->setToolTip(tr("Saves all settings of this kind of export under a name."));
    delete_->setToolTip(tr("Deletes the selected preset."));
    reset_->setToolTip(tr("Sets all settings of this kind of export to their initial values. Can be undone."));
    auto* buttons = new FlowLayout;
    buttons->setSpacing(4);
    for (QPushButton* button : {save_, delete_, reset_}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 0, 8);
    layout->setSpacing(4);
    layout->addWidget(heading_);
    layout->addWidget(list_, 1);
    layout->addLayout(buttons);
    auto* deletes = new QAction(tr("Delete"), list_);
    deletes->setShortcut(QKeySequence::Delete);
    deletes->setShortcutContext(Qt::WidgetShortcut);
    list_->addAction(deletes);
    connect(deletes, &QAction::triggered, this, &ExportPresetList::askDelete);
    connect(list_, &QListWidget::itemClicked, this, &ExportPresetList::choose);
    connect(list_, &QListWidget::itemActivated, this, &ExportPresetList::choose);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) { delete_->setEnabled(row >= 0); });
    connect(save_, &QPushButton::clicked, this, &ExportPresetList::askName);
    connect(delete_, &QPushButton::clicked, this, &ExportPresetList::askDelete);
    connect(reset_, &QPushButton::clicked, this, &ExportPresetList::reset);
    clear();
}

void ExportPresetList::show(ExportSettings settings)
{
    const bool isSame = settings_ && settings_->job == settings.job;
    settings_ = std::move(settings);
    setEnabled(true);
    refresh(isSame ? selected() : QString());
}

void ExportPresetList::clear()
{
    settings_.reset();
    setEnabled(false);
    refresh({});
}

QStringList ExportPresetList::names() const
{
    QStringList names;
    for (int i = 0; i < list_->count(); ++i) names << list_->item(i)->text();
    return names;
}

void ExportPresetList::refresh(const QString& selected)
{
    list_->clear();
    if (settings_)
        for (const QString& name : ExportPresets(*settings_->job).names()) {
            auto* item = new QListWidgetItem(name, list_);
            item->setToolTip(name);
            if (name == selected) list_->setCurrentItem(item);
        }
    list_->setVisible(list_->count() > 0);
    delete_->setEnabled(list_->currentRow() >= 0);
}

bool ExportPresetList::attempt(const std::function<void()>& work)
{
    try {
        work();
        emit failed(QString());
        return true;
    } catch (const std::exception& failure) {
        emit failed(messageOf(failure));
        return false;
    }
}

QString ExportPresetList::selected() const
{
    const QListWidgetItem* item = list_->currentItem();
    return item ? item->text() : QString();
}

void ExportPresetList::choose()
{
    const QString name = selected();
    if (!settings_ || name.isEmpty()) return;
    attempt([&] {
        const jobs::JobDocument document = ExportPresets(*settings_->job).read(name);
        for (const std::string& note : document.notes) emit noted(translatedText(note));
        // Enter and a click may both report one choice.
        if (!(document.values == settings_->values())) settings_->change(tr("Preset %1").arg(name), document.values);
    });
}

void ExportPresetList::ask(const QString& question, const QString& button, std::function<void()> work)
{
    auto* dialog = new InlineDialog(question, button, this);
    connect(dialog, &QDialog::accepted, this, std::move(work));
    dialog->openOver(*this);
}

void ExportPresetList::askName()
{
    if (!settings_) return;
    auto* dialog = new NameDialog(tr("Save the settings as a preset"), selected(), this);
    connect(dialog, &NameDialog::named, this, [this](const QString& name) {
        if (names().contains(name) && name != selected())
            ask(tr("Replace the preset “%1”?").arg(name), tr("Replace"), [this, name] { save(name); });
        else
            save(name);
    });
    dialog->openOver(*this);
}

void ExportPresetList::save(const QString& name)
{
    if (!settings_) return;
    if (attempt([&] { ExportPresets(*settings_->job).save(name, settings_->values()); })) refresh(name);
}

void ExportPresetList::askDelete()
{
    const QString name = selected();
    if (!settings_ || name.isEmpty()) return;
    ask(tr("Delete the preset “%1”?").arg(name), tr("Delete"), [this, name] {
        if (settings_ && attempt([&] { ExportPresets(*settings_->job).remove(name); })) refresh({});
    });
}

void ExportPresetList::reset()
{
    if (settings_) settings_->change(tr("Reset settings"), settings_->job->parameters().initial());
}

}  // namespace vitrine::ui

#include "moc_export_preset_list.cpp"
