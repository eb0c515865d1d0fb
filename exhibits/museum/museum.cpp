#include "exhibits/museum/museum.h"

#include "exhibits/framework/derive.h"
#include "exhibits/hall/hall.h"
#include "exhibits/hall/hall_model.h"
#include "exhibits/hall/walk.h"
#include "render/failure.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine {
namespace {

/// The box together with the shadow it throws on the floor (or 15 m of it, where the sun is low).
render::Box withShadow(const render::Box& box, const glm::dvec3& towardsSun)
{
    render::Box swept = box;
    const double fall = towardsSun.y > 1e-3 ? std::min(std::max(box.high.y, 0.0) / towardsSun.y, 15.0) : 15.0;
    swept.include(box.low - towardsSun * fall);
    swept.include(box.high - towardsSun * fall);
    return swept;
}

/// Empty when the sun may reach the box and the shadow that it then throws may be seen.
std::string whyNoShadow(const HallScene& scene, const render::Box& box, const render::View& view)
{
    if (std::string why = whyUnlit(scene, box); !why.empty()) return why;
    return view.mayContain(withShadow(box, towardsSun(scene))) ? std::string() : "neither it nor its shadow is in view";
}

/// The part of the picture that holds everything within the box; nothing when some of it may lie behind the eye.
std::optional<std::pair<glm::dvec2, glm::dvec2>> screenBox(const render::Box& box, const render::View& view)
{
    glm::dvec2 low(1e30);
    glm::dvec2 high(-1e30);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 world((corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y, (corner & 4) != 0 ? box.high.z : box.low.z);
        const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(world, 1);
        if (!(clip.w > view.nearPlane)) return std::nullopt;
        const glm::dvec2 pixel = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(view.raster.size);
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    return std::pair(low, high);
}

/// Seconds since the button of exhibit `i` was pressed.
double sincePress(const FrameRequest& request, std::size_t i)
{
    return i < request.sincePressed.size() ? request.sincePressed[i] : std::numeric_limits<double>::infinity();
}

}  // namespace

Museum::Museum(std::vector<std::unique_ptr<Exhibit>> guests) : model_(std::make_shared<const HallModel>())
{
    auto hall = std::make_unique<Hall>(model_);
    std::vector<Guest> plaques;
    for (const auto& guest : guests)
        plaques.push_back({guest->place(), std::string(guest->title()), std::string(guest->summary()), std::string(guest->tryThis()), std::string(guest->buttonText())});
    hall->setGuests(std::move(plaques));
    exhibits_.push_back(std::move(hall));
    for (auto& guest : guests) exhibits_.push_back(std::move(guest));
}

Museum::~Museum() = default;

std::optional<std::size_t> Museum::find(std::string_view name) const
{
    for (std::size_t i = 0; i < exhibits_.size(); ++i)
        if (exhibits_[i]->name() == name) return i;
    return std::nullopt;
}

Look Museum::initialLook() const
{
    Look look;
    for (const auto& exhibit : exhibits_) look.values.push_back(exhibit->parameters().initial());
    look.camera = hall().bestView(look.values.front());
    return look;
}

PictureQuality pictureQuality(const ParameterValues& hall)
{
    PictureQuality quality;
    if (const auto row = hall.table().find(supersamplesRow)) quality.supersamples = static_cast<int>(std::get<double>(hall.row(*row)));
    if (const auto row = hall.table().find(resolutionScaleRow)) quality.resolutionScale = std::get<double>(hall.row(*row));
    return quality;
}

glm::dmat4 Museum::worldFromExhibit(std::size_t i) const
{
    const Place* place = model_->place(exhibits_[i]->place());
    return place ? place->worldFromPlace : glm::dmat4(1);
}

render::Camera Museum::bestView(std::size_t i, const ParameterValues& values) const
{
    const std::scoped_lock lock(planning_);
    const glm::dmat4 world = worldFromExhibit(i);
    render::Camera camera = exhibits_[i]->bestView(values);
    camera.eye = glm::dvec3(world * glm::dvec4(camera.eye, 1));
    camera.target = glm::dvec3(world * glm::dvec4(camera.target, 1));
    return camera;
}

std::string Museum::whyHidden(const render::Box& box, const render::View& view, bool alone) const
{
    if (!view.mayContain(box)) return "out of view";
    if (alone || isInWalls(*model_, view.eye)) return {};  // No walls stand here, or one looks through them.
    for (const Occluder& occluder : model_->occluders())
        if (isBehind(occluder, box, view.eye)) return "behind a wall";
    return {};
}

render::FramePlan Museum::plan(const Look& look, const FrameRequest& request, const render::KeptKeys& kept) const
{
    const std::scoped_lock lock(planning_);
    const auto& theHall = static_cast<const Hall&>(hall());
    const bool alone = request.alone.has_value();
    const HallScene scene = theHall.scene(look.values.front(), alone);
    Surroundings light = surroundings(scene, request.runEverything);
    light.light.disk.z = static_cast<float>(request.sample);

    render::FramePlan plan;
    render::Raster raster = request.raster;
    raster.jitter = render::samplePosition(request.sample, request.samples);
    plan.view = render::makeView(request.camera, raster);
    plan.time = request.time;
    plan.seed = request.seed;
    plan.sample = request.sample;
    plan.runEverything = request.runEverything;
    const bool exact = request.averageIn == AverageIn::radiance;
    plan.image({.name = radianceImage, .format = exact ? render::Format::rgba32f : render::Format::rgba16f});
    plan.image({.name = depthImage, .format = render::Format::depth32f, .nearest = true});
    plan.image({.name = normalImage, .format = render::Format::rgba32f});
    plan.image({.name = evaluationsImage, .format = render::Format::r32f});

    // Who is here, where, and who casts a shadow that may be seen.
    struct Present {
        std::size_t index;
        glm::dmat4 worldFromExhibit;
        std::string hidden, noShadow;
    };
    std::vector<Present> present;
    render::Box casters;
    render::Hash shadowKey;
    bool shadowSeen = false;
    for (std::size_t i = 1; i < exhibits_.size(); ++i) {
        if ((alone && i != *request.alone) || (request.cutOut && i != *request.cutOut)) continue;
        Present p{i, alone ? glm::dmat4(1) : worldFromExhibit(i), {}, {}};
        if (request.subject == i || request.alone == i) p.worldFromExhibit = p.worldFromExhibit * request.exhibitTransform;
        const render::Box box = exhibits_[i]->boundsAfterPress(look.values[i], sincePress(request, i)).transformed(p.worldFromExhibit);
        p.hidden = request.runEverything ? std::string() : whyHidden(box, plan.view, alone);
        const std::string unlit = exhibits_[i]->castsShadow() ? whyUnlit(scene, box) : "it is made of light";
        p.noShadow = !unlit.empty() || request.runEverything ? unlit : whyNoShadow(scene, box, plan.view);
        if (unlit.empty()) {
            // Seen or not: the map must not change its grid while one walks.
            casters.include(box.low);
            casters.include(box.high);
        }
        if (p.noShadow.empty()) {
            shadowSeen = true;
            derive::addToKey(shadowKey, look.values[i]);
            shadowKey.addValue(i).addValue(p.worldFromExhibit);
            const double since = sincePress(request, i);
            if (exhibits_[i]->nextChangeAfterPress(look.values[i], request.time, since) < std::numeric_limits<double>::infinity()) shadowKey.addValue(request.time).addValue(since);
        }
        present.push_back(std::move(p));
    }

    if (shadowSeen) {
        const int size = std::max(look.values.front()[theHall.parameters().shadowMapSize] / 4, 64);
        light.castsShadows = true;
        light.exhibitShadowView = steadyLightView(casters, towardsSun(scene), glm::ivec2(size), 30);
        light.light.exhibitShadowFromWorld = shadowFromWorld(light.exhibitShadowView);
        light.light.sunLightmap.w = 1;
        light.light.filtering.y = static_cast<float>(2 / light.exhibitShadowView.clipFromView[0][0] / size);
        light.exhibitShadowKey = shadowKey.addValue(light.exhibitShadowView.clipFromWorld).value();
        light.inputs.push_back({UNIT_SHADOW_EXHIBITS, std::string(exhibitShadowImage)});
        plan.image({.name = exhibitShadowImage, .format = render::Format::depth32f, .size = glm::ivec2(size), .kept = true, .comparison = true});
        render::Pass clear;
        clear.name = "exhibits/shadow";
        clear.reason = "an exhibit stands in the sun";
        clear.stage = render::Stage::shadow;
        clear.shader = {"hall/depth.vert", "hall/depth.frag", "", {}};
        clear.view = light.exhibitShadowView;
        clear.depth = render::Attachment{exhibitShadowImage, render::Load::clear, glm::vec4(0), -1, 0};
        clear.key = light.exhibitShadowKey;
        clear.bound = light.sunShadow;
        plan.add(std::move(clear));
    } else {
        plan.skip("exhibits/shadow", present.empty() ? "no exhibit stands here" : present.front().noShadow);
    }

    std::vector<double> turns;
    for (std::size_t i = 1; i < exhibits_.size(); ++i) turns.push_back(exhibits_[i]->turnOfHangings(look.values[i], request.time));
    const PlanContext hallContext{look.values.front(), light, glm::dmat4(1), request.time, request.channels, alone, request.cutOut ? "one exhibit is asked for without what is around it" : "", {},
                                  std::span(request.sincePressed).subspan(std::min<std::size_t>(request.sincePressed.size(), 1)), turns};
    theHall.plan(hallContext, plan);
    if (alone || request.cutOut) {
        render::Pass clear;
        clear.name = "clear";
        clear.reason = "an empty picture to start from";
        clear.stage = render::Stage::prepare;
        clear.shader = {"hall/depth.vert", "hall/depth.frag", "", {}};
        clear.colors = {{radianceImage, render::Load::clear, {}, -1, 0}};
        if (request.channels.normal) clear.colors.push_back({normalImage, render::Load::clear, {}, -1, 0});
        if (request.channels.evaluations) clear.colors.push_back({evaluationsImage, render::Load::clear, {}, -1, 0});
        clear.depth = render::Attachment{depthImage, render::Load::clear, {}, -1, 0};
        plan.add(std::move(clear));
    }
    std::vector<PlanContext> contexts;
    for (Present& p : present)
        contexts.push_back({look.values[p.index], light, p.worldFromExhibit, request.time, request.channels, alone, std::move(p.hidden), std::move(p.noShadow), {}, {}, sincePress(request, p.index)});
    for (std::size_t i = 0; i < present.size(); ++i) exhibits_[present[i].index]->plan(contexts[i], plan);
    const auto seenFrom = [&](const render::View& view) {
        render::FramePlan other;
        other.view = view;
        other.time = plan.time;
        other.seed = plan.seed;
        other.sample = plan.sample;
        theHall.plan(hallContext, other);
        for (std::size_t i = 0; i < present.size(); ++i) {
            const Exhibit& exhibit = *exhibits_[present[i].index];
            PlanContext context = contexts[i];
            context.channels = {};
            context.hiddenBecause = whyHidden(exhibit.boundsAfterPress(context.values, context.sinceOwnPress).transformed(context.worldFromExhibit), view, alone);
            context.noShadowBecause = "the frame draws the shadows";
            exhibit.plan(context, other);
        }
        return other;
    };
    for (std::size_t i = 0; i < present.size(); ++i) {
        PlanContext context = contexts[i];
        context.seenFrom = seenFrom;
        exhibits_[present[i].index]->planOverFrame(context, plan);
    }
    if (request.transparent || request.cutOut) plan.skip("sky", "a transparent background is asked for");
    else planSky(scene, light, plan);
    planDevelop(light, request, plan);

    std::vector<std::string> outputs{"frame", depthImage};
    if (request.channels.normal) outputs.emplace_back(normalImage);
    if (request.channels.evaluations) outputs.emplace_back(evaluationsImage);
    plan.prune(outputs, kept);
    for (const render::Skipped& skipped : plan.skipped())
        if (request.needsFiles && !skipped.unreadable.empty()) throw Failure(Blame::file, skipped.unreadable);
    return plan;
}

std::optional<PictureRegion> Museum::movingRegion(const Look& look, const FrameRequest& request) const
{
    constexpr double never = std::numeric_limits<double>::infinity();
    constexpr double shadowEdge = 0.15;  // Metres that a shadow is soft around its edge, and filtered over.
    constexpr double edge = 2;           // Pixels over which jitter and filters spread what moves.
    const std::scoped_lock lock(planning_);
    for (const double since : request.sincePressed)
        if (since < 0.2) return std::nullopt;  // The button itself.
    const render::View view = render::makeView(request.camera, request.raster);
    const HallScene scene = static_cast<const Hall&>(hall()).scene(look.values.front(), request.alone.has_value());
    glm::dvec2 low(1e30);
    glm::dvec2 high(-1e30);
    bool shadowMoves = false;
    bool lightInTheAir = false;
    for (std::size_t i = 1; i < exhibits_.size(); ++i) {
        if (request.alone && *request.alone != i) continue;
        const Exhibit& exhibit = *exhibits_[i];
        const render::Box box = exhibit.boundsAfterPress(look.values[i], sincePress(request, i)).transformed(request.alone ? glm::dmat4(1) : worldFromExhibit(i));
        const bool seen = whyHidden(box, view, request.alone.has_value()).empty();
        const bool shadowSeen = !request.alone && exhibit.castsShadow() && whyNoShadow(scene, box, view).empty();
        if (!exhibit.castsShadow() && seen) lightInTheAir = true;
        if (!(exhibit.nextChangeAfterPress(look.values[i], request.time, sincePress(request, i)) < never) || (!seen && !shadowSeen)) continue;
        if (!exhibit.castsShadow() || exhibit.turnOfHangings(look.values[i], 0) != exhibit.turnOfHangings(look.values[i], 1)) return std::nullopt;
        render::Box reach = box;
        if (shadowSeen) {
            shadowMoves = true;
            reach = withShadow(box, towardsSun(scene));
            reach.low -= shadowEdge;
            reach.high += shadowEdge;
        }
        const auto shown = screenBox(reach, view);
        if (!shown) return std::nullopt;
        low = glm::min(low, shown->first);
        high = glm::max(high, shown->second);
    }
    if (shadowMoves && lightInTheAir) return std::nullopt;
    const glm::dvec2 size(request.raster.size);
    const glm::ivec2 first = glm::ivec2(glm::floor(glm::clamp(low - edge, glm::dvec2(0), size) / 2.0)) * 2;
    const glm::ivec2 end = glm::min(glm::ivec2(glm::ceil(glm::clamp(high + edge, glm::dvec2(0), size) / 2.0)) * 2, request.raster.size);
    if (end.x <= first.x || end.y <= first.y) return PictureRegion{};
    return PictureRegion{first, end - first};
}

double Museum::nextChange(const Look& look, const FrameRequest& request) const
{
    const std::scoped_lock lock(planning_);
    double next = std::numeric_limits<double>::infinity();
    for (const double since : request.sincePressed)
        if (since < 0.2) next = 0;
    const render::View view = render::makeView(request.camera, request.raster);
    const HallScene scene = static_cast<const Hall&>(hall()).scene(look.values.front(), request.alone.has_value());
    for (std::size_t i = 1; i < exhibits_.size(); ++i) {
        if (request.alone && *request.alone != i) continue;
        const render::Box box = exhibits_[i]->boundsAfterPress(look.values[i], sincePress(request, i)).transformed(request.alone ? glm::dmat4(1) : worldFromExhibit(i));
        // What is hidden may move unseen, and so may its shadow.
        const bool shadowSeen = !request.alone && exhibits_[i]->castsShadow() && whyNoShadow(scene, box, view).empty();
        if (shadowSeen || whyHidden(box, view, request.alone.has_value()).empty()) next = std::min(next, exhibits_[i]->nextChangeAfterPress(look.values[i], request.time, sincePress(request, i)));
    }
    return next;
}

glm::dvec3 Museum::walk(const glm::dvec3& from, const glm::dvec3& to) const
{
    return walkAround(model_->colliders(), from, to);
}

std::vector<int> Museum::emptyPlaces() const
{
    std::vector<int> empty;
    for (int number = 1; number <= 9; ++number)
        if (std::none_of(exhibits_.begin() + 1, exhibits_.end(), [&](const auto& e) { return e->place() == number; })) empty.push_back(number);
    return empty;
}

}  // namespace vitrine
