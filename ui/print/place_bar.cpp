#include "ui/print/place_bar.h"

#include "ui/kit/type_size.h"
#include "ui/print/print_setup.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>
#include <exception>
#include <string>

namespace vitrine::ui {

PlaceBar::PlaceBar(PrintSetup& setup, QWidget* parent)
    : QWidget(parent), setup_(setup), view_(new QSpinBox(this)), reset_(new QToolButton(this))
{
    view_->setAccessibleName(tr("View to turn and shift"));
    view_->setToolTip(tr("View to turn and shift, where its picture does not lie over the others."));
    view_->setPrefix(tr("View") + QLatin1Char(' '));
    view_->setFocusPolicy(Qt::StrongFocus);
    reset_->setText(tr("Reset"));
    reset_->setAccessibleName(tr("Reset turn and shift of the view"));
    reset_->setToolTip(tr("Sets turn and shift of this view to 0."));
    reset_->setFocusPolicy(Qt::StrongFocus);
    growHeight(*reset_, 22);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setHorizontalSpacing(8);
    layout->setVerticalSpacing(4);
    const std::array<QString, 3> prefixes{tr("Turn"), tr("Right"), tr("Down")};
    const std::array<QString, 3> names{tr("Turn of the view, clockwise"), tr("Shift of the view to the right"),
                                       tr("Shift of the view down")};
    const std::array<QString, 3> tips{tr("Degrees clockwise about the center."),
                                      tr("Percent of the view's width; negative numbers shift it to the left."),
                                      tr("Percent of the view's height; negative numbers shift it up.")};
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        auto* number = numbers_.at(i) = new QDoubleSpinBox(this);
        number->setPrefix(prefixes.at(i) + QLatin1Char(' '));
        number->setSuffix(i == 0 ? QStringLiteral("°") : QStringLiteral(" %"));
        const double most = i == 0 ? printing::mostTurn : printing::mostShift;
        number->setRange(-most, most);
        number->setDecimals(3);
        number->setSingleStep(0.1);
        number->setKeyboardTracking(false);
        number->setAccessibleName(names.at(i));
        number->setToolTip(tips.at(i));
        number->setFocusPolicy(Qt::StrongFocus);
        number->setMinimumWidth(0);
        connect(number, &QDoubleSpinBox::valueChanged, this, [this, i] { change(i); });
    }
    connect(view_, &QSpinBox::valueChanged, this, [this] {
        gesture_ = 0;
        showPlace();
    });
    connect(reset_, &QToolButton::clicked, this,
            [this] { set({}, newGesture(), tr("Reset turn and shift of a view")); });
    connect(&setup_, &PrintSetup::changed, this, &PlaceBar::showPlace);
    followType(*this, [this, layout] { layOut(*layout); });
    showViews(nullptr);
}

void PlaceBar::layOut(QGridLayout& layout)
{
    const int columns = isLargeType(*this) ? 2 : 3;
    for (QWidget* part : std::initializer_list<QWidget*>{view_, reset_}) layout.removeWidget(part);
    layout.addWidget(view_, 0, 0, 1, columns - 1);
    layout.addWidget(reset_, 0, columns - 1);
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const int place = static_cast<int>(i);
        layout.removeWidget(numbers_.at(i));
        layout.addWidget(numbers_.at(i), 1 + place / columns, place % columns);
    }
}

void PlaceBar::showViews(const printing::PrintViews* views)
{
    pictures_ = views ? views->pictures() : std::vector<int>();
    // Rendered views are aligned by their cameras.
    if (std::any_of(pictures_.begin(), pictures_.end(), [](int picture) { return picture == 0; })) pictures_.clear();
    {
        const QSignalBlocker quiet(view_);
        view_->setRange(1, std::max(1, static_cast<int>(pictures_.size())));
        view_->setSuffix(QLatin1Char(' ') + tr("of %1").arg(pictures_.size()));
    }
    showPlace();
}

int PlaceBar::picture() const
{
    const auto view = static_cast<std::size_t>(view_->value());
    return view <= pictures_.size() ? pictures_[view - 1] : 0;
}

printing::ViewPlaces PlaceBar::places() const
{
    try {
        return printing::viewPlaces(setup_.values()[printing::printTable().places]);
    } catch (const std::exception&) {
        return {};  // `readViews` reports text that cannot be read; the next change replaces it.
    }
}

printing::ViewPlace PlaceBar::place() const
{
    return placeOf(places(), picture());
}

void PlaceBar::showPlace()
{
    const printing::ViewPlace place = this->place();
    const std::array<double, 3> shown{place.turn, place.shift.x, place.shift.y};
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const QSignalBlocker quiet(numbers_.at(i));
        numbers_.at(i)->setValue(shown.at(i));
        numbers_.at(i)->setEnabled(picture() > 0);
    }
    view_->setEnabled(picture() > 0);
    reset_->setEnabled(place != printing::ViewPlace{});
}

void PlaceBar::change(std::size_t field)
{
    if (gesture_ == 0 || changed_ != field) gesture_ = newGesture();
    changed_ = field;
    printing::ViewPlace place = this->place();
    (field == 0 ? place.turn : field == 1 ? place.shift.x : place.shift.y) = numbers_.at(field)->value();
    set(place, gesture_, tr("Turn or shift a view"));
}

void PlaceBar::set(const printing::ViewPlace& place, Gesture gesture, const QString& text)
{
    if (picture() == 0) return;
    ParameterValues values = setup_.values();
    printing::ViewPlaces places = this->places();
    places[picture()] = place;
    values.set(printing::printTable().places, textOf(places));
    setup_.change(text, values, gesture);
}

}  // namespace vitrine::ui

#include "moc_place_bar.cpp"
