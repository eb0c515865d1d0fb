#include "ui/print/print_side.h"

#include "ui/kit/type_size.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/print/print_setup.h"
#include "ui/print/sheet_bar.h"
#include "ui/print/source_bar.h"

#include <QTabBar>
#include <QVBoxLayout>

namespace vitrine::ui {
namespace {

constexpr int panelWidth = 376;
constexpr int mostOfScreen = 38;  // Percent.

}  // namespace

PrintSide::PrintSide(bool canShow, PrintSetup& setup, QWidget* parent)
    : QWidget(parent), setup_(setup), tabs_(makeTabs()), source_(new SourceBar(canShow, setup, this)),
      sheets_(new SheetBar(setup, this)), panel_(new ParameterPanel(setup.history(), this))
{
    panel_->showExhibit(0, QStringLiteral("print"));
    auto* bars = new QVBoxLayout;
    bars->setContentsMargins(8, 8, 8, 0);
    bars->setSpacing(8);
    bars->addWidget(source_);
    bars->addWidget(sheets_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(tabs_);
    layout->addLayout(bars);
    layout->addWidget(panel_, 1);
    growWidth(*this, panelWidth, mostOfScreen);
    connect(tabs_, &QTabBar::currentChanged, this, [this](int tab) { emit chartChosen(tab == 1); });
}

QTabBar* PrintSide::makeTabs()
{
    auto* tabs = new QTabBar(this);
    tabs->setDrawBase(false);
    tabs->setExpanding(false);
    tabs->addTab(tr("Print"));
    tabs->addTab(tr("Calibration chart"));
    tabs->setTabToolTip(0, tr("Views, interlaced."));
    tabs->setTabToolTip(1, tr("A sheet to print and lay the lenses on: pitch, phase, number of views, rotation."));
    tabs->setAccessibleName(tr("What to print"));
    return tabs;
}

void PrintSide::showChart(bool chart)
{
    tabs_->setCurrentIndex(chart ? 1 : 0);
    source_->setVisible(!chart);
    panel_->setWanted([this, chart](const ParameterInfo& parameter) {
        return printing::parameterActs(parameter, setup_.values(), chart);
    });
}

}  // namespace vitrine::ui

#include "moc_print_side.cpp"
