#include "ui/explore/explore_dock.h"

#include "ui/explore/explore_parameters.h"
#include "ui/explore/morph_pad.h"
#include "ui/explore/pad_control.h"
#include "ui/explore/variation_grid.h"
#include "ui/explore/variations.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/model/workbench.h"
#include "ui/parameters/value_slider.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <cmath>
#include <functional>

namespace vitrine::ui {
namespace {

constexpr int mostNumber = 1'000'000;
// Ids of chooser entries that are no presets. The id of a preset is its path.
constexpr QLatin1String onShowId("on show");
constexpr QLatin1String keepId("keep");
constexpr QLatin1String keptId("kept");

QLabel* heading(const QString& words, QWidget* parent)
{
    auto* label = new QLabel(words, parent);
    QFont font = label->font();
    font.setWeight(QFont::DemiBold);
    label->setFont(font);
    return label;
}

/// Combo box that is filled each time before it opens.
class Chooser final : public QComboBox {
public:
    Chooser(std::function<void()> fill, QWidget* parent) : QComboBox(parent), fill_(std::move(fill)) {}
    void showPopup() override
    {
        fill_();
        QComboBox::showPopup();
    }

private:
    std::function<void()> fill_;
};

}  // namespace

ExploreDock::ExploreDock(Workbench& workbench, PresetController& presetController, const ParameterPanel& panel,
                         QWidget* parent)
    : QWidget(parent), workbench_(workbench), corners_(new PadCorners(workbench, presetController, this)),
      pad_(new MorphPad(*corners_, this)), variations_(new Variations(workbench, panel, this)),
      grid_(new VariationGrid(*variations_, this)), number_(new QSpinBox(this)),
      strength_(new ValueSlider(exploreParameters().rows()[exploreParameters().strength.row], this)),
      percent_(new QLabel(this)), state_(new QLabel(this)), anew_(new QPushButton(tr("&Draw anew"), this)),
      goOn_(new QPushButton(tr("&More like this"), this))
{
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(10, 8, 10, 8);
    all->setSpacing(6);
    addPad(*all);
    all->addSpacing(8);
    addVariations(*all);
    all->addStretch(1);
    control_ = new PadControl(workbench, *corners_, *pad_, this);
    refreshVariations();
}

QComboBox* ExploreDock::makeChooser(std::size_t corner)
{
    const QStringList names{tr("Upper left corner"), tr("Upper right corner"), tr("Lower left corner"),
                            tr("Lower right corner")};
    auto* made = new Chooser([this, corner] { fillChooser(corner); }, this);
    made->setAccessibleName(names[static_cast<int>(corner)]);
    made->setToolTip(
        tr("%1: the current settings, a preset, or settings kept there.").arg(names[static_cast<int>(corner)]));
    made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    made->setMinimumContentsLength(8);
    connect(made, &QComboBox::activated, this, [this, corner](int entry) { choose(corner, entry); });
    choosers_.at(corner) = made;
    return made;
}

void ExploreDock::addPad(QVBoxLayout& all)
{
    all.addWidget(heading(tr("Between four settings"), this));
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    grid->addWidget(makeChooser(0), 0, 0);
    grid->addWidget(makeChooser(1), 0, 1);
    pad_->setMinimumHeight(170);
    grid->addWidget(pad_, 1, 0, 1, 2);
    grid->addWidget(makeChooser(2), 2, 0);
    grid->addWidget(makeChooser(3), 2, 1);
    all.addLayout(grid);
    // Tab order: from corner to corner, then the pad between them.
    for (std::size_t i = 1; i < PadCorners::count; ++i) setTabOrder(choosers_.at(i - 1), choosers_.at(i));
    setTabOrder(choosers_.back(), pad_);
    connect(corners_, &PadCorners::changed, this, [this] {
        for (std::size_t i = 0; i < PadCorners::count; ++i) fillChooser(i);
    });
}

void ExploreDock::fillChooser(std::size_t corner)
{
    QComboBox& chooser = *choosers_.at(corner);
    const PadCorners::Corner& there = corners_->at(corner);
    const QSignalBlocker quiet(chooser);
    chooser.clear();
    chooser.addItem(tr("Current settings"), QString(onShowId));
    if (there.source == PadCorners::Source::kept) chooser.addItem(tr("Kept settings"), QString(keptId));
    chooser.addItem(tr("Keep the current settings here"), QString(keepId));
    chooser.insertSeparator(chooser.count());
    for (const auto& [name, id] : corners_->presets()) chooser.addItem(name, id);
    QString id = there.id;
    if (there.source != PadCorners::Source::preset)
        id = QString(there.source == PadCorners::Source::kept ? keptId : onShowId);
    if (chooser.findData(id) < 0) chooser.addItem(there.name, id);  // The preset was deleted since.
    chooser.setCurrentIndex(chooser.findData(id));
}

void ExploreDock::choose(std::size_t corner, int entry)
{
    const QString id = choosers_.at(corner)->itemData(entry).toString();
    if (id == onShowId)
        corners_->takeOnShow(corner);
    else if (id == keepId)
        corners_->keep(corner);
    else if (id != keptId)
        corners_->takePreset(corner, id);
}

void ExploreDock::addVariations(QVBoxLayout& all)
{
    all.addWidget(heading(tr("Nine variations"), this));
    auto* line = new QHBoxLayout;
    line->setSpacing(6);
    auto* number = new QLabel(tr("&Seed"), this);
    number->setBuddy(number_);
    number_->setRange(1, mostNumber);
    number_->setAccessibleName(tr("Seed"));
    number_->setToolTip(tr("Seed of the variations: another number gives nine others, the same number the same ones."));
    number_->setKeyboardTracking(false);
    auto* strength = new QLabel(tr("S&trength"), this);
    strength->setBuddy(strength_);
    strength_->setAccessibleName(tr("Strength"));
    strength_->setToolTip(translatedText(exploreParameters().rows()[exploreParameters().strength.row].help));
    strength_->showValue(variations_->strength());
    percent_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
    line->addWidget(number);
    line->addWidget(number_);
    line->addSpacing(6);
    line->addWidget(strength);
    line->addWidget(strength_, 1);
    line->addWidget(percent_);
    all.addLayout(line);
    all.addWidget(grid_);
    state_->setWordWrap(true);
    state_->setTextFormat(Qt::PlainText);
    state_->setMinimumHeight(2 * fontMetrics().height());
    state_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    all.addWidget(state_);
    auto* buttons = new QHBoxLayout;
    anew_->setToolTip(tr("Draws nine variations of the current settings."));
    goOn_->setToolTip(tr("Uses the selected variation, and draws nine new ones around it."));
    buttons->addWidget(anew_);
    buttons->addWidget(goOn_);
    buttons->addStretch(1);
    all.addLayout(buttons);

    connect(number_, &QSpinBox::valueChanged, this, [this](int n) {
        variations_->setNumber(n);
        variations_->drawAnew();
    });
    connect(strength_, &ValueSlider::edited, this, [this](double share) {
        variations_->setStrength(share);
        variations_->drawAnew();
    });
    anew_->setAccessibleName(tr("Draw new variations"));
    goOn_->setAccessibleName(tr("More variations like this one"));
    connect(anew_, &QPushButton::clicked, variations_, &Variations::drawAnew);
    connect(goOn_, &QPushButton::clicked, this, [this] { variations_->goOnFrom(grid_->current()); });
    connect(grid_, &VariationGrid::picked, variations_, &Variations::pick);
    connect(grid_, &VariationGrid::currentCellChanged, this, &ExploreDock::refreshVariations);
    connect(variations_, &Variations::changed, this, &ExploreDock::refreshVariations);
}

void ExploreDock::refreshVariations()
{
    {
        const QSignalBlocker quiet(number_);
        number_->setValue(variations_->number());
    }
    percent_->setText(tr("%1 %").arg(static_cast<int>(std::lround(100 * variations_->strength()))));
    grid_->refresh();
    state_->setText(stateOfVariations());
    goOn_->setEnabled(variations_->made());
}

QString ExploreDock::stateOfVariations() const
{
    if (!variations_->failure().isEmpty()) return variations_->failure();
    if (!variations_->made()) return {};
    if (variations_->stale())
        return tr("These variations are of earlier settings or locks. “Draw anew” uses the current ones.");
    if (variations_->finished() < Variations::count)
        return tr("Variation %1 of %2 is being drawn.").arg(variations_->finished() + 1).arg(Variations::count);
    if (const std::optional<int> shown = variations_->onShow()) return tr("Variation %1 is shown.").arg(*shown + 1);
    return tr("Click a variation to use it. Parameters and groups that are locked in their menus keep their values.");
}

void ExploreDock::follow()
{
    if (exhibit_ == workbench_.shown()) return;
    exhibit_.reset();
    variations_->clear();
    if (isVisible()) beginAnew();
}

void ExploreDock::beginAnew()
{
    exhibit_ = workbench_.shown();
    corners_->begin();
    variations_->drawAnew();
}

void ExploreDock::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!exhibit_) beginAnew();
    variations_->setSeen(true);
}

void ExploreDock::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    variations_->setSeen(false);
}

}  // namespace vitrine::ui

#include "moc_explore_dock.cpp"
