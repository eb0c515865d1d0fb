#include "exhibits/museum/museum.h"

#include "exhibits/hall/hall.h"
#include "exhibits/hall/hall_model.h"
#include "exhibits/hall/walk.h"

#include <algorithm>

namespace vitrine {
Museum::Museum(std::vector<std::unique_ptr<Exhibit>> guests)
    : model_(std::make_shared<const HallModel>()), assets_(std::make_unique<render::AssetStore>())
{
    auto hall = std::make_unique<Hall>(model_);
    std::vector<Guest> plaques;
    for (const auto& guest : guests)
        plaques.push_back({guest->place(), std::string(guest->title()), std::string(guest->summary()),
                           std::string(guest->tryThis()), std::string(guest->buttonText())});
    hall->setGuests(std::move(plaques));
    hall_ = hall.get();
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
    if (const auto row = hall.table().find(supersamplesRow))
        quality.supersamples = static_cast<int>(std::get<double>(hall.row(*row)));
    if (const auto row = hall.table().find(resolutionScaleRow))
        quality.resolutionScale = std::get<double>(hall.row(*row));
    return quality;
}

glm::dmat4 Museum::worldFromExhibit(std::size_t i) const
{
    const Place* place = model_->place(exhibits_[i]->place());
    return place ? place->worldFromPlace : glm::dmat4(1);
}

render::Camera Museum::bestView(std::size_t i, const ParameterValues& values) const
{
    const glm::dmat4 world = worldFromExhibit(i);
    render::Camera camera = exhibits_[i]->bestView(values);
    camera.eye = glm::dvec3(world * glm::dvec4(camera.eye, 1));
    camera.target = glm::dvec3(world * glm::dvec4(camera.target, 1));
    return camera;
}

glm::dvec3 Museum::walk(const glm::dvec3& from, const glm::dvec3& to) const
{
    return walkAround(model_->colliders(), from, to);
}

std::vector<int> Museum::emptyPlaces() const
{
    std::vector<int> empty;
    for (int number = 1; number <= 9; ++number)
        if (std::none_of(exhibits_.begin() + 1, exhibits_.end(), [&](const auto& e) { return e->place() == number; }))
            empty.push_back(number);
    return empty;
}

}  // namespace vitrine
