#include "exhibits/framework/files/picture_record.h"

#include "render/text/joined.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vitrine {
namespace {

using render::Json;

constexpr std::array<std::string_view, 11> keysOfRecord{
    "size", "samples", "time", "seed", "alone", "transparent", "channels", "transform", "camera", "before", "language"};
constexpr double mostPixelsOnASide = 1e6;
constexpr double mostSamplesPerPixel = 4096;

/// A channel beyond color, with its name in files.
struct NamedChannel {
    std::string_view name;
    bool& (*of)(PictureRecord&);
};
constexpr std::array<NamedChannel, 7> namedChannels{
    {{"depth", [](PictureRecord& r) -> bool& { return r.depth; }},
     {"normal", [](PictureRecord& r) -> bool& { return r.channels.normal; }},
     {"evaluations", [](PictureRecord& r) -> bool& { return r.channels.evaluations; }},
     {"albedo", [](PictureRecord& r) -> bool& { return r.channels.albedo; }},
     {"position", [](PictureRecord& r) -> bool& { return r.position; }},
     {"object", [](PictureRecord& r) -> bool& { return r.objects; }},
     {"motion", [](PictureRecord& r) -> bool& { return r.motion; }}}};

double wholeNumber(const Json& json, const JsonPlace& place, double low, double high)
{
    if (!json.is_number_integer() || json.get<double>() < low || json.get<double>() > high)
        throw place.failure(message("this must be a whole number from {1} to {2}; correct it there.",
                                    static_cast<std::int64_t>(low), static_cast<std::int64_t>(high)));
    return json.get<double>();
}

bool truth(const Json& json, const JsonPlace& place)
{
    if (!json.is_boolean()) throw place.failure(message("this must be true or false; correct it there."));
    return json.get<bool>();
}

bool isNumbers(const Json& json, std::size_t count)
{
    return json.is_array() && json.size() == count &&
           std::all_of(json.begin(), json.end(), [](const Json& x) { return x.is_number(); });
}

glm::ivec2 sizeFrom(const Json& json, const JsonPlace& place)
{
    if (!isNumbers(json, 2)) throw place.failure(message("this must be an array of two numbers; correct it there."));
    return {static_cast<int>(wholeNumber(json[0], place, 1, mostPixelsOnASide)),
            static_cast<int>(wholeNumber(json[1], place, 1, mostPixelsOnASide))};
}

/// Returns the rows of the matrix's upper left 3 x 3.
Json matrixRows(const glm::dmat4& m)
{
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row) rows.push_back(Json::array({m[0][row], m[1][row], m[2][row]}));
    return rows;
}

glm::dmat4 transformFrom(const Json& json, const JsonPlace& place)
{
    glm::dmat4 m(1);
    const bool good = json.is_array() && json.size() == 3 &&
                      std::all_of(json.begin(), json.end(), [](const Json& row) { return isNumbers(row, 3); });
    if (!good) throw place.failure(message("this must be three arrays of three numbers; correct it there."));
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            m[column][row] = json[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)].get<double>();
    const double volume = std::abs(glm::determinant(m));
    if (!(volume > 0) || !std::isfinite(volume))
        throw place.failure(message("this matrix leaves nothing to draw; correct it there."));
    return m;
}

void readChannels(const Json& json, const JsonPlace& place, PictureRecord& record)
{
    if (!json.is_array()) throw place.failure(message("this must be an array of names; correct it there."));
    for (const Json& name : json) {
        bool* known = name.is_string() ? channelOf(record, name.get<std::string>()) : nullptr;
        if (!known) throw place.failure(message("give {1}; correct it there.", alternatives(channelNames())));
        *known = true;
    }
}

