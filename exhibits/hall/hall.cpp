#include "exhibits/hall/hall.h"

#include "exhibits/hall/plaque_text.h"
#include "exhibits/kit/panorama.h"
#include "render/hash.h"
#include "render/scene/gltf.h"
#include "render/scene/held_bytes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine {

namespace {

render::AssetStore::Made<render::Model> readModel(const std::string& path)
{
    auto model = std::make_shared<render::Model>(render::loadGltf(path));
    const std::uint64_t bytes = heldBytes(*model);
    return {std::move(model), bytes};
}

}  // namespace

Hall::Hall(std::shared_ptr<const HallModel> model, std::vector<ExhibitSlot> exhibits)
    : model_(std::move(model)), exhibits_(std::move(exhibits)), text_(std::make_shared<PlaqueText>(*model_, exhibits_))
{
}

render::Box Hall::bounds(const ParameterValues&) const
{
    return model_->bounds();
}

render::Camera Hall::bestView(const ParameterValues&) const
{
    return {{1.35, 1.65, 10.2}, {-0.35, 2.15, -4.0}, 0.959931};
}

std::vector<StudyView> Hall::studyViews(const ParameterValues& values) const
{
    // Half-shadows and mirror images in the grazing floor; the coffers' fine edges; bars before the brightest there is.
    return {{"best view", bestView(values), 0, values},
            {"along the floor", {{4.6, 0.45, 2.5}, {-2.5, 0.35, -9}, 0.959931}, 0, values},
            {"up into the vault", {{-2.2, 1.65, 5.5}, {0.6, 7.2, -3}, 1.047198}, 0, values},
            {"into the window", {{1.2, 1.65, -5.5}, {-0.4, 3.6, -12}, 0.959931}, 0, values}};
}

std::shared_ptr<const PreparedHall> Hall::prepare(const ParameterValues& values, render::AssetStore& assets) const
{
    auto made = std::make_shared<PreparedHall>();
    render::Hash files;
    const auto warn = [&](const char* step, File row, const std::string& failure) {
        if (!failure.empty())
            made->unreadable.push_back({step, unreadableFile(values.rows()[row.row], title(), failure),
                                        "It is left out until it can be read."});
    };
    if (const std::string path = values[table_.environment]; !path.empty()) {
        const render::Asset<Panorama> found = assets.get<Panorama>("hall.environment", path, readPanorama);
        warn("hall/environment", table_.environment, found.failure);
        files.addValue(found.id);
        if (found.value) {
            made->environment = found.value->picture;
            made->environmentBrightest = found.value->brightest;
        }
    }
    if (const std::string path = values[table_.model]; !path.empty()) {
        render::Asset<render::Model> found = assets.get<render::Model>("hall.model", path, readModel);
        warn("hall/model", table_.model, found.failure);
        files.addValue(found.id);
        made->visitorModel = std::move(found.value);
    }
    made->filesId = files.value();
    return made;
}

HallScene Hall::scene(const ParameterValues& values, bool alone, const PreparedHall* prepared) const
{
    HallScene scene{
        .model = *model_, .table = table_, .values = values, .alone = alone, .text = text_, .exhibits = exhibits_};
    if (prepared) {
        scene.environment = prepared->environment;
        scene.environmentBrightest = prepared->environmentBrightest;
        scene.filesId = prepared->filesId;
        if (!alone) scene.visitorModel = prepared->visitorModel;
    }
    if (!scene.visitorModel) return scene;

    const Place* plinth = model_->place(10);
    const render::Box& box = scene.visitorModel->bounds;
    const glm::dvec3 extent = 2.0 * box.halfSize();
    const double largest = std::max({extent.x, extent.y, extent.z, 1e-9});
    glm::dmat4 m = plinth ? plinth->worldFromPlace : glm::dmat4(1);
    m = glm::rotate(m, values[table_.modelRotation], glm::dvec3(0, 1, 0));
    m = glm::scale(m, glm::dvec3(values[table_.modelSize] / largest));
    // It stands on its lowest point, above the middle of the plinth.
    scene.worldFromVisitorModel = glm::translate(m, -glm::dvec3(box.center().x, box.low.y, box.center().z));
    return scene;
}

}  // namespace vitrine
