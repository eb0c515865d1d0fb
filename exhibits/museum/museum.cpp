#include "exhibits/museum/museum.h"

#include "exhibits/framework/scene/continues_state.h"
#include "exhibits/hall/hall.h"
#include "exhibits/hall/hall_model.h"
#include "exhibits/museum/shown_pictures.h"

#include <algorithm>
#include <cassert>

namespace vitrine {
namespace {

std::vector<hall::ExhibitSlot> slotsOf(const std::vector<std::unique_ptr<Exhibit>>& exhibits)
{
    std::vector<hall::ExhibitSlot> made;
    for (const auto& e : exhibits)
        made.push_back({e->place(), std::string(e->title()), std::string(e->summary()), std::string(e->tryThis()),
                        capability<HasButton>(*e) != nullptr, capability<HasLocalLights>(*e) != nullptr});
    return made;
}

}  // namespace

Museum::Museum(std::vector<std::unique_ptr<Exhibit>> exhibits)
    : model_(std::make_shared<const hall::HallModel>()), owned_(std::move(exhibits)),
      hall_(std::make_unique<const hall::Hall>(model_, slotsOf(owned_))), subjects_{hall_.get()},
      assets_(std::make_unique<render::AssetStore>())
{
    offerPictures(owned_);
    for (const auto& exhibit : owned_) {
        exhibits_.push_back({subjects_.size(), *exhibit});
        subjects_.push_back(exhibit.get());
    }
    surroundings_ = std::make_unique<const MuseumSurroundings>(
        *model_, *hall_, exhibits_, *assets_, [this](const Prepared& prepared) { return sceneOf(prepared, false); });
}

Museum::~Museum() = default;

void Museum::startReading() const
{
    model_->surfaces().startReading();
}

const SceneObject& Museum::hall() const
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
    for (const SceneObject* each : subjects_) sceneState.values.push_back(each->parameters().initial());
    sceneState.camera = hall_->bestView(sceneState.hall());
    return sceneState;
}

PictureQuality pictureQuality(const ParameterValues& hall)
{
    PictureQuality quality;
    if (const auto row = hall.table().find(supersamplesParameter))
        quality.supersamples = static_cast<int>(std::get<double>(hall.row(*row)));
    if (const auto row = hall.table().find(resolutionScaleParameter))
        quality.resolutionScale = std::get<double>(hall.row(*row));
    const auto antialiasing = hall.table().find(temporalAntialiasingParameter);
    if (const auto row = hall.table().find(historyFramesParameter);
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
    const hall::Place* place = i == hallIndex ? nullptr : model_->place(exhibit(i).place());
    return place ? place->worldFromPlace : glm::dmat4(1);
}

render::Camera Museum::bestView(std::size_t i, const ParameterValues& values) const
{
    return subjects_[i]->bestView(values).transformed(worldFromExhibit(i));
}

std::vector<int> Museum::emptyPlaces() const
{
    std::vector<int> empty;
    for (const auto& [number, place] : model_->places())
        if (number != hall::freePlinthPlace &&
            std::none_of(owned_.begin(), owned_.end(), [&, n = number](const auto& e) { return e->place() == n; }))
            empty.push_back(number);
    return empty;
}

void noteDrawn(const Museum& museum, const render::FrameReport& report)
{
    for (const MuseumExhibit& each : museum.exhibits())
        if (const auto* continues = capability<ContinuesState>(each.exhibit)) continues->wasDrawn(report);
}

}  // namespace vitrine
