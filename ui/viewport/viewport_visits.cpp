// Where the visitor goes, and what his clicks mean.
#include "ui/viewport/viewport.h"

#include "exhibits/framework/tree.h"
#include "ui/kit/language.h"
#include "ui/kit/numbers.h"
#include "ui/kit/text.h"
#include "ui/viewport/overlay.h"
#include "ui/viewport/viewport_input.h"

#include <cmath>

namespace vitrine::ui {
namespace {

constexpr std::size_t mostFormer = 100;

}  // namespace

void Viewport::visit(std::size_t exhibit)
{
    remember();
    goFrom(isInDepot(), exhibit,
           {museum_.bestView(exhibit, history_.sceneState().values[exhibit]),
            exhibit == hallIndex ? CameraControl::Mode::walk : CameraControl::Mode::orbit});
    going_->say(tr("Going to %1 …").arg(said(museum_.subject(exhibit).title())));
}

bool Viewport::isInDepot() const
{
    return subject_ != hallIndex && !museum_.isInHall(subject_) && control_.mode() == CameraControl::Mode::orbit;
}

/// Between the depot and the hall there is no way to glide: the picture changes at once.
void Viewport::goFrom(bool depot, std::size_t subject, const CameraControl::Standpoint& there)
{
    const bool cuts = control_.cuts();
    control_.setCutting(cuts || depot || (subject != hallIndex && !museum_.isInHall(subject)));
    subject_ = subject;
    control_.glideTo(there);
    leftFor();
    control_.setCutting(cuts);
}

void Viewport::visit(const OwnObjectShown& object)
{
    remember();
    goFrom(isInDepot(), hallIndex, {object.view, CameraControl::Mode::orbit});
    emit visited(hallIndex);
}

void Viewport::leftFor()
{
    cut_ = cut_ || control_.cuts();
    cameraChanged();
    tellText(*this);
}

void Viewport::noteArrival()
{
    if (!control_.moving() && drawnState_ == sceneStateNumber_) going_->say({});
}

void Viewport::remember()
{
    if (former_.size() == mostFormer) former_.erase(former_.begin());
    former_.push_back({control_.standpoint(), subject_});
}

void Viewport::goBack()
{
    if (former_.empty()) return;
    const Former former = former_.back();
    former_.pop_back();
    goFrom(isInDepot(), former.subject, former.standpoint);
    emit visited(former.subject);
}

void Viewport::jumpTo(const render::Camera& camera)
{
    cut_ = true;
    control_.jumpTo(camera);
    cameraChanged();
}

void Viewport::goTo(const render::Camera& camera)
{
    remember();
    constexpr double visitorsEye = 1.65;
    const bool stands =
        std::abs(camera.eye.y - visitorsEye) < 1e-6 && museum_.obstacles(prepared()).walks(camera.eye, camera.eye);
    goFrom(isInDepot(), isInDepot() ? hallIndex : subject_,
           {camera, stands ? CameraControl::Mode::walk : CameraControl::Mode::orbit});
}

void Viewport::walkOn()
{
    if (control_.standpoint().mode == CameraControl::Mode::walk) return;
    if (isInDepot()) {
        visit(hallIndex);
        emit walkedOn();
        return;
    }
    remember();
    control_.walkOn();
    leftFor();
    emit walkedOn();
}

void Viewport::click(const QPointF& at)
{
    if (isInDepot()) {
        if (capability<HasTree>(museum_.subject(subject_))) emit shapeClicked(subject_, at);
        return;
    }
    const std::optional<Pointed> found = pointedAt(at);
    if (!found) return;
    const bool orbited = control_.mode() == CameraControl::Mode::orbit && found->exhibit == subject_;
    if (found->button && (found->inReach || orbited)) return pressButton(found->exhibit);
    if (orbited && capability<HasTree>(museum_.subject(subject_))) {
        emit shapeClicked(subject_, at);
        return;
    }
    remember();
    subject_ = found->exhibit;
    control_.visit(found->view);
    leftFor();
    emit visited(found->exhibit);
}

std::optional<Pointed> Viewport::pointedAt(const QPointF& at) const
{
    if (width() <= 0 || height() <= 0 || isInDepot()) return std::nullopt;
    return museum_.pick(prepared(), request(time_), {2 * at.x() / width() - 1, 1 - 2 * at.y() / height()});
}

bool Viewport::orbitsButton() const
{
    return control_.mode() == CameraControl::Mode::orbit && capability<HasButton>(museum_.subject(subject_));
}

bool Viewport::canPress() const
{
    return orbitsButton() || lookedAt_;
}

void Viewport::press()
{
    if (orbitsButton())
        pressButton(subject_);
    else if (lookedAt_)
        pressButton(lookedAt_->exhibit);
}

void Viewport::showHint(const QString& text)
{
    hint_->say(text);
}

void Viewport::setSticks(const WalkKeys& sticks)
{
    input_->setSticks(sticks);
}

const WalkKeys& Viewport::sticks() const
{
    return input_->sticks();
}

void Viewport::act()
{
    const bool orbits = control_.mode() == CameraControl::Mode::orbit;
    if (orbits ? !capability<HasTree>(museum_.subject(subject_)) : lookedAt_.has_value())
        press();
    else if (orbits || pointedAt(QPointF(rect().center())))
        click(QPointF(rect().center()));
    else
        showHint(tr("Nothing to visit is in the middle of the picture."));
}

render::View Viewport::view() const
{
    const FrameRequest now = request(time_);
    return render::makeView(now.camera, now.raster);
}

QString Viewport::spokenText() const
{
    const CameraControl::Standpoint there = control_.standpoint();
    if (there.mode == CameraControl::Mode::orbit)
        return tr("You look at %1, from %2 m away.")
            .arg(text(museum_.subject(subject_).title()))
            .arg(numberLocale().toString(glm::distance(there.camera.eye, there.camera.target), 'f', 1));
    if (lookedAt_) return tr("You walk through the hall. Before you: %1.").arg(QString::fromStdString(lookedAt_->text));
    const std::optional<Pointed> ahead = shown_.isNull() ? std::nullopt : pointedAt(QPointF(rect().center()));
    return ahead ? tr("You walk through the hall and look at %1.").arg(QString::fromStdString(ahead->name))
                 : tr("You walk through the hall.");
}

void Viewport::pressButton(std::size_t exhibit)
{
    pressedAt_[exhibit] = time_;
    sceneStateChanged();
    emit pressed(exhibit);
}

}  // namespace vitrine::ui
