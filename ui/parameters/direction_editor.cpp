#include "ui/parameters/direction_editor.h"

#include "ui/kit/language.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/shown_text.h"
#include "ui/viewport/camera_control.h"

#include <QHBoxLayout>
#include <QLabel>

#include <cmath>
#include <numbers>

namespace vitrine::ui {
namespace {

/// The two angles are a parameter table of their own, so that they have the fields, steps and typing of any number.
struct Angles final : Parameters {
    Real azimuth = real("azimuth", 0, degree, {-std::numbers::pi, std::numbers::pi},
                        "Compass angle: 0° is the far end of the hall, 90° its right side.");
    Real elevation = real("elevation", 0, degree, {-std::numbers::pi / 2, std::numbers::pi / 2},
                          "Height above the horizon: 90° is straight up.");
};

const ParameterInfo& angle(std::size_t i)
{
    static const Angles angles;
    return angles.rows()[i];
}

}  // namespace

DirectionEditor::DirectionEditor(const ValueRef& value, QWidget* parent)
    : ValueEditor(value, parent), azimuth_(new NumberField(angle(0), this)), elevation_(new NumberField(angle(1), this))
{
    const QString name = translatedText(label(row()));
    azimuth_->setAccessibleName(tr("%1, azimuth").arg(name));
    elevation_->setAccessibleName(tr("%1, elevation").arg(name));
    azimuth_->setToolTip(tooltipText(angle(0)));
    elevation_->setToolTip(tooltipText(angle(1)));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 0, 0, 0);
    layout->setSpacing(4);
    for (const auto& [sign, field] :
         {std::pair(QStringLiteral("↻"), azimuth_), std::pair(QStringLiteral("↑"), elevation_)}) {
        auto* mark = new QLabel(sign, this);
        mark->setEnabled(false);
        layout->addWidget(mark);
        layout->addWidget(field, 1);
        connect(field, &NumberField::edited, this, [this](double, int gesture) { take(gesture); });
    }
}

void DirectionEditor::showValue(const Value& value)
{
    const glm::dvec3& direction = std::get<glm::dvec3>(value);
    // A vertical direction has no azimuth: the fields keep theirs while they mean the same direction.
    if (glm::distance(direction, directionOf({azimuth_->value(), elevation_->value()})) < 1e-9) return;
    const Heading heading = headingOf(direction);
    azimuth_->showValue(heading.yaw);
    elevation_->showValue(heading.pitch);
}

void DirectionEditor::take(int gesture)
{
    edit(directionOf({azimuth_->value(), elevation_->value()}), gesture);
}

void DirectionEditor::labelPressed(double x)
{
    azimuth_->setFocus(Qt::MouseFocusReason);
    azimuth_->dragFrom(x);
}

void DirectionEditor::labelMoved(double x, Qt::KeyboardModifiers modifiers)
{
    azimuth_->dragTo(x, modifiers);
}

void DirectionEditor::labelReleased()
{
    azimuth_->dragEnd();
}

}  // namespace vitrine::ui

#include "moc_direction_editor.cpp"
