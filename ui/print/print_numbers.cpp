#include "ui/print/print_numbers.h"

#include "ui/kit/language.h"
#include "ui/kit/numbers.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {
namespace {

QString millimeters(double length)
{
    return numberLocale().toString(length, 'f', length < 10 ? 2 : 1) + QStringLiteral(" mm");
}

QString reach(const printing::DepthRange& range)
{
    const auto meters = [](double m) {
        return std::isinf(m) ? QString(QChar(0x221e)) : numberLocale().toString(m, 'f', m < 10 ? 1 : 0);
    };
    return meters(range.nearest) + QChar(0x2013) + meters(range.farthest) + QStringLiteral(" m");
}

QString bytesText(double bytes)
{
    const char* const units[] = {"B", "kB", "MB", "GB", "TB"};
    int unit = 0;
    while (bytes >= 1000 && unit < 4) {
        bytes /= 1000;
        ++unit;
    }
    return numberLocale().toString(bytes, 'f', unit == 0 || bytes >= 100 ? 0 : 1) + QLatin1Char(' ') +
           QLatin1String(units[unit]);
}

}  // namespace

CrosstalkBars::CrosstalkBars(QWidget* parent) : QWidget(parent)
{
    setMinimumSize(96, 48);
    setAccessibleName(tr("Cross-talk of every view"));
    setToolTip(tr("For every view, from left to right: how much of the light at its own angle comes from other "
                  "views.\nOptics, printed dots, and ink that spreads as far as is set."));
}

void CrosstalkBars::showShares(std::vector<double> ownShare)
{
    own_ = std::move(ownShare);
    update();
}

QString CrosstalkBars::accessibleText() const
{
    QStringList views;
    for (std::size_t i = 0; i < own_.size(); ++i)
        views << tr("view %1: %2 %").arg(i + 1).arg(std::lround(100 * (1 - own_[i])));
    return views.isEmpty() ? tr("There is no print yet.") : views.join(QStringLiteral(", "));
}

void CrosstalkBars::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const Theme& colors = theme();
    painter.fillRect(rect(), colors.base);
    if (own_.empty()) return;
    const auto count = static_cast<double>(own_.size());
    const double step = (width() - 8.0) / count;
    const double gap = step > 4 ? 1 : 0;
    for (std::size_t i = 0; i < own_.size(); ++i) {
        const double share = std::clamp(1 - own_[i], 0.0, 1.0);
        const double high = std::max(1.0, share * (height() - 8.0));
        painter.fillRect(
            QRectF(4 + static_cast<double>(i) * step, height() - 4 - high, std::max(step - gap, 0.5), high),
            share > 0.5 ? colors.error : colors.accent);
    }
    QColor line = colors.text;
    line.setAlphaF(0.25F);
    painter.fillRect(QRectF(4, height() / 2.0, width() - 8.0, 1),
                     line);  // Line at one half: a higher bar means more of other views than of its own.
}

