#include "ui/viewport/interaction.h"

#include "exhibits/framework/scene/tree.h"
#include "ui/viewport/exhibit_clock.h"
#include "ui/viewport/present_scene.h"
#include "ui/viewport/visitor.h"

#include <QWidget>

namespace vitrine::ui {

Interaction::Interaction(const QWidget& viewport, const PresentScene& scene, Visitor& visitor, ExhibitClock& clock)
    : viewport_(viewport), scene_(scene), visitor_(visitor), clock_(clock)
{
}

std::optional<Pointed> Interaction::pointedAt(const QPointF& at) const
{
    const double width = viewport_.width(), height = viewport_.height();
    if (width <= 0 || height <= 0 || visitor_.isInDepot()) return std::nullopt;
    return scene_.museum().surroundings().pick(scene_.prepared(), scene_.request(),
                                               {2 * at.x() / width - 1, 1 - 2 * at.y() / height});
}

std::optional<Pointed> Interaction::ahead() const
{
    return pointedAt(middle());
}

QPointF Interaction::middle() const
{
    return viewport_.rect().center();
}

void Interaction::lookAhead()
{
    const bool walks = visitor_.mode() == CameraControl::Mode::walk;
    buttonAhead_ = walks ? scene_.museum().surroundings().lookedAt(scene_.prepared()) : std::nullopt;
}

bool Interaction::orbitsButton() const
{
    return visitor_.mode() == CameraControl::Mode::orbit &&
           capability<HasButton>(scene_.museum().subject(visitor_.subject()));
}

Message Interaction::whyDisabled(std::size_t exhibit) const
{
    const auto* button = capability<HasButton>(scene_.museum().subject(exhibit));
    return button ? button->whyDisabled(scene_.prepared().sceneState.values[exhibit]) : Message();
}

Message Interaction::whyNotPress() const
{
    if (orbitsButton()) return whyDisabled(visitor_.subject());
    if (buttonAhead_) return whyDisabled(buttonAhead_->exhibit);
    return message("There is no red button in front of you.");
}

void Interaction::click(const QPointF& at)
{
    const std::size_t subject = visitor_.subject();
    const bool hasTree = capability<HasTree>(scene_.museum().subject(subject));
    if (visitor_.isInDepot()) {
        if (hasTree) emit shapeClicked(subject, at);
        return;
    }
    const std::optional<Pointed> found = pointedAt(at);
    if (!found) return;
    const bool orbited = visitor_.mode() == CameraControl::Mode::orbit && found->exhibit == subject;
    if (found->button && (found->inReach || orbited))
        pressButton(found->exhibit);
    else if (orbited && hasTree)
        emit shapeClicked(subject, at);
    else
        visitor_.visit(*found);
}

void Interaction::press()
{
    if (orbitsButton())
        pressButton(visitor_.subject());
    else if (buttonAhead_)
        pressButton(buttonAhead_->exhibit);
}

void Interaction::act()
{
    const bool orbits = visitor_.mode() == CameraControl::Mode::orbit;
    const bool hasTree = capability<HasTree>(scene_.museum().subject(visitor_.subject()));
    if (orbits ? !hasTree : buttonAhead_.has_value())
        press();
    else if (orbits || ahead())
        click(middle());
    else
        emit nothingAhead();
}

void Interaction::pressButton(std::size_t exhibit)
{
    if (!whyDisabled(exhibit).empty()) return;
    clock_.press(exhibit);
    emit pressed(exhibit);
}

}  // namespace vitrine::ui

#include "moc_interaction.cpp"
