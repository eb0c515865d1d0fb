#include "exhibits/hall/sun_transfer.h"

#include "exhibits/hall/baked_picture.h"
#include "render/failure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace vitrine::hall {
namespace {

using render::Json;

constexpr double degreesToRadians = std::numbers::pi / 180;

void demand(bool holds, const char* what)
{
    if (!holds)
        throw Failure(ErrorKind::file,
                      std::string("assets/models/hall_bounce.json: ") + what +
                          "; reinstall the program, or make it anew with assets/models/hall_transfer.py.");
}

glm::dvec3 vectorOf(const Json& numbers)
{
    return {numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>()};
}

std::future<BakedPicture> pictureOf(const Json& row)
{
    return startReadingBaked(row.at("file").get<std::string>());
}

BakedPicture checked(std::future<BakedPicture>& reading, int channels)
{
    BakedPicture picture = reading.get();
    demand(picture->channels == channels && !picture->bytes.empty(), "a picture has other channels");
    return picture;
}

}  // namespace

SunTransfer::SunTransfer(const Json& table)
{
    for (const Json& degrees : table.at("elevations")) elevations_.push_back(degrees.get<double>() * degreesToRadians);
    demand(elevations_.size() > 1 && std::is_sorted(elevations_.begin(), elevations_.end()),
           "its elevations do not rise");
    azimuths_ = static_cast<std::size_t>(std::lround(360 / table.at("azimuthStep").get<double>()));
    const Json& air = table.at("air");
    std::future<BakedPicture> picture = pictureOf(air), suns = pictureOf(table.at("suns")),
                              surfaces = pictureOf(table.at("surfaces"));
    suns_ = checked(suns, 1);
    sunScale_ = table.at("suns").at("scale").get<double>();
    surfaces_ = checked(surfaces, 3);
    surfaceScale_ = table.at("surfaces").at("scale").get<double>();

    picture_ = checked(picture, 1);
    scales_ = air.at("scales").get<std::vector<double>>();
    grid_ = {{vectorOf(air.at("low")), vectorOf(air.at("high"))}, glm::ivec3(vectorOf(air.at("size")))};
    demand(scales_.size() > 6 && static_cast<std::size_t>(picture_->height) == scales_.size() &&
               picture_->width == 6 * grid_.size.x * grid_.size.y * grid_.size.z,
           "the light in the air does not fit its points");
    demand(azimuths_ > 0 && static_cast<std::size_t>(suns_->height) == elevations_.size() * azimuths_ &&
               static_cast<std::size_t>(suns_->width) == sourceCount(),
           "the light of its sources does not fit its directions");
}

std::vector<SunTransfer::Source> SunTransfer::at(double azimuth, double elevation) const
{
    const double e = std::clamp(elevation, elevations_.front(), elevations_.back());
    const auto above = std::upper_bound(elevations_.begin() + 1, elevations_.end() - 1, e) - elevations_.begin();
    const auto row = static_cast<std::size_t>(above) - 1;
    const double t = (e - elevations_[row]) / (elevations_[row + 1] - elevations_[row]);

    const double turns = azimuth / (2 * std::numbers::pi) + 0.5;
    const double column = (turns - std::floor(turns)) * static_cast<double>(azimuths_);
    const auto left = static_cast<std::size_t>(column);
    const double s = column - static_cast<double>(left);
    std::map<std::size_t, double> light;
    for (const bool up : {false, true})
        for (const bool right : {false, true}) {
            const double weight = (up ? t : 1 - t) * (right ? s : 1 - s);
            const std::size_t node = (row + (up ? 1 : 0)) * azimuths_ + (left + (right ? 1 : 0)) % azimuths_;
            for (std::size_t i = 0; i < sourceCount() && weight > 0; ++i)
                if (const double code = suns_->bytes[node * sourceCount() + i] / 255.0; code > 0)
                    light[i] += weight * code * code * sunScale_;
        }
    std::vector<Source> sources;
    for (const auto& [i, value] : light) sources.push_back({i, value});
    return sources;
}

double SunTransfer::most(const std::vector<Source>& sources) const
{
    double sum = 0;
    for (const Source& source : sources) sum += source.light * scales_[source.row];
    return sum;
}

}  // namespace vitrine::hall