PrintNumbersView::PrintNumbersView(QWidget* parent) : QWidget(parent)
{
    auto* top = new QHBoxLayout;
    top->setSpacing(16);
    auto* numbers = new QGridLayout;
    buildNumbers();
    followType(*this, [this, numbers] { layOutNumbers(*numbers); });
    stackWhenLarge(*top, *this);
    top->addLayout(numbers);
    top->addLayout(buildCrosstalk(), 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addLayout(top);
    layout->addLayout(buildMessages());
}

void PrintNumbersView::buildNumbers()
{
    perLens_ = addNumber(tr("Pixels per lens"),
                         tr("Number of printed dots under one lens: no more views than this are distinguishable."));
    lpi_ = addNumber(tr("LPI in the file"),
                     tr("Lenses per inch of the strips, with the resolution as the file stores it."));
    views_ = addNumber(tr("Views that show"), tr("Number of views that are distinguishable."));
    zone_ =
        addNumber(tr("Viewing zone"), tr("Viewing angle over which all views are seen once; beyond it, they repeat."));
    depth_ = addNumber(tr("Depth budget"),
                       tr("Depth that the print can show without doubled contours, before and behind it together."));
    scene_ = addNumber(tr("Scene"), tr("Nearest and farthest distance of the scene from the camera; in brackets, the "
                                       "range that the print can show."));
    size_ = addNumber(tr("Size"), tr("Size of the print's raster in pixels, bleed included."));
    bytes_ = addNumber(tr("File"), tr("Uncompressed."));
}

void PrintNumbersView::layOutNumbers(QGridLayout& grid)
{
    const bool isLarge = isLargeType(*this);
    const int columns = isLarge ? 1 : 2;
    for (const auto& [name, value] : numbers_) {
        grid.removeWidget(name);
        grid.removeWidget(value);
    }
    int place = 0;
    for (const auto& [name, value] : numbers_) {
        grid.addWidget(name, place / columns, place % columns * 2);
        grid.addWidget(value, place / columns, place % columns * 2 + 1);
        ++place;
    }
    grid.setHorizontalSpacing(16);
    grid.setVerticalSpacing(4);
    grid.setColumnMinimumWidth(1, 96);
    grid.setColumnMinimumWidth(3, isLarge ? 0 : 112);
}

QLayout* PrintNumbersView::buildCrosstalk()
{
    bars_ = new CrosstalkBars(this);
    crosstalk_ = new QLabel(tr("Cross-talk"), this);
    crosstalk_->setTextFormat(Qt::PlainText);
    crosstalk_->setWordWrap(true);
    auto* chart = new QVBoxLayout;
    chart->setSpacing(4);
    chart->addWidget(crosstalk_);
    chart->addWidget(bars_, 1);
    return chart;
}

QLayout* PrintNumbersView::buildMessages()
{
    messages_ = new QLabel(this);
    messages_->setTextFormat(Qt::PlainText);
    messages_->setWordWrap(true);
    messages_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    messages_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    followType(*messages_, [this] { messages_->setMinimumHeight(2 * messages_->fontMetrics().height() + 4); });
    messages_->setAccessibleName(tr("Warnings"));
    fit_ = new QPushButton(tr("Fit depth"), this);
    fit_->setAutoDefault(false);
    fit_->setAccessibleName(fit_->text());
    fit_->setToolTip(tr("Moves the cameras together until the print holds the whole scene."));
    fit_->hide();
    connect(fit_, &QPushButton::clicked, this, [this] { emit fitAsked(fitting_); });
    auto* below = new QHBoxLayout;
    below->setSpacing(8);
    below->addWidget(messages_, 1);
    below->addWidget(fit_, 0, Qt::AlignTop);
    return below;
}

QLabel* PrintNumbersView::addNumber(const QString& label, const QString& help)
{
    auto* name = new QLabel(label, this);
    auto* value = new QLabel(this);
    name->setTextFormat(Qt::PlainText);
    value->setTextFormat(Qt::PlainText);
    name->setEnabled(false);  // The label is dimmed, so that the number stands out.
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setAccessibleName(label);
    name->setToolTip(help);
    value->setToolTip(help);
    numbers_.emplace_back(name, value);
    return value;
}

QString PrintNumbersView::shown(const QString& label) const
{
    for (const auto& [name, value] : numbers_)
        if (name->text() == label) return value->text();
    return {};
}

QString PrintNumbersView::messages() const
{
    return messages_->text();
}

void PrintNumbersView::showNumbers(const printing::PrintPlan& plan, const std::optional<printing::SceneDepth>& depth)
{
    if (!plan.layout) {
        for (const auto& [name, value] : numbers_) value->setText(QStringLiteral("–"));
        crosstalk_->setText(tr("Cross-talk"));
        return;
    }
    const printing::PrintNumbers& numbers = plan.numbers;
    perLens_->setText(numberLocale().toString(numbers.pixelsPerLens, 'f', 4));
    lpi_->setText(numberLocale().toString(numbers.effectiveLpi, 'f', 4));
    views_->setText(tr("%1 of %2").arg(std::lround(numbers.effectiveViews)).arg(numbers.ownShare.size()));
    zone_->setText(numberLocale().toString(numbers.zoneDegrees, 'f', 1) + QChar(0xb0));
    depth_->setText(millimeters(numbers.depthBudget));
    scene_->setText(depth ? tr("%1 (%2)").arg(reach(depth->scene), reach(depth->held)) : QStringLiteral("–"));
    size_->setText(tr("%1 × %2 px").arg(plan.layout->width()).arg(plan.layout->height()));
    bytes_->setText(bytesText(plan.bytes));
    const auto [least, most] = std::minmax_element(numbers.ownShare.begin(), numbers.ownShare.end());
    crosstalk_->setText(
        tr("Cross-talk %1 to %2 %").arg(std::lround(100 * (1 - *most))).arg(std::lround(100 * (1 - *least))));
}

void PrintNumbersView::showPlan(const printing::PrintPlan& plan, const std::optional<printing::SceneDepth>& depth)
{
    showNumbers(plan, depth);
    bars_->showShares(plan.numbers.ownShare);
    const bool possible = plan.layout.has_value();
    QStringList lines;
    if (!possible) lines << translatedText(plan.refusal);
    for (const std::string& warning : plan.warnings) lines << translatedText(warning);
    if (possible && depth)
        for (const std::string& warning : depth->warnings) lines << translatedText(warning);
    fitting_ = depth ? depth->strengthThatHolds : 1;
    fit_->setVisible(possible && depth &&
                     (depth->scene.nearest < depth->held.nearest || depth->scene.farthest > depth->held.farthest));
    messages_->setText(lines.join(QLatin1Char('\n')));
    QPalette palette = this->palette();
    palette.setColor(QPalette::WindowText, possible ? theme().accent : theme().error);
    messages_->setPalette(palette);
}

}  // namespace vitrine::ui

#include "moc_print_numbers.cpp"
