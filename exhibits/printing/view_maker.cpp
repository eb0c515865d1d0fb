#include "exhibits/printing/view_maker.h"

#include "render/failure.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::printing {
namespace {

/// Returns the value at `part` (0 to 1) between two; nothing if they cannot be interpolated.
std::optional<Value> between(const ParameterInfo& parameter, const Value& from, const Value& to, double part)
{
    if (parameter.isNumeric()) {
        const double a = std::get<double>(from);
        const double b = std::get<double>(to);
        if (parameter.range.scale == Scale::logarithmic && a > 0 && b > 0) return a * std::pow(b / a, part);
        return a + (b - a) * part;
    }
    if (parameter.kind == Kind::color || parameter.kind == Kind::direction)
        return glm::mix(std::get<glm::dvec3>(from), std::get<glm::dvec3>(to), part);
    return std::nullopt;
}

}  // namespace

std::vector<ViewShot> shotsOf(const ViewRig& rig, const ViewShot& base)
{
    std::vector<ViewShot> shots(static_cast<std::size_t>(rig.count()), base);
    for (int k = 0; k < rig.count(); ++k) {
        ViewShot& shot = shots[static_cast<std::size_t>(k)];
        shot.sceneState.camera = shot.request.frame.camera = rig.camera(k);
        shot.request.frame.seed = base.request.frame.seed + static_cast<std::uint32_t>(k);
    }
    return shots;
}

void turn(std::vector<ViewShot>& shots, double angle)
{
    if (!std::isfinite(angle)) throw Failure(ErrorKind::usage, "The turn is not finite; give an angle.");
    const auto count = static_cast<double>(shots.size());
    for (std::size_t k = 0; k < shots.size(); ++k) {
        FrameRequest& frame = shots[k].request.frame;
        if (!frame.subject && !frame.alone)
            throw Failure(ErrorKind::usage, "The hall cannot be turned; name an exhibit.");
        // Walking to the right shows what a rotation to the left, seen from above, would show.
        const double part = (static_cast<double>(k) + 0.5) / count - 0.5;
        frame.exhibitTransform =
            glm::rotate(glm::dmat4(1), -part * angle, glm::dvec3(0, 1, 0)) * frame.exhibitTransform;
    }
}

void sweep(std::vector<ViewShot>& shots, const SceneState& from, const SceneState& to)
{
    bool anything = false;
    for (std::size_t exhibit = 0; exhibit < from.values.size(); ++exhibit) {
        const ParameterValues& a = from.values[exhibit];
        const ParameterValues& b = to.values[exhibit];
        for (std::size_t row = 0; row < a.rows().size(); ++row) {
            if (a.row(row) == b.row(row)) continue;
            anything = true;
            for (std::size_t k = 0; k < shots.size(); ++k) {
                const double part =
                    shots.size() == 1 ? 0.5 : static_cast<double>(k) / static_cast<double>(shots.size() - 1);
                const std::optional<Value> value = between(a.rows()[row], a.row(row), b.row(row), part);
                if (!value)
                    throw Failure(ErrorKind::usage,
                                  std::string(a.rows()[row].name) +
                                      " has no values between two others; let a number, a color or a direction run.");
                shots[k].sceneState.values[exhibit].setMotion(row, std::nullopt);
                shots[k].sceneState.values[exhibit].setParameter(row, *value);
            }
        }
    }
    if (!anything)
        throw Failure(
            ErrorKind::usage,
            "Both ends of the sweep are equal, so that all views would be the same; give two different values.");
}

ViewMaker::ViewMaker(const Museum& museum, render::RenderBackend& backend, std::vector<ViewShot> shots, Take take)
    : museum_(museum), backend_(backend), shots_(std::move(shots)), take_(std::move(take))
{
}

double ViewMaker::progress() const
{
    return (static_cast<double>(next_) + (maker_ ? maker_->progress() : 0)) /
           static_cast<double>(std::max<std::size_t>(shots_.size(), 1));
}

bool ViewMaker::step()
{
    if (next_ == shots_.size()) return false;
    if (!maker_) maker_.emplace(museum_, backend_, shots_[next_].sceneState, shots_[next_].request);
    maker_->step();
    if (!maker_->finished()) return true;
    take_(static_cast<int>(next_), maker_->picture());
    maker_.reset();
    ++next_;
    return true;
}

ViewShot depthShot(ViewShot shot, int width)
{
    PictureRequest& request = shot.request;
    const glm::dvec2 size(request.frame.raster.size);
    request.frame.raster.size =
        glm::max(glm::ivec2(glm::round(size * (std::min<double>(width, size.x) / size.x))), glm::ivec2(1));
    request.frame.channels = {};
    request.samples = 1;
    request.depth = true;
    return shot;
}

DepthRange measuredDepth(const Museum& museum, render::RenderBackend& backend, const ViewShot& shot)
{
    const ViewShot quick = depthShot(shot);
    PictureMaker maker(museum, backend, quick.sceneState, quick.request);
    while (maker.step()) {
    }
    return depthRange(maker.picture());
}

}  // namespace vitrine::printing
