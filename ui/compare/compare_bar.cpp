#include "ui/compare/compare_bar.h"

#include "ui/compare/compare_actions.h"
#include "ui/compare/compare_controller.h"
#include "ui/compare/compare_overlay.h"
#include "ui/compare/compare_parameters.h"
#include "ui/compare/morph_control.h"
#include "ui/kit/flat_style.h"
#include "ui/kit/language.h"
#include "ui/kit/menu_text.h"
#include "ui/kit/type_size.h"
#include "ui/model/settings_b.h"
#include "ui/parameters/value_slider.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr std::size_t mostParameters = 30;  ///< Most parameters in the menu of differences.
constexpr int widestName = 140;
constexpr std::array<const char*, 5> modeNames{
    QT_TRANSLATE_NOOP("vitrine::ui::CompareBar", "Wipe"), QT_TRANSLATE_NOOP("vitrine::ui::CompareBar", "Side by side"),
    QT_TRANSLATE_NOOP("vitrine::ui::CompareBar", "A/B flicker"), QT_TRANSLATE_NOOP("vitrine::ui::CompareBar", "FLIP"),
    QT_TRANSLATE_NOOP("vitrine::ui::CompareBar", "Difference")};

ValueSlider* sliderOver(std::uint16_t row, const QString& name, QWidget* parent)
{
    const ParameterInfo& info = compareParameters().rows()[row];
    auto* slider = new ValueSlider(info, parent);
    slider->setAccessibleName(name);
    slider->setToolTip(translatedText(info.help));
    return slider;
}

QWidget* withoutMargins(QWidget* parent)
{
    auto* part = new QWidget(parent);
    auto* line = new QHBoxLayout(part);
    line->setContentsMargins(4, 0, 4, 0);
    line->setSpacing(4);
    return part;
}

}  // namespace

CompareBar::CompareBar(CompareController& controller, QWidget* parent)
    : QWidget(parent), controller_(controller), gains_(withoutMargins(this)),
      gain_(sliderOver(compareParameters().gain.row, tr("Gain of the differences"), gains_)),
      times_(new QLabel(gains_)), rows_(new QMenu(this)), differ_(menuButton(rows_)), morphs_(withoutMargins(this)),
      morph_(sliderOver(compareParameters().towardsB.row, tr("From A to B"), morphs_)),
      source_(menuButton(&controller.actions().sources()))
{
    setAccessibleName(tr("Comparison"));
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(8, 3, 8, 3);
    line->setSpacing(2);
    CompareActions& actions = controller.actions();
    for (std::size_t i = 0; i < compareModes.size(); ++i) {
        buttons_.push_back(button(actions.mode(compareModes[i]), tr(modeNames[i])));
        line->addWidget(buttons_.back());
    }
    addGain();
    line->addWidget(gains_);
    line->addStretch(1);
    addMorph();
    line->addWidget(differ_);
    line->addWidget(morphs_);
    line->addWidget(source_);
    buttons_.push_back(button(actions.swap(), QStringLiteral("⇄")));
    line->addWidget(buttons_.back());
    line->addWidget(button(actions.letGo(), QStringLiteral("✕")));
    rows_->setAccessibleName(tr("Differing parameters"));
    connect(rows_, &QMenu::aboutToShow, this, &CompareBar::fillRows);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // The bar must not make a narrow window wider.
    hide();
}

QToolButton* CompareBar::button(QAction& action, const QString& words)
{
    auto* made = new QToolButton(this);
    made->setDefaultAction(&action);
    made->setAutoRaise(true);
    made->setFocusPolicy(Qt::TabFocus);
    made->setAccessibleName(action.text().remove(QLatin1Char('&')));
    // Keeps this text, which is shorter than the action's own.
    made->setText(words);
    connect(&action, &QAction::changed, made, [made, words] { made->setText(words); });
    return made;
}

QToolButton* CompareBar::menuButton(QMenu* menu)
{
    auto* made = new QToolButton(this);
    made->setPopupMode(QToolButton::InstantPopup);
    made->setMenu(menu);
    made->setAutoRaise(true);
    made->setFocusPolicy(Qt::TabFocus);
    made->setProperty(FlatStyle::hidesMenuArrow, true);
    return made;
}

