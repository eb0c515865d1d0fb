#include "exhibits/museum/museum.h"

#include "exhibits/hall/hall.h"
#include "exhibits/hall/hall_model.h"
#include "exhibits/kit/blue_noise.h"

#include <algorithm>
#include <cassert>

namespace vitrine {
namespace {

std::vector<ExhibitSlot> slotsOf(const std::vector<std::unique_ptr<Exhibit>>& exhibits)
{
    std::vector<ExhibitSlot> made;
    for (const auto& e : exhibits)
        made.push_back({e->place(), std::string(e->title()), std::string(e->summary()), std::string(e->tryThis()),
                        capability<HasButton>(*e) != nullptr});
    return made;
}

}  // namespace

Museum::Museum(std::vector<std::unique_ptr<Exhibit>> exhibits)
    : blueNoise_(std::async(std::launch::async, [] { (void)blueNoise(); })),
      model_(std::make_shared<const HallModel>()), building_(model_->colliders()), owned_(std::move(exhibits)),
      hall_(std::make_unique<const Hall>(model_, slotsOf(owned_))), subjects_{hall_.get()},
      assets_(std::make_unique<render::AssetStore>())
{
    for (const auto& exhibit : owned_) {
        exhibits_.push_back({subjects_.size(), *exhibit});
        subjects_.push_back(exhibit.get());
    }
}

Museum::~Museum() = default;

const Subject& Museum::hall() const
{
    return *hall_;
}

const Exhibit& Museum::exhibit(std::size_t i) const
{
    assert(i != hallIndex);
    return exhibits_[i - hallIndex - 1].exhibit;
}

std::optional<std::size_t> Museum::find(std::string_view name) const
{
    for (std::size_t i = 0; i < subjects_.size(); ++i)
        if (subjects_[i]->name() == name) return i;
    return std::nullopt;
}

SceneState Museum::initialSceneState() const
{
    SceneState sceneState;
    for (const Subject* each : subjects_) sceneState.values.push_back(each->parameters().initial());
    sceneState.camera = hall_->bestView(sceneState.hall());
    return sceneState;
}

PictureQuality pictureQuality(const ParameterValues& hall)
{
    PictureQuality quality;
    if (const auto row = hall.table().find(supersamplesRow))
        quality.supersamples = static_cast<int>(std::get<double>(hall.row(*row)));
    if (const auto row = hall.table().find(resolutionScaleRow))
        quality.resolutionScale = std::get<double>(hall.row(*row));
    const auto antialiasing = hall.table().find(temporalAntialiasingRow);
    if (const auto row = hall.table().find(historyFramesRow);
        row && antialiasing && std::get<double>(hall.row(*antialiasing)) != 0)
        quality.historyFrames = static_cast<int>(std::get<double>(hall.row(*row)));
    return quality;
}

bool Museum::isInHall(std::size_t i) const
{
    return i != hallIndex && model_->place(exhibit(i).place());
}

glm::dmat4 Museum::worldFromExhibit(std::size_t i) const
{
    const Place* place = i == hallIndex ? nullptr : model_->place(exhibit(i).place());
    return place ? place->worldFromPlace : glm::dmat4(1);
}

render::Camera Museum::bestView(std::size_t i, const ParameterValues& values) const
{
    return subjects_[i]->bestView(values).transformed(worldFromExhibit(i));
}

glm::dvec3 Museum::walk(const glm::dvec3& from, const glm::dvec3& to) const
{
    return building_.walk(from, to);
}

glm::dvec3 Museum::walk(const Prepared& prepared, const glm::dvec3& from, const glm::dvec3& to) const
{
    return obstacles(prepared).walk(from, to);
}

Obstacles Museum::obstaclesWith(const ParameterValues& hall, const PreparedHall* prepared) const
{
    std::vector<Collider> all;
    for (const OwnObject& object : hall_->scene(hall, false, prepared).objects)
        all.insert(all.end(), object.colliders.begin(), object.colliders.end());
    if (all.empty()) return building_;
    all.insert(all.end(), model_->colliders().begin(), model_->colliders().end());
    return Obstacles(std::move(all));
}

Obstacles Museum::obstacles(const Prepared& prepared) const
{
    return obstaclesWith(prepared.sceneState.hall(), prepared.hall.get());
}

Obstacles Museum::obstacles(const SceneState& sceneState) const
{
    return obstaclesWith(sceneState.hall(), hall_->prepare(sceneState.hall(), *assets_).get());
}

std::vector<int> Museum::emptyPlaces() const
{
    std::vector<int> empty;
    for (const auto& [number, place] : model_->places())
        if (number != freePlinthPlace &&
            std::none_of(owned_.begin(), owned_.end(), [&, n = number](const auto& e) { return e->place() == n; }))
            empty.push_back(number);
    return empty;
}

}  // namespace vitrine
