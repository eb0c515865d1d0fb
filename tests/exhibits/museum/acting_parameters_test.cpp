// Every parameter of every exhibit changes the picture: at initial values, or in the setting in which its table says
// that it has an effect.

#include "exhibits/framework/table/acting.h"
#include "render/files/read_file.h"
#include "tests/exhibits/pixel_art/moved_model.h"
#include "tests/support/gallery.h"
#include "tests/support/museum_on_paper.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <functional>
#include <set>

namespace vitrine {
namespace {

using namespace test;

/// Sets the parameters of the condition, and those that these depend on, so that it holds. Of several ways, the first
/// is taken.
using FileFor = std::function<std::string(const ParameterInfo&)>;
void satisfy(ParameterValues& values, const Condition& condition, const FileFor& fileFor)
{
    if (condition.test == Condition::Test::all || condition.test == Condition::Test::any) {
        for (const Condition& part : condition.parts) {
            satisfy(values, part, fileFor);
            if (condition.test == Condition::Test::any) return;
        }
        return;
    }
    const std::size_t row = values.table().find(condition.row).value();
    const ParameterInfo& info = values.table().rows()[row];
    if (info.actsWhen) satisfy(values, *info.actsWhen, fileFor);
    switch (condition.test) {
    case Condition::Test::among: values.setParameter(row, condition.values.front()); break;
    case Condition::Test::differs: {
        double other = info.range.low;
        while (std::find(condition.values.begin(), condition.values.end(), other) != condition.values.end()) ++other;
        values.setParameter(row, other);
        break;
    }
    case Condition::Test::above:
        if (!(std::get<double>(values.row(row)) > condition.values.front()))
            values.setParameter(row, info.range.softHigh);
        break;
    case Condition::Test::given: values.setParameter(row, fileFor(info)); break;
    case Condition::Test::all:
    case Condition::Test::any: break;
    }
}

/// Returns other values of a parameter, as far from the present one as its slider allows.
std::vector<Value> others(const ParameterInfo& parameter, const Value& now, const std::string& file)
{
    std::vector<Value> values;
    switch (parameter.kind) {
    case Kind::real:
    case Kind::count: values = {parameter.range.softHigh, parameter.range.softLow}; break;
    case Kind::toggle:
    case Kind::choice:
        for (double x = parameter.range.low; x <= parameter.range.high; ++x) values.emplace_back(x);
        break;
    case Kind::color: values = {glm::dvec3(0.1, 0.8, 0.9), glm::dvec3(0.9, 0.1, 0.2)}; break;
    case Kind::direction: values = {glm::dvec3(0.6, 0.64, 0.48), glm::dvec3(-0.6, 0.0, 0.8)}; break;
    case Kind::file: values = {file}; break;
    case Kind::text: values = {render::readFile(file, 1U << 20U)}; break;
    }
    std::erase(values, now);
    return values;
}

/// Camera, time and settings of a picture.
struct Situation {
    ParameterValues values;
    render::Camera camera;  ///< Camera in the world.
    double time = 0.7;      ///< Time in seconds.
    double sincePressed = std::numeric_limits<double>::infinity();
    bool alone = false;
    bool inMotion = false;  ///< The camera has just turned to it.
};

/// Returns a camera in front of the free plinth, where the visitor's object stands.
render::Camera beforeThePlinth()
{
    const glm::dmat4 world = test::building().place(hall::freePlinthPlace)->worldFromPlace;
    return {glm::dvec3(world * glm::dvec4(0, 1.2, 1.6, 1)), glm::dvec3(world * glm::dvec4(0, 0.9, 0, 1)), 0.9};
}

std::vector<Situation> situationsOf(std::size_t exhibit, const ParameterValues& start)
{
    const Museum& museum = gallery().museum;
    const SceneObject& shown = museum.subject(exhibit);
    std::vector<Situation> all{{start, museum.bestView(exhibit, start)}};
    Situation later = all.front();
    later.time = 11.3;
    Situation pressed = all.front();
    pressed.sincePressed = 0.5;
    Situation near = all.front();
    near.camera.eye = near.camera.target + (near.camera.eye - near.camera.target) / 3.0;
    all.insert(all.end(), {later, pressed, near});
    if (exhibit == hallIndex) {
        all.push_back({start, beforeThePlinth()});
        Situation turning = all.front();
        turning.inMotion = true;
        all.push_back(turning);
        Situation night = all.front();
        night.values.set(hallTable().sunBy, hall::SunBy::hour);
        night.values.set(hallTable().timeOfDay, 21.0);
        all.push_back(night);
    }
    const glm::dmat4 world = museum.worldFromExhibit(exhibit);
    for (const StudyView& view : shown.studyViews(start)) {
        if (exhibit != hallIndex) all.push_back({view.values, view.camera, view.time, pressed.sincePressed, true});
        all.push_back({view.values, view.camera.transformed(world), view.time, pressed.sincePressed, false});
    }
    return all;
}

/// Returns hall values with small maps and without supersampling, for fast pictures.
ParameterValues cheap(ParameterValues hall)
{
    useSmallMaps(hall, 512);
    hall.set(hallTable().supersamples, 1);
    return hall;
}

class ActingParameters : public GlTest {
protected:
    /// Takes a picture like the window, but small.
    Picture take(std::size_t exhibit, const ParameterValues& values, const Situation& situation)
    {
        const Museum& museum = gallery().museum;
        Shot shot;
        shot.sceneState = museum.initialSceneState();
        if (exhibit != hallIndex) shot.hall() = cheap(shot.hall());
        shot.sceneState.values[exhibit] = values;
        shot.sceneState = museum.readTables(shot.sceneState).sceneState;
        const PictureQuality quality = pictureQuality(shot.hall());
        FrameRequest& frame = shot.request.frame;
        shot.request.samples = quality.supersamples;
        frame.raster.size = glm::max(glm::ivec2(glm::dvec2(96, 60) * quality.resolutionScale), glm::ivec2(1));
        frame.transparent = false;
        frame.alone = situation.alone ? std::optional<std::size_t>(exhibit) : std::nullopt;
        frame.subject = std::nullopt;
        frame.averageIn = AverageIn::display;
        frame.camera = situation.camera;
        frame.time = situation.time;
        if (situation.inMotion) {
            render::Camera before = situation.camera;
            for (int i = 0; i < 3; ++i) {
                before.target.x += 0.02;
                shot.request.motion.insert(shot.request.motion.begin(), {before, situation.time});
            }
        }
        frame.sincePressed.assign(museum.subjects().size(), situation.sincePressed);
        return shot.take();
    }

