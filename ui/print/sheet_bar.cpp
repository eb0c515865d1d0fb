#include "ui/print/sheet_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace vitrine::ui {

SheetBar::SheetBar(QWidget* parent) : QWidget(parent), list_(new QComboBox(this)), save_(new QToolButton(this)), remove_(new QToolButton(this))
{
    auto* name = new QLabel(tr("Sheet"), this);
    list_->setAccessibleName(tr("Lens sheet"));
    list_->setToolTip(tr("Sheets to start from, and your own. Makers differ: measure yours with a pitch chart and save it."));
    list_->setFocusPolicy(Qt::StrongFocus);
    list_->setMaxVisibleItems(24);
    save_->setText(tr("Save…"));
    save_->setToolTip(tr("Saves the numbers below as a sheet of your own."));
    remove_->setText(tr("Delete"));
    remove_->setToolTip(tr("Deletes this sheet of your own from the list; the numbers below stay."));
    for (QToolButton* button : {save_, remove_}) {
        button->setFocusPolicy(Qt::StrongFocus);
        button->setFixedHeight(26);
    }
    save_->setAccessibleName(tr("Save sheet"));
    remove_->setAccessibleName(tr("Delete sheet"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(name);
    layout->addWidget(list_, 1);
    layout->addWidget(save_);
    layout->addWidget(remove_);
    connect(list_, &QComboBox::activated, this, [this](int index) {
        if (index < static_cast<int>(sheets_.size())) emit chosen(list_->itemText(index));
    });
    connect(save_, &QToolButton::clicked, this, &SheetBar::askName);
    connect(remove_, &QToolButton::clicked, this, [this] { emit removeAsked(list_->currentText()); });
}

void SheetBar::showSheets(const std::vector<printing::Sheet>& sheets, const std::string& current)
{
    sheets_ = sheets;
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const printing::Sheet& sheet : sheets_) list_->addItem(QString::fromStdString(sheet.name));
    const auto at = std::find_if(sheets_.begin(), sheets_.end(), [&](const printing::Sheet& sheet) { return sheet.name == current; });
    if (at == sheets_.end()) list_->addItem(tr("not in the list"));
    list_->setCurrentIndex(static_cast<int>(at - sheets_.begin()));
    remove_->setEnabled(at != sheets_.end() && at - sheets_.begin() >= static_cast<std::ptrdiff_t>(printing::knownSheets().size()));
}

QString SheetBar::current() const
{
    return list_->currentIndex() < static_cast<int>(sheets_.size()) ? list_->currentText() : QString();
}

void SheetBar::askName()
{
    auto* dialog = new QInputDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save sheet"));
    dialog->setLabelText(tr("Name of the sheet"));
    dialog->setTextValue(remove_->isEnabled() ? current() : QString());
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& name) {
        if (!name.trimmed().isEmpty()) emit saveAsked(name.trimmed());
    });
    dialog->open();
}

}  // namespace vitrine::ui

#include "moc_sheet_bar.cpp"