void CompareBar::addGain()
{
    growWidth(*gain_, 80);
    gain_->showValue(controller_.overlay().gain());
    followType(*times_,
               [this] { times_->setMinimumWidth(times_->fontMetrics().horizontalAdvance(QStringLiteral("× 64"))); });
    gains_->layout()->addWidget(gain_);
    gains_->layout()->addWidget(times_);
    connect(gain_, &ValueSlider::edited, this, [this](double gain) {
        controller_.overlay().setGain(static_cast<int>(gain));
        refresh();
    });
}

void CompareBar::addMorph()
{
    growWidth(*morph_, 96);
    morphs_->layout()->addWidget(new QLabel(tr("A"), morphs_));
    morphs_->layout()->addWidget(morph_);
    morphs_->layout()->addWidget(new QLabel(tr("B"), morphs_));
    new MorphControl(controller_.history(), controller_.other(), *morph_, this);
}

QString CompareBar::differenceText() const
{
    return differ_->text();
}

void CompareBar::refresh()
{
    const bool held = controller_.other().isSet();
    setVisible(held && !banned_);
    if (!held) return;
    times_->setText(tr("× %1").arg(controller_.overlay().gain()));
    const QString name = controller_.other().name();
    source_->setText(menuText(fontMetrics().elidedText(tr("B: %1").arg(name), Qt::ElideRight, widestName)) +
                     QStringLiteral(" ▾"));
    source_->setToolTip(tr("B is: %1. Click for another B, or to copy all.").arg(name));
    source_->setAccessibleName(source_->toolTip());
    const std::size_t rows = controller_.differences().size();
    differ_->setText(rows == 0   ? tr("A and B are identical")
                     : rows == 1 ? tr("1 parameter differs")
                                 : tr("%1 parameters differ").arg(rows));
    differ_->setEnabled(rows > 0);
    differ_->setToolTip(tr("Shows the differing parameters, and copies them from B to A."));
    differ_->setAccessibleName(differ_->text());
    showWhatFits();
}

std::vector<QWidget*> CompareBar::whatMayGo() const
{
    // The Compare menu has the same commands. The button that ends the comparison always stays.
    std::vector<QWidget*> parts{differ_, morphs_, source_};
    parts.insert(parts.end(), buttons_.rbegin(), buttons_.rend());
    return parts;
}

bool CompareBar::event(QEvent* event)
{
    const bool done = QWidget::event(event);
    // Texts or their font became wider.
    if (event->type() == QEvent::LayoutRequest && isVisible() && layout()->minimumSize().width() > width()) {
        const std::vector<QWidget*> parts = whatMayGo();
        if (std::any_of(parts.begin(), parts.end(), [](const QWidget* part) { return !part->isHidden(); }))
            showWhatFits();
    }
    return done;
}

void CompareBar::showWhatFits()
{
    gains_->setVisible(isDifference(controller_.overlay().mode()));
    const std::vector<QWidget*> parts = whatMayGo();
    for (QWidget* part : parts) part->show();
    for (QWidget* part : parts) {
        layout()->activate();
        if (layout()->minimumSize().width() <= width()) return;
        part->hide();
    }
}

void CompareBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    showWhatFits();
}

void CompareBar::fillRows()
{
    rows_->clear();
    const std::vector<ParameterDifference> differences = controller_.differences();
    for (std::size_t i = 0; i < std::min(differences.size(), mostParameters); ++i) {
        const ParameterDifference& row = differences[i];
        rows_->addAction(menuText(row.text), this, [this, row] { controller_.other().take(row.exhibit, row.name); });
    }
    if (differences.size() > mostParameters)
        rows_->addAction(tr("… and %1 more").arg(differences.size() - mostParameters))->setEnabled(false);
}

void CompareBar::setBanned(bool banned)
{
    banned_ = banned;
    refresh();
}

}  // namespace vitrine::ui

#include "moc_compare_bar.cpp"
