#include "ui/print/print_results.h"

#include "ui/print/eyes_preview.h"
#include "ui/print/print_numbers.h"
#include "ui/print/strip_preview.h"

#include <QVBoxLayout>

namespace vitrine::ui {

PrintResults::PrintResults(QWidget* parent)
    : QWidget(parent), strips_(new StripPreview(this)), eyes_(new EyesPreview(this)),
      numbers_(new PrintNumbersView(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 16, 8);
    layout->setSpacing(8);
    layout->addWidget(strips_, 4);
    layout->addWidget(eyes_, 5);
    layout->addWidget(numbers_);
}

void PrintResults::showPreview(const std::shared_ptr<const printing::PrintPreview>& preview, double distance,
                               bool chart)
{
    strips_->setPreview(preview);
    eyes_->setPreview(chart ? nullptr : preview, distance);
}

void PrintResults::showChart(bool chart)
{
    eyes_->setVisible(!chart);
}

}  // namespace vitrine::ui

#include "moc_print_results.cpp"
