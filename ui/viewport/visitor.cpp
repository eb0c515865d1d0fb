#include "ui/viewport/visitor.h"

#include "ui/model/history.h"

#include <cmath>
#include <utility>

namespace vitrine::ui {

Visitor::Visitor(const Museum& museum, const History& history, std::function<const Prepared&()> prepared)
    : museum_(museum), history_(history), prepared_(std::move(prepared))
{
    control_.setWalkable([this](const glm::dvec3& from, const glm::dvec3& to) {
        return museum_.surroundings().walk(prepared_(), from, to);
    });
    control_.jumpTo(history.sceneState().camera);
    connect(&history, &History::cameraMoved, this, [this] { jumpTo(history_.sceneState().camera); });
}

void Visitor::visit(std::size_t exhibit)
{
    remember();
    glideTo(exhibit, {museum_.bestView(exhibit, history_.sceneState().values[exhibit]),
                      exhibit == hallIndex ? CameraControl::Mode::walk : CameraControl::Mode::orbit});
    emit headedFor(exhibit);
}

void Visitor::visit(const OwnObjectShown& object)
{
    remember();
    glideTo(hallIndex, {object.view, CameraControl::Mode::orbit});
    emit visited(hallIndex);
}

void Visitor::visit(const Pointed& object)
{
    remember();
    subject_ = object.exhibit;
    control_.visit(object.view);
    depart();
    emit visited(object.exhibit);
}

void Visitor::goTo(const render::Camera& camera)
{
    remember();
    constexpr double visitorsEye = 1.65;
    const bool stands = std::abs(camera.eye.y - visitorsEye) < 1e-6 &&
                        museum_.surroundings().obstacles(prepared_()).walks(camera.eye, camera.eye);
    glideTo(isInDepot() ? hallIndex : subject_,
            {camera, stands ? CameraControl::Mode::walk : CameraControl::Mode::orbit});
}

void Visitor::goBack()
{
    if (former_.empty()) return;
    const Former former = former_.back();
    former_.pop_back();
    glideTo(former.subject, former.standpoint);
    emit visited(former.subject);
}

void Visitor::walkOn()
{
    if (control_.standpoint().mode == CameraControl::Mode::walk) return;
    if (isInDepot()) {
        visit(hallIndex);
        emit walkedOn();
        return;
    }
    remember();
    control_.walkOn();
    depart();
    emit walkedOn();
}

void Visitor::jumpTo(const render::Camera& camera)
{
    control_.jumpTo(camera);
    emit moved(true);
}

void Visitor::advance(double seconds, const WalkKeys& keys)
{
    if (isInDepot() && keys.moves()) walkOn();
    const CameraControl::Mode before = control_.mode();
    const bool changed = control_.advance(seconds, keys);
    const bool left = before == CameraControl::Mode::orbit && control_.mode() != before;
    if (changed) emit moved(left && control_.cuts());
    if (left) emit walkedOn();
}

bool Visitor::isInDepot() const
{
    return subject_ != hallIndex && !museum_.isInHall(subject_) && control_.mode() == CameraControl::Mode::orbit;
}

void Visitor::glideTo(std::size_t subject, const CameraControl::Standpoint& there)
{
    const bool cuts = control_.cuts();
    control_.setCutting(cuts || isInDepot() || (subject != hallIndex && !museum_.isInHall(subject)));
    subject_ = subject;
    control_.glideTo(there);
    depart();
    control_.setCutting(cuts);
}

void Visitor::depart()
{
    emit moved(control_.cuts());
    emit departed();
}

void Visitor::remember()
{
    if (former_.size() == mostFormer) former_.erase(former_.begin());
    former_.push_back({control_.standpoint(), subject_});
}

}  // namespace vitrine::ui

#include "moc_visitor.cpp"
