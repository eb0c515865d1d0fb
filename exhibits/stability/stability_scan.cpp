#include "exhibits/stability/stability_scan.h"

#include "exhibits/framework/table/random_values.h"
#include "exhibits/framework/table/value_text.h"
#include "exhibits/stability/poison.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>

namespace vitrine::stability {
namespace {

constexpr double farAway = 1e5;  ///< Meters; float32 positions there have steps of 8 mm.
constexpr glm::ivec2 plainSize{24, 16};
constexpr std::uint64_t sharedBy = 32;  ///< Number of neighboring seeds that share light and hall.

render::Camera randomCamera(const SceneObject& subject, const ParameterValues& values, RandomNumbers& random)
{
    render::Camera camera = subject.bestView(values);
    if (random.chance(0.4)) return camera;
    const render::Box box = subject.bounds(values);
    const double reach = std::clamp(glm::length(box.halfSize()), 1e-3, 1e3);
    switch (random.index(5)) {
    case 0:  // Inside.
        camera.eye = random.point(box.low, box.high);
        camera.target = camera.eye + random.direction();
        break;
    case 1: {  // On a face.
        camera.eye = random.point(box.low, box.high);
        const int axis = random.index(3);
        camera.eye[axis] = random.chance(0.5) ? box.low[axis] : box.high[axis];
        camera.target = box.center();
        break;
    }
    case 2:  // So far away that the exhibit is a point.
        camera.eye = box.center() + random.direction() * farAway;
        camera.target = box.center();
        camera.fovY = std::numbers::pi / 180;
        break;
    case 3:  // Straight above.
        camera.eye = box.center() + glm::dvec3(0, 2 * reach, 0);
        camera.target = box.center();
        break;
    default:  // Anywhere, with any field of view.
        camera.eye = box.center() + random.direction() * (reach * random.number(0.5, 5));
        camera.target = box.center() + random.direction() * (0.5 * reach);
        camera.fovY = random.number(1, 175) * std::numbers::pi / 180;
    }
    return camera;
}

double randomTime(RandomNumbers& random)
{
    const std::array<double, 8> hostile{
        0, 0, 1e6, 1e9, 1e6 + 1.0 / 3, -3.5, 1e300, std::numeric_limits<double>::quiet_NaN()};
    return random.chance(0.5) ? hostile[static_cast<std::size_t>(random.index(static_cast<int>(hostile.size())))]
                              : random.number(0, 60);
}

glm::ivec2 randomSize(RandomNumbers& random)
{
    const std::array<glm::ivec2, 6> odd{glm::ivec2(1, 1),  glm::ivec2(3, 2),  glm::ivec2(17, 5),
                                        glm::ivec2(1, 31), glm::ivec2(33, 1), glm::ivec2(7, 9)};
    return random.chance(0.3) ? odd[static_cast<std::size_t>(random.index(static_cast<int>(odd.size())))] : plainSize;
}

/// Returns a random transform of the exhibit, in addition to its own place.
glm::dmat4 randomPlace(RandomNumbers& random)
{
    if (random.chance(0.75)) return glm::dmat4(1);
    switch (random.index(4)) {
    case 0: return glm::translate(glm::dmat4(1), random.direction() * farAway);
    case 1: return glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
    case 2: return glm::scale(glm::dmat4(1), glm::dvec3(random.chance(0.5) ? 1e3 : 1e-3));
    default:
        return glm::scale(glm::rotate(glm::dmat4(1), random.number(0, 6), random.direction()),
                          random.point(glm::dvec3(0.2), glm::dvec3(3)));
    }
}

/// Returns the camera transformed from exhibit space to the space in which the frame is drawn.
render::Camera placed(const Museum& museum, const ScanCase& c, const render::Camera& camera)
{
    if (c.exhibit == hallIndex) return camera;
    glm::dmat4 worldFromExhibit = c.frame.exhibitTransform;
    if (!c.frame.alone) worldFromExhibit = museum.worldFromExhibit(c.exhibit) * worldFromExhibit;
    return camera.transformed(worldFromExhibit);
}

/// Returns initial values, in light that is cheap to capture.
SceneState plainSceneState(const Museum& museum)
{
    SceneState sceneState = museum.initialSceneState();
    sceneState.hall() = cheapestValues(museum.hall().parameters());
    return sceneState;
}

/// Returns random light, in which maps and captures are small except sometimes.
ParameterValues randomLight(const Museum& museum, RandomNumbers& random)
{
    const Parameters& table = museum.hall().parameters();
    const ParameterValues cheapest = cheapestValues(table);
    ParameterValues values = randomValues(table, random);
    if (random.chance(0.03)) return values;
    for (std::size_t i = 0; i < table.rows().size(); ++i)
        if (table.rows()[i].kind == Kind::count) values.setParameter(i, cheapest.row(i));
    return values;
}

/// Returns a setting in the form of `--set`: name and value.
std::string settingText(const ParameterValues& values, std::size_t row)
{
    return std::string(values.rows()[row].name) + ' ' + formatValue(values.rows()[row], values.row(row));
}

}  // namespace

ScanCase scanCase(const Museum& museum, std::size_t exhibit, std::uint64_t seed)
{
    RandomNumbers random(seed);
    const SceneObject& subject = museum.subject(exhibit);
    ScanCase c{exhibit, plainSceneState(museum), {}};
    // Changing light, and a hall that comes and goes, have to be captured again. So neighboring seeds share theirs.
    RandomNumbers shared(seed / sharedBy);
    const bool inHall = exhibit == hallIndex || shared.chance(0.15);
    if (exhibit != hallIndex && shared.chance(0.5)) c.sceneState.hall() = randomLight(museum, shared);
    if (exhibit == hallIndex)
        c.sceneState.hall() = randomLight(museum, random);
    else
        c.sceneState.values[exhibit] = randomValues(subject.parameters(), random, random.chance(0.5) ? 0.5 : 1);
    if (exhibit != hallIndex) {
        c.frame.subject = exhibit;
        if (!inHall) c.frame.alone = exhibit;
        c.frame.exhibitTransform = randomPlace(random);
        c.frame.transparent = c.frame.alone && random.chance(0.3);
    }
    c.frame.camera = placed(museum, c, randomCamera(subject, c.sceneState.values[exhibit], random));
    c.frame.raster.size = randomSize(random);
    c.frame.time = randomTime(random);
    c.frame.seed = static_cast<std::uint32_t>(random.index(1 << 30));
    // Frames are as for files or as in the window. Each further kind would compile all programs again.
    const bool forFile = random.chance(0.6);
    c.frame.channels = {forFile, forFile};
    c.frame.averageIn = forFile ? AverageIn::radiance : AverageIn::display;
    // Until a program is built, its pass is drawn by that of other settings, which are not those to be checked.
    c.frame.finished = true;
    return c;
}

std::string faultOf(const Museum& museum, render::RenderBackend& backend, const ScanCase& c)
{
    try {
        const render::FramePlan plan =
            museum.plan(museum.prepare(c.sceneState, c.frame), c.frame, backend.persistentState());
        (void)backend.draw(poisoned(plan, spreadingPoison()));
        return faultOfImages(plan, backend, c.frame.channels);
    } catch (const std::exception& error) {
        return std::string("failed: ") + error.what();
    }
}

std::vector<std::string> causesOf(const Museum& museum, render::RenderBackend& backend, ScanCase c)
{
    std::vector<std::string> causes;
    const SceneObject& subject = museum.subject(c.exhibit);
    // Resets each setting in turn. If the fault disappears, the setting is a cause and keeps its value.
    const auto tryPlain = [&](const std::string& name, const std::function<void(ScanCase&)>& setBack) {
        ScanCase plain = c;
        setBack(plain);
        if (faultOf(museum, backend, plain).empty())
            causes.push_back(name);
        else
            c = std::move(plain);
    };
    if (c.frame.raster.size != plainSize)
        tryPlain("size " + std::to_string(c.frame.raster.size.x) + 'x' + std::to_string(c.frame.raster.size.y),
                 [](ScanCase& s) { s.frame.raster.size = plainSize; });
    if (c.frame.time != 0)
        tryPlain("time " + std::to_string(c.frame.time) + " s", [](ScanCase& s) { s.frame.time = 0; });
    if (c.frame.exhibitTransform != glm::dmat4(1)) {
        tryPlain("an exhibit that is moved, turned or scaled", [&](ScanCase& s) {
            s.frame.exhibitTransform = glm::dmat4(1);
            s.frame.camera = placed(museum, s, subject.bestView(s.sceneState.values[s.exhibit]));
        });
    }
    tryPlain("the camera", [&](ScanCase& s) {
        s.frame.camera = placed(museum, s, subject.bestView(s.sceneState.values[s.exhibit]));
    });
    tryPlain("the channels", [&](ScanCase& s) { s.frame.channels = {}; });
    const SceneState plain = plainSceneState(museum);
    for (const std::size_t table : std::set<std::size_t>{hallIndex, c.exhibit}) {
        for (std::size_t row = 0; row < c.sceneState.values[table].rows().size(); ++row) {
            const Value& value = plain.values[table].row(row);
            if (c.sceneState.values[table].row(row) == value) continue;
            const std::string name =
                std::string(museum.subject(table).name()) + '.' + settingText(c.sceneState.values[table], row);
            tryPlain(name, [&](ScanCase& s) { s.sceneState.values[table].setParameter(row, value); });
        }
    }
    return causes;
}

}  // namespace vitrine::stability
