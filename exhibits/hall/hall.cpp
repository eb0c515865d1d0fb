#include "exhibits/hall/hall.h"

#include "exhibits/hall/plaque_text.h"
#include "exhibits/hall/spotlights.h"
#include "exhibits/kit/panorama.h"
#include "render/hash.h"

#include <algorithm>

namespace vitrine::hall {

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
    // The views show penumbrae and reflections in the floor at grazing angles, fine edges of the coffers, and bars in
    // front of the brightest light.
    return {{"best view", bestView(values), 0, values},
            {"along the floor", {{4.6, 0.45, 2.5}, {-2.5, 0.35, -9}, 0.959931}, 0, values},
            {"up into the vault", {{-2.2, 1.65, 5.5}, {0.6, 7.2, -3}, 1.047198}, 0, values},
            {"into the window", {{1.2, 1.65, -5.5}, {-0.4, 3.6, -12}, 0.959931}, 0, values}};
}

std::vector<render::LocalLight> Hall::localLights(const ExhibitState& state) const
{
    return spotlights(*model_, exhibits_, table_, state.values);
}

std::shared_ptr<const PreparedHall> Hall::prepare(const ParameterValues& values, render::AssetStore& assets) const
{
    auto made = std::make_shared<PreparedHall>();
    render::Hash files;
    const auto warn = [&](const std::string& step, File parameter, const Message& failure) {
        if (!failure.empty())
            made->unreadable.push_back({step, unreadableFile(values.rows()[parameter.row], title(), failure),
                                        message("It is left out until it can be read.")});
    };
    if (const std::string path = values[table_.environment]; !path.empty()) {
        const render::Asset<Panorama> found = assets.get<Panorama>("hall.environment", path, readPanorama);
        warn("hall/environment", table_.environment, found.failure);
        files.addValue(found.id);
        if (found.value) {
            made->environment = found.value->picture;
            made->environmentBrightest = found.value->brightest;
            made->environmentNotes = found.value->notes;
        }
    }
    made->objects = preparedObjects(table_, values, assets, files, [&](std::size_t which, const Message& failure) {
        const std::string step = which == 0 ? "hall/model" : "hall/model/" + std::to_string(which + 1);
        warn(step, table_.objects[which].model, failure);
    });
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
        scene.environmentNotes = prepared->environmentNotes;
        scene.filesId = prepared->filesId;
        if (!alone) scene.objects = objectsAt(*model_, table_, values, prepared->objects);
    }
    return scene;
}

ParameterValues Hall::whileOpening(const ParameterValues& values) const
{
    constexpr int largestProbe = 64, largestShadowMap = 1024;  // Texels per side.
    ParameterValues coarse = values;
    coarse.set(table_.probeSize, std::min(values[table_.probeSize], largestProbe));
    coarse.set(table_.shadowMapSize, std::min(values[table_.shadowMapSize], largestShadowMap));
    return coarse;
}

}  // namespace vitrine::hall
