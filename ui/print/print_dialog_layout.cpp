// What is where in the print dialog.
#include "ui/print/print_dialog.h"

#include "ui/parameters/parameter_panel.h"
#include "ui/print/eyes_preview.h"
#include "ui/print/print_numbers.h"
#include "ui/print/sheet_bar.h"
#include "ui/print/source_bar.h"
#include "ui/print/strip_preview.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace vitrine::ui {
namespace {

constexpr int panelWidth = 376;

}  // namespace

void PrintDialog::build()
{
    messages_ = new MessageStrip(this);

    tabs_ = new QTabBar(this);
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->addTab(tr("Print"));
    tabs_->addTab(tr("Calibration chart"));
    tabs_->setTabToolTip(0, tr("Views, interlaced."));
    tabs_->setTabToolTip(1, tr("A sheet to print and lay the lenses on: pitch, phase, number of views, rotation."));
    tabs_->setAccessibleName(tr("What to print"));
    source_ = new SourceBar(live_ != nullptr, this);
    sheets_ = new SheetBar(this);
    panel_ = new ParameterPanel(settings_, this);

    auto* bars = new QVBoxLayout;
    bars->setContentsMargins(8, 8, 8, 0);
    bars->setSpacing(8);
    bars->addWidget(source_);
    bars->addWidget(sheets_);
    auto* left = new QVBoxLayout;
    left->setContentsMargins(0, 0, 0, 0);
    left->setSpacing(0);
    left->addWidget(tabs_);
    left->addLayout(bars);
    left->addWidget(panel_, 1);
    auto* leftSide = new QWidget(this);
    leftSide->setLayout(left);
    leftSide->setFixedWidth(panelWidth);

    strips_ = new StripPreview(this);
    eyes_ = new EyesPreview(this);
    numbers_ = new PrintNumbersView(this);

    path_ = new QLineEdit(this);
    path_->setAccessibleName(tr("File"));
    path_->setToolTip(tr("The print: .tif, or .png. Its settings are written inside and beside it."));
    browse_ = new QToolButton(this);
    browse_->setText(QStringLiteral("…"));
    browse_->setAccessibleName(tr("Choose a file"));
    browse_->setToolTip(tr("Choose a file"));
    browse_->setFocusPolicy(Qt::StrongFocus);
    progress_ = new QProgressBar(this);
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(4);
    progress_->setAccessibleName(tr("Progress"));
    status_ = new QLabel(this);
    status_->setTextFormat(Qt::PlainText);
    load_ = new QPushButton(tr("Load settings…"), this);
    save_ = new QPushButton(tr("Save settings…"), this);
    stop_ = new QPushButton(tr("Close"), this);
    go_ = new QPushButton(tr("Export"), this);
    load_->setToolTip(tr("From a print that Vitrine made, or a .json. Dropping one here works too."));
    save_->setToolTip(tr("Everything that is set here, as JSON."));
    for (QPushButton* button : {load_, save_, stop_, go_}) {
        button->setAutoDefault(false);  // Enter in a number field ends the number, nothing else.
        button->setAccessibleName(button->text());
        button->setMinimumWidth(button->sizeHint().width() + 16);
    }
    go_->setMinimumWidth(112);

    auto* file = new QHBoxLayout;
    file->setSpacing(8);
    auto* fileLabel = new QLabel(tr("File"), this);
    fileLabel->setBuddy(path_);
    file->addWidget(fileLabel);
    file->addWidget(path_, 1);
    file->addWidget(browse_);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(load_);
    buttons->addWidget(save_);
    buttons->addWidget(status_, 1);
    buttons->addWidget(stop_);
    buttons->addWidget(go_);

    auto* right = new QVBoxLayout;
    right->setContentsMargins(8, 8, 16, 16);
    right->setSpacing(8);
    right->addWidget(strips_, 4);
    right->addWidget(eyes_, 5);
    right->addWidget(numbers_);
    right->addLayout(file);
    right->addWidget(progress_);
    right->addLayout(buttons);

    auto* sides = new QHBoxLayout;
    sides->setContentsMargins(0, 0, 0, 0);
    sides->setSpacing(8);
    sides->addWidget(leftSide);
    sides->addLayout(right, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(messages_);
    layout->addLayout(sides, 1);
    resize(1200, 680);  // With a title bar it fits 1280 x 720.
}

}  // namespace vitrine::ui