FrameBefore frameBeforeFrom(const Json& json, const JsonPlace& place, std::vector<std::string>& notes)
{
    if (!json.is_object() || !json.contains("seconds") || !json.contains("camera"))
        throw place.failure(message("this must be an object with seconds and camera; correct it there."));
    const Json& seconds = json["seconds"];
    if (!seconds.is_number() || !(seconds.get<double>() > 0))
        throw place.inside("seconds").failure(message("this must be a number of seconds above 0; correct it there."));
    return {seconds.get<double>(), cameraFromJson(json["camera"], place.inside("camera"), notes)};
}

}  // namespace

std::vector<std::string_view> channelNames()
{
    std::vector<std::string_view> names;
    for (const NamedChannel& channel : namedChannels) names.push_back(channel.name);
    return names;
}

bool* channelOf(PictureRecord& record, std::string_view name)
{
    for (const NamedChannel& channel : namedChannels)
        if (channel.name == name) return &channel.of(record);
    return nullptr;
}

bool PictureRecord::isOfTheHall() const
{
    return !alone && !transparent && exhibitTransform == glm::dmat4(1);
}

Json jsonFromPictureRecord(const PictureRecord& record)
{
    Json json = Json::object();
    json["size"] = Json::array({record.size.x, record.size.y});
    json["samples"] = record.samples;
    json["time"] = record.time;
    json["seed"] = record.seed;
    if (record.alone) json["alone"] = true;
    if (record.transparent) json["transparent"] = true;
    Json channels = Json::array();
    PictureRecord read = record;
    for (const NamedChannel& channel : namedChannels)
        if (channel.of(read)) channels.push_back(channel.name);
    if (!channels.empty()) json["channels"] = std::move(channels);
    if (record.exhibitTransform != glm::dmat4(1)) json["transform"] = matrixRows(record.exhibitTransform);
    if (record.camera) json["camera"] = jsonFromCamera(*record.camera, Json::object());
    if (record.before)
        json["before"] = {{"seconds", record.before->seconds},
                          {"camera", jsonFromCamera(record.before->camera, Json::object())}};
    if (record.language != "en") json["language"] = record.language;
    return json;
}

PictureRecord pictureRecordFromJson(const Json& json, const JsonPlace& place, std::vector<std::string>& notes)
{
    if (!json.is_object()) throw place.failure(message("this must be an object; correct it there."));
    PictureRecord record;
    const auto read = [&](const char* key, const auto& take) {
        if (json.contains(key)) take(json[key], place.inside(key));
    };
    using At = const JsonPlace&;
    read("size", [&](const Json& x, At at) { record.size = sizeFrom(x, at); });
    read("samples",
         [&](const Json& x, At at) { record.samples = static_cast<int>(wholeNumber(x, at, 1, mostSamplesPerPixel)); });
    read("time", [&](const Json& x, At at) {
        if (!x.is_number()) throw at.failure(message("this must be a number of seconds; correct it there."));
        record.time = x.get<double>();
    });
    read("seed", [&](const Json& x, At at) {
        record.seed = static_cast<std::uint32_t>(wholeNumber(x, at, 0, std::numeric_limits<std::uint32_t>::max()));
    });
    read("alone", [&](const Json& x, At at) { record.alone = truth(x, at); });
    read("transparent", [&](const Json& x, At at) { record.transparent = truth(x, at); });
    read("channels", [&](const Json& x, At at) { readChannels(x, at, record); });
    read("transform", [&](const Json& x, At at) { record.exhibitTransform = transformFrom(x, at); });
    read("camera", [&](const Json& x, At at) { record.camera = cameraFromJson(x, at, notes); });
    read("before", [&](const Json& x, At at) { record.before = frameBeforeFrom(x, at, notes); });
    read("language", [&](const Json& x, At at) {
        if (!x.is_string()) throw at.failure(message("this must be the code of a language; correct it there."));
        record.language = x.get<std::string>();
    });
    for (const auto& [key, value] : json.items())
        if (std::find(keysOfRecord.begin(), keysOfRecord.end(), key) == keysOfRecord.end())
            notes.push_back("picture." + key + " is not known here; it is left out");
    return record;
}

}  // namespace vitrine
