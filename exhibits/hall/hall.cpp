#include "exhibits/hall/hall.h"

#include "exhibits/hall/plaque_text.h"
#include "render/image/image_io.h"
#include "render/scene/gltf.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine {

/// What the user named, read once per path. Planning is const; this is only a cache.
struct Hall::Loaded {
    std::string environmentPath, modelPath;
    std::shared_ptr<const render::Texture> environment;
    double environmentBrightest = 0;
    std::shared_ptr<const render::Model> model;
};

namespace {

/// The largest value of a picture; 1 for what is stored as bytes. NaN and infinity count as 0.
double brightestOf(const render::Texture& picture)
{
    if (picture.floats.empty()) return 1;
    double brightest = 0;
    for (const float value : picture.floats)
        if (std::isfinite(value)) brightest = std::max(brightest, static_cast<double>(value));
    return brightest;
}

}  // namespace

Hall::Hall(std::shared_ptr<const HallModel> model) : model_(std::move(model)), loaded_(std::make_unique<Loaded>()) {}

Hall::~Hall() = default;

void Hall::setGuests(std::vector<Guest> guests)
{
    guests_ = std::move(guests);
    text_ = std::make_shared<PlaqueText>(*model_, guests_);
}

render::Box Hall::bounds(const ParameterValues&) const
{
    return model_->bounds();
}

render::Camera Hall::bestView(const ParameterValues&) const
{
    return {{1.35, 1.65, 10.2}, {-0.35, 2.15, -4.0}, 0.959931};
}

double Hall::nextChange(const ParameterValues&, double) const
{
    return std::numeric_limits<double>::infinity();
}

std::vector<StudyView> Hall::studyViews(const ParameterValues& values) const
{
    // The hard ones: bright sky against dark stone, lines thinner than a pixel, and a floor seen at a grazing angle.
    return {{"from the entrance", bestView(values), 0, values},
            {"into the window", {{0.4, 1.65, -5.5}, {0, 4.2, -12}, 0.959931}, 0, values},
            {"up to the vault", {{-3.5, 1.65, 6}, {1, 8.5, -3}, 0.8}, 0, values},
            {"along the floor", {{-4.5, 0.35, 9}, {2, 0.1, -9}, 0.6}, 0, values}};
}

HallScene Hall::scene(const ParameterValues& values, bool alone) const
{
    const std::string environment = values[table_.environment];
    if (environment != loaded_->environmentPath) {
        loaded_->environment = environment.empty() ? nullptr : render::loadTexture(environment, true, true);
        loaded_->environmentBrightest = loaded_->environment ? brightestOf(*loaded_->environment) : 0;
        loaded_->environmentPath = environment;
    }
    const std::string model = values[table_.model];
    if (model != loaded_->modelPath) {
        loaded_->model = model.empty() ? nullptr : std::make_shared<render::Model>(render::loadGltf(model));
        loaded_->modelPath = model;
    }
    HallScene scene{*model_, table_, values, alone, loaded_->environment, loaded_->environmentBrightest, nullptr, glm::dmat4(1), text_, guests_, {}};
    if (alone || !loaded_->model) return scene;

    scene.visitorModel = loaded_->model;
    const Place* plinth = model_->place(10);
    const render::Box& box = loaded_->model->bounds;
    const glm::dvec3 extent = 2.0 * box.halfSize();
    const double largest = std::max({extent.x, extent.y, extent.z, 1e-9});
    glm::dmat4 m = plinth ? plinth->worldFromPlace : glm::dmat4(1);
    m = glm::rotate(m, values[table_.modelTurn], glm::dvec3(0, 1, 0));
    m = glm::scale(m, glm::dvec3(values[table_.modelSize] / largest));
    // It stands on its lowest point, above the middle of the plinth.
    scene.worldFromVisitorModel = glm::translate(m, -glm::dvec3(box.center().x, box.low.y, box.center().z));
    return scene;
}

void Hall::plan(const PlanContext& context, render::FramePlan& plan) const
{
    HallScene hall = scene(context.values, context.alone);
    hall.turns = context.turns;
    planHallShadow(hall, context.surroundings, plan);
    planProbe(hall, context.surroundings, plan);
    if (context.alone) plan.skip("hall/walls", "the exhibit is shown alone");
    else planWalls(hall, context.surroundings, context.channels, context.sincePressed, plan);
}

}  // namespace vitrine
