#include "exhibits/recording/tour.h"

#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/files/state_folder.h"
#include "exhibits/framework/table/preset_values.h"
#include "exhibits/recording/way_around.h"
#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/version.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace vitrine::recording {
namespace {

using render::Json;
using render::JsonDocument;

constexpr const char* tourFormat = "vitrine-tour";

const Json& tourKey(const JsonDocument& document, const Json& object, std::string_view place, const char* key)
{
    if (!object.contains(key))
        throw document.failure(std::string(place), "the key \"" + std::string(key) + "\" is missing; add it.");
    return object[key];
}

std::string tourWords(const JsonDocument& document, const Json& value, const std::string& place)
{
    if (!value.is_string()) throw document.failure(place, "this must be text; correct it there.");
    return value.get<std::string>();
}

void noteUnknownKeys(const Json& object, const std::string& place, const std::vector<std::string_view>& known,
                     std::vector<std::string>& notes)
{
    for (const auto& [key, value] : object.items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            notes.push_back(place + key + " is not known here; it is left out");
}

void checkTourHeader(const JsonDocument& document)
{
    const Json& root = document.root();
    if (!root.is_object()) throw document.failure({}, "a tour is a JSON object; choose a tour of Vitrine.");
    const std::string format = tourWords(document, tourKey(document, root, {}, "format"), "format");
    if (format != tourFormat)
        throw document.failure("format", "\"" + format + "\" is not a tour; choose another file.");
    const Json& version = tourKey(document, root, {}, "version");
    if (!version.is_number_integer() || version.get<double>() < 1)
        throw document.failure("version", "this must be a whole number from 1; correct it there.");
    if (version.get<double>() > tourVersion)
        throw document.failure("version", "the tour is of a newer Vitrine (version " + version.dump() +
                                              ", this one reads " + std::to_string(tourVersion) + "); update Vitrine.");
}

Bookmark readBookmark(const JsonDocument& document, const Json& entry, std::size_t i, std::vector<std::string>& notes)
{
    const std::string place = "bookmarks[" + std::to_string(i) + "]";
    if (!entry.is_object()) throw document.failure(place, "this must be an object; correct it there.");
    Bookmark bookmark{"Bookmark " + std::to_string(i + 1), {}};
    if (entry.contains("name")) bookmark.name = tourWords(document, entry["name"], place + ".name");
    const Json& camera = tourKey(document, entry, place, "camera");
    const JsonPlace cameraPlace{document, place + ".camera"};
    for (const char* key : {"eye", "target"})
        if (camera.is_object()) static_cast<void>(tourKey(document, camera, cameraPlace.path, key));
    bookmark.camera = cameraFromJson(camera, cameraPlace, notes);
    noteUnknownKeys(entry, place + '.', {"name", "camera"}, notes);
    return bookmark;
}

/// Returns cameras along a walked way, looking ahead.
std::vector<render::Camera> walked(const std::vector<glm::dvec3>& way, const render::Camera& from,
                                   const render::Camera& to)
{
    std::vector<render::Camera> stops;
    for (std::size_t i = 0; i < way.size(); ++i) {
        render::Camera stop = from;
        const double share = static_cast<double>(i + 1) / static_cast<double>(way.size() + 1);
        stop.eye = way[i];
        glm::dvec3 ahead = (i + 1 < way.size() ? way[i + 1] : to.eye) - (i > 0 ? way[i - 1] : from.eye);
        ahead.y = 0;
        if (glm::length(ahead) < 1e-6) ahead = glm::dvec3(0, 0, -1);
        stop.target = stop.eye + 2.0 * glm::normalize(ahead);
        stop.fovY = from.fovY + share * (to.fovY - from.fovY);
        stops.push_back(stop);
    }
    return stops;
}

/// Stops between two bookmarks, and the number of attempts.
struct Leg {
    std::vector<render::Camera> between;
    int tries = 0;
};

/// Strides of the way for each attempt, meters: the shorter, the closer the spline follows it.
constexpr std::array<double, 4> strides = {3, 1.2, 0.6, 0.3};

CameraPath pathThrough(const Tour& tour, const std::vector<Leg>& legs, std::vector<std::size_t>& legOfStop)
{
    std::vector<render::Camera> stops;
    legOfStop.clear();
    for (std::size_t i = 0; i < tour.bookmarks.size(); ++i) {
        stops.push_back(tour.bookmarks[i].camera);
        legOfStop.push_back(i);
        for (const render::Camera& stop : i < legs.size() ? legs[i].between : std::vector<render::Camera>()) {
            stops.push_back(stop);
            legOfStop.push_back(i);
        }
    }
    return {stops, tour.closed};
}

}  // namespace

std::filesystem::path bookmarksFile()
{
    return stateFolder() / "bookmarks.json";
}

Tour readTour(const std::filesystem::path& file)
{
    return parseTour(render::readFile(file, presetLimits.bytes), file.string());
}

Tour parseTour(std::string text, std::string fileName)
{
    const JsonDocument document = render::parseJson(std::move(text), std::move(fileName), presetLimits);
    checkTourHeader(document);
    const Json& root = document.root();
    Tour tour;
    if (root.contains("name")) tour.name = tourWords(document, root["name"], "name");
    if (root.contains("closed")) {
        if (!root["closed"].is_boolean())
            throw document.failure("closed", "this must be true or false; correct it there.");
        tour.closed = root["closed"].get<bool>();
    }
    if (root.contains("pace")) {
        const std::string pace = tourWords(document, root["pace"], "pace");
        if (pace != "constant" && pace != "eased")
            throw document.failure("pace", "\"" + pace + "\" is not a pace; write constant or eased.");
        tour.pace = pace == "eased" ? Pace::eased : Pace::constant;
    }
    const Json& bookmarks = tourKey(document, root, {}, "bookmarks");
    if (!bookmarks.is_array() || bookmarks.empty())
        throw document.failure("bookmarks", "this must be an array of at least one bookmark; correct it there.");
    for (std::size_t i = 0; i < bookmarks.size(); ++i)
        tour.bookmarks.push_back(readBookmark(document, bookmarks[i], i, tour.notes));
    noteUnknownKeys(root, {}, {"format", "version", "app", "name", "closed", "pace", "bookmarks"}, tour.notes);
    return tour;
}

std::string tourText(const Tour& tour)
{
    Json root = Json::object();
    root["format"] = tourFormat;
    root["version"] = tourVersion;
    root["app"] = render::programVersion();
    root["name"] = tour.name;
    root["closed"] = tour.closed;
    root["pace"] = tour.pace == Pace::eased ? "eased" : "constant";
    root["bookmarks"] = Json::array();
    for (const Bookmark& bookmark : tour.bookmarks) {
        Json entry = Json::object();
        entry["name"] = bookmark.name;
        entry["camera"] = jsonFromCamera(bookmark.camera, Json::object());
        root["bookmarks"].push_back(entry);
    }
    return render::writeJson(root);
}

double firstCollision(const Obstacles& obstacles, const CameraMotion& motion)
{
    // The position of the eye decides, and it moves little between two times.
    constexpr int steps = 2000;
    glm::dvec3 before = motion(0).eye;
    for (int i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        const glm::dvec3 next = motion(part).eye;
        if (!obstacles.cameraPasses(before, next)) return part;
        before = next;
    }
    return -1;
}

CameraPath tourPath(const Obstacles& obstacles, const Tour& tour)
{
    for (const Bookmark& bookmark : tour.bookmarks)
        if (!obstacles.cameraPasses(bookmark.camera.eye, bookmark.camera.eye))
            throw Failure(ErrorKind::file,
                          "The bookmark \"" + bookmark.name + "\" is inside a wall or an object; move it.");
    const std::size_t count = tour.bookmarks.size();
    std::vector<Leg> legs(tour.closed ? count : count - 1);
    // If a user cannot walk straight, a camera would fly over plinths and through what stands on them.
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const render::Camera &from = tour.bookmarks[i].camera, &to = tour.bookmarks[(i + 1) % count].camera;
        if (!obstacles.walks(from.eye, to.eye))
            legs[i].between = walked(wayAround(obstacles, from.eye, to.eye, strides[0]), from, to);
    }
    std::vector<std::size_t> legOfStop;
    for (;;) {
        CameraPath path = pathThrough(tour, legs, legOfStop);
        const double hit = firstCollision(obstacles, [&](double part) { return path.at(part); });
        if (hit < 0) return path;
        const std::size_t at = std::min(legOfStop[path.stopBefore(hit)], legs.size() - 1);
        Leg& leg = legs[at];
        const Bookmark& from = tour.bookmarks[at];
        const Bookmark& to = tour.bookmarks[(at + 1) % count];
        const std::vector<glm::dvec3> way =
            leg.tries < static_cast<int>(strides.size())
                ? wayAround(obstacles, from.camera.eye, to.camera.eye, strides.at(static_cast<std::size_t>(leg.tries)))
                : std::vector<glm::dvec3>();
        ++leg.tries;
        if (way.empty())
            throw Failure(ErrorKind::file, "No way around walls and objects was found from the bookmark \"" +
                                               from.name + "\" to \"" + to.name + "\"; put another one between them.");
        leg.between = walked(way, from.camera, to.camera);
    }
}

Tour museumTour(const Museum& museum, const SceneState& sceneState)
{
    const Obstacles obstacles = museum.surroundings().obstacles(sceneState);
    Tour tour{"The museum", {}, true, Pace::constant};
    tour.bookmarks.push_back({std::string(museum.hall().title()), museum.bestView(hallIndex, sceneState.hall())});
    const auto add = [&](const std::string& name, const render::Camera& next) {
        if (!obstacles.cameraPasses(next.eye, next.eye)) return;
        // On the way, the camera steps back to the middle of the hall and turns to the next view, since walls are dull
        // when close.
        const render::Camera& before = tour.bookmarks.back().camera;
        const glm::dvec3 half = (before.eye + next.eye) / 2.0;
        const glm::dvec3 middle(half.x / 4, 1.65, half.z);
        if (obstacles.walks(middle, middle)) tour.bookmarks.push_back({"To " + name, {middle, next.target, next.fovY}});
        tour.bookmarks.push_back({name, next});
    };
    for (const MuseumExhibit& each : museum.exhibits())
        add(std::string(each.exhibit.title()), museum.bestView(each.index, sceneState.values[each.index]));
    return tour;
}

}  // namespace vitrine::recording
