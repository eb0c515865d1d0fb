#include "ui/print/sheet_bar.h"

#include "exhibits/printing/optics.h"
#include "render/failure.h"
#include "ui/kit/language.h"
#include "ui/kit/name_dialog.h"
#include "ui/kit/type_size.h"
#include "ui/print/print_setup.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {
namespace {

/// Returns the displayed name of a sheet: "60 LPI, 3D, 30°" for "60-3d", which gives pitch, purpose and the viewing
/// angle of all views. The visitor's own sheets keep their names.
QString shownName(const printing::Sheet& sheet)
{
    const auto& known = printing::knownSheets();
    const bool ours = std::any_of(known.begin(), known.end(), [&](const auto& one) { return one.name == sheet.name; });
    const QString name = QString::fromStdString(sheet.name);
    if (!ours) return name;
    const QString use = name.endsWith(QLatin1String("-3d"))     ? SheetBar::tr("3D")
                        : name.endsWith(QLatin1String("-flip")) ? SheetBar::tr("flip")
                                                                : SheetBar::tr("measured");
    return SheetBar::tr("%1 LPI, %2, %3°")
        .arg(sheet.nominalLpi)
        .arg(use)
        .arg(std::round(printing::zoneByChiefRay(sheet) / printing::radiansPerDegree));
}

}  // namespace

SheetBar::SheetBar(PrintSetup& setup, QWidget* parent)
    : QWidget(parent), setup_(setup), list_(new QComboBox(this)), save_(new QToolButton(this)),
      remove_(new QToolButton(this))
{
    auto* name = new QLabel(tr("Sheet"), this);
    list_->setAccessibleName(tr("Lens sheet"));
    list_->setToolTip(
        tr("Sheets to start from, and your own. Makers differ: measure yours with a pitch chart and save it."));
    list_->setFocusPolicy(Qt::StrongFocus);
    list_->setMaxVisibleItems(24);
    save_->setText(tr("Save…"));
    save_->setToolTip(tr("Saves the numbers below as a sheet of your own."));
    remove_->setText(tr("Delete"));
    remove_->setToolTip(tr("Deletes this sheet of your own from the list; the numbers below stay."));
    for (QToolButton* button : {save_, remove_}) {
        button->setFocusPolicy(Qt::StrongFocus);
        growHeight(*button, 26);
    }
    save_->setAccessibleName(tr("Save sheet"));
    remove_->setAccessibleName(tr("Delete sheet"));
    auto* choice = new QHBoxLayout;
    choice->addWidget(name);
    choice->addWidget(list_, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(save_);
    buttons->addWidget(remove_);
    buttons->addStretch();
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(choice, 1);
    layout->addLayout(buttons);
    for (QBoxLayout* row : {choice, buttons, layout}) row->setSpacing(8);
    stackWhenLarge(*layout, *this);
    connectParts();
}

void SheetBar::connectParts()
{
    connect(list_, &QComboBox::activated, this, [this](int index) {
        if (index < static_cast<int>(count_)) choose(list_->itemData(index).toString());
    });
    connect(save_, &QToolButton::clicked, this, &SheetBar::askName);
    connect(remove_, &QToolButton::clicked, this, [this] { remove(current()); });
    connect(&setup_, &PrintSetup::changed, this, &SheetBar::showSheets);
}

void SheetBar::change(const std::function<void()>& work)
{
    try {
        work();
    } catch (const std::exception& failure) {
        emit failed(translatedText(failure.what()));
    }
    showSheets();
}

void SheetBar::choose(const QString& name)
{
    change([&] {
        const printing::Sheet sheet = sheets_.named(name.toStdString());
        ParameterValues values = printing::withSheet(setup_.values(), sheet);
        values.set(printing::printTable().sheet, sheet.name);
        setup_.change(tr("Choose sheet %1").arg(shownName(sheet)), values);
    });
}

void SheetBar::save(const QString& name)
{
    change([&] {
        printing::Sheet sheet = printing::sheetOf(setup_.values());
        sheet.name = name.toStdString();
        sheets_.save(sheet);
        ParameterValues values = setup_.values();
        values.set(printing::printTable().sheet, sheet.name);
        setup_.change(tr("Save sheet %1").arg(name), values);
    });
}

void SheetBar::remove(const QString& name)
{
    change([&] { sheets_.remove(name.toStdString()); });
}

void SheetBar::showSheets()
{
    std::string problem;
    const std::vector<printing::Sheet> sheets = sheets_.all(problem);
    std::string current;
    try {
        current = sheets_.nameOf(printing::sheetOf(setup_.values()), setup_.values()[printing::printTable().sheet]);
    } catch (const Failure&) {  // An impossible sheet has no name; the plan gives the reason.
    }
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const printing::Sheet& sheet : sheets) list_->addItem(shownName(sheet), QString::fromStdString(sheet.name));
    const auto at =
        std::find_if(sheets.begin(), sheets.end(), [&](const printing::Sheet& sheet) { return sheet.name == current; });
    if (at == sheets.end()) list_->addItem(tr("not in the list"));
    const auto index = static_cast<std::size_t>(at - sheets.begin());
    count_ = sheets.size();
    list_->setCurrentIndex(static_cast<int>(index));
    remove_->setEnabled(at != sheets.end() && index >= printing::knownSheets().size());
    if (!problem.empty()) emit failed(translatedText(problem));
}

QString SheetBar::current() const
{
    return list_->currentIndex() < static_cast<int>(count_) ? list_->currentData().toString() : QString();
}

void SheetBar::askName()
{
    auto* dialog = new NameDialog(tr("Name of the sheet"), remove_->isEnabled() ? current() : QString(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &NameDialog::named, this, &SheetBar::save);
    dialog->open();
}

}  // namespace vitrine::ui

#include "moc_sheet_bar.cpp"