    /// Returns a picture or a model in place of the user's file.
    std::string fileFor(const Parameters& table, const ParameterInfo& parameter)
    {
        if (!parameter.documentOf.empty())
            return fileFor(table, table.rows()[table.find(parameter.documentOf).value()]);
        const std::filesystem::path assets = std::filesystem::path(VITRINE_SOURCE_DIR) / "assets";
        if (table.find("animation")) return writeMovedModel(folder_);
        if (parameter.extensions.find("glb") != std::string_view::npos)
            return (assets / "models" / "teddy.glb").string();
        if (parameter.assetFolder == "scenes") return (assets / "scenes" / "torus.json").string();
        const std::filesystem::path panorama = folder_.path() / "panorama.hdr";
        if (!std::filesystem::exists(panorama))
            writePanorama(panorama,
                          [](const glm::dvec3& d) { return d.y > 0 ? glm::dvec3(2, 1, 0.5) + d.x : glm::dvec3(0); });
        return panorama.string();
    }

    /// Returns the tried values if none of them changes a pixel; empty if one does.
    std::string whyIdle(std::size_t exhibit, std::size_t row)
    {
        ParameterValues start = gallery().museum.subject(exhibit).parameters().initial();
        if (exhibit == hallIndex) start = cheap(start);
        // In the first scene, the size of the lamp changes no pixel of so small a picture.
        if (const auto scene = start.table().find("scene")) start.setParameter(*scene, std::string("mercury.json"));
        const ParameterInfo& info = start.table().rows()[row];
        if (info.actsWhen && !acts(start, row))
            satisfy(start, *info.actsWhen, [&](const ParameterInfo& file) { return fileFor(start.table(), file); });
        if (!acts(start, row)) return "its condition cannot be met";
        int tried = 0;
        for (const Situation& situation : situationsOf(exhibit, start)) {
            if (!acts(situation.values, row)) continue;
            const Picture before = take(exhibit, situation.values, situation);
            for (const Value& value : others(info, situation.values.row(row), fileFor(start.table(), info))) {
                ParameterValues changed = situation.values;
                changed.setParameter(row, value);
                ++tried;
                if (largestDifference(before.image, take(exhibit, changed, situation).image) > 0) return {};
            }
        }
        return "none of " + std::to_string(tried) + " other pictures differs";
    }

    void expectEveryParameterActs(std::string_view exhibit, const std::set<std::string_view>& exceptions = {})
    {
        const std::size_t index = gallery().museum.find(exhibit).value();
        const Parameters& table = gallery().museum.subject(index).parameters();
        ASSERT_FALSE(table.rows().empty());
        for (std::size_t row = 0; row < table.rows().size(); ++row) {
            const std::string_view name = table.rows()[row].name;
            const std::string why = whyIdle(index, row);
            if (!exceptions.contains(name)) {
                EXPECT_EQ(why, "") << exhibit << '.' << name;
                continue;
            }
            // Its table says that nothing changes; pictures were compared all the same.
            EXPECT_TRUE(why.starts_with("none of ") && !why.starts_with("none of 0 "))
                << exhibit << '.' << name << ": " << why;
        }
    }

    TemporaryFolder folder_;
};

TEST_F(ActingParameters, EveryParameterOfTheHallActs)
{
    expectEveryParameterActs("hall");
}

TEST_F(ActingParameters, EveryParameterOfTheTorusMugActs)
{
    expectEveryParameterActs("sdf_morph", {"drawnOver"});
}

TEST_F(ActingParameters, EveryParameterOfTheLenticularCardActs)
{
    expectEveryParameterActs("lenticular");
}

TEST_F(ActingParameters, EveryParameterOfTheFurActs)
{
    // Hidden surfaces are drawn first or not at all.
    expectEveryParameterActs("fur", {"drawOrder"});
}

TEST_F(ActingParameters, EveryParameterOfTheSunbeamsActs)
{
    // Three methods for the same mask, if everything in front of the sky is opaque, as here.
    expectEveryParameterActs("crepuscular_rays", {"mask"});
}

TEST_F(ActingParameters, EveryParameterOfThePaperLanternsActs)
{
    expectEveryParameterActs("paper_lanterns");
}

TEST_F(ActingParameters, EveryParameterOfTheIceCreamActs)
{
    expectEveryParameterActs("ice_cream", {"drawnOver"});
}

TEST_F(ActingParameters, EveryParameterOfTheScenesActs)
{
    expectEveryParameterActs("sdf_scenes");
}

TEST_F(ActingParameters, EveryParameterOfTheNoiseActs)
{
    expectEveryParameterActs("noise");
}

TEST_F(ActingParameters, EveryParameterOfThePixelArtActs)
{
    expectEveryParameterActs("pixel_art");
}

}  // namespace
}  // namespace vitrine
