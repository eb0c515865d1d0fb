// Rules of the frame report: running all passes changes no bit of any picture, and disabled effects cost nothing.

#include "exhibits/fur/fur_table.h"
#include "exhibits/ice_cream/ice_cream_table.h"
#include "exhibits/noise/noise_table.h"
#include "exhibits/pixel_art/pixel_art_table.h"
#include "exhibits/sdf_scenes/sdf_scenes_table.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

#include <algorithm>
#include <functional>
#include <map>

namespace vitrine {
namespace {

using pixel_art::NormalsBy;
using pixel_art::PixelArtTable;
using pixel_art::PixelView;

using namespace test;

class FrameReports : public GlTest {};
class LongFrameReports : public FrameReports {};

/// Returns a small shot of the exhibit (or the hall, 0) from its best view, with small shadow map and probe.
Shot shotOf(std::size_t exhibit, bool alone)
{
    Shot shot;
    FrameRequest& frame = shot.request.frame;
    frame.transparent = false;
    frame.averageIn = AverageIn::display;
    frame.raster.size = {64, 36};
    frame.alone = alone ? std::optional(exhibit) : std::nullopt;
    frame.subject = alone || exhibit == hallIndex ? std::nullopt : std::optional(exhibit);
    const Museum& museum = gallery().museum;
    frame.camera = alone || exhibit == hallIndex ? museum.subject(exhibit).bestView(shot.sceneState.values[exhibit])
                                                 : museum.bestView(exhibit, shot.sceneState.values[exhibit]);
    return shot;
}

double changeByRunningEverything(Shot shot)
{
    const Picture needed = shot.take();
    shot.request.frame.runEverything = true;
    const Picture everything = shot.take();
    EXPECT_GT(needed.mean(), 0.001) << "an empty picture proves nothing";
    return largestDifference(everything.image, needed.image);
}

TEST_F(LongFrameReports, RunningEverythingChangesNoBitOfTheHall)
{
    EXPECT_EQ(changeByRunningEverything(shotOf(0, false)), 0);
}

TEST_F(LongFrameReports, RunningEverythingChangesNoBitOfAnyExhibitAlone)
{
    for (const auto& [i, exhibit] : gallery().museum.exhibits())
        EXPECT_EQ(changeByRunningEverything(shotOf(i, true)), 0) << exhibit.name();
}

TEST_F(LongFrameReports, RunningEverythingChangesNoBitOfAnyExhibitInTheHall)
{
    for (const auto& [i, exhibit] : gallery().museum.exhibits())
        EXPECT_EQ(changeByRunningEverything(shotOf(i, false)), 0) << exhibit.name();
}

/// Returns the resources of a new renderer after this picture.
std::map<std::string, std::int64_t> heldFor(const Shot& shot)
{
    render::gl::Renderer renderer;
    return renderer
        .draw(test::planned(gallery().museum, shot.sceneState, shot.request.frame, renderer.persistentState()))
        .counters;
}

/// Effect that a parameter switches, with the resources that must be gone when it is off.
struct Switch {
    const char* exhibit;
    const char* row;
    Value on, off;
    bool alone;
    std::string pass, image;                ///< Beginnings of the names of its passes and images; empty: it has none.
    std::int64_t passes, programs, images;  ///< Resources of the effect.
    std::int64_t others = 0;                ///< Passes that run only for it: shadow maps without other receivers.
};

bool begins(std::string_view name, const std::string& start)
{
    return !start.empty() && name.substr(0, start.size()) == start;
}

TEST_F(LongFrameReports, AnEffectThatIsOffHasNoPassNoProgramAndNoTexture)
{
    constexpr double fins = static_cast<double>(fur::FurSilhouette::fins),
                     march = static_cast<double>(fur::FurSilhouette::march);
    constexpr double field = static_cast<double>(SdfShown::field), mesh = static_cast<double>(SdfShown::mesh);
    constexpr double volume = static_cast<double>(crepuscular_rays::RayTechnique::volume),
                     screen = static_cast<double>(crepuscular_rays::RayTechnique::screen),
                     none = static_cast<double>(crepuscular_rays::RayTechnique::none);
    constexpr double sea = static_cast<double>(noise::NoiseWork::sea),
                     clouds = static_cast<double>(noise::NoiseWork::clouds);
    constexpr double finished = static_cast<double>(PixelView::finished),
                     depthView = static_cast<double>(PixelView::depth);
    constexpr double shapes = static_cast<double>(hall::FloorMirror::shapes),
                     onScreen = static_cast<double>(hall::FloorMirror::screen);
    // The mesh replaces two passes with their two programs and an image, and needs two passes with one program for the
    // shadow on it. With the mask and the running sum, screen-space rays are three passes and two images; the air is
    // two and one. Shadows of the hall are the map of static objects, its copy, and two passes for hanging and turning
    // objects. Without them there are no shadows of exhibits: clearing their map, and the two that the sun reaches.
    // Clouds have a picture of half the size besides their volume, of two images. For a floor that mirrors the picture,
    // the picture is copied with its depth, and what the floor shows of it is found.
    const Switch switches[] = {
        {"sdf_morph", "conePrepass", 1.0, 0.0, true, "sdf_morph/cone", "sdf_morph.cone", 1, 1, 1},
        {"sdf_morph", "shownAs", mesh, field, true, "sdf_morph/mesh", "", 1, 0, -1, 0},
        {"sdf_morph", "shownAs", field, mesh, true, "sdf_morph/march", "sdf_morph.cone", 1, 0, 1, -2},
        {"sdf_morph", "showBox", 1.0, 0.0, true, "sdf_morph/box", "", 1, 1, 0, 2},
        {"fur", "silhouette", fins, march, true, "fur/fins", "", 1, 1, 0},
        {"crepuscular_rays", "technique", screen, none, false, "crepuscular_rays/", "crepuscular_rays.", 3, 3, 2},
        {"crepuscular_rays", "technique", volume, none, false, "crepuscular_rays/", "crepuscular_rays.", 2, 2, 1},
        {"ice_cream", "conePrepass", 1.0, 0.0, true, "ice_cream/cone", "ice_cream.cone", 1, 1, 1},
        {"paper_lanterns", "crowding", 0.8, 0.0, true, "paper_lanterns/float", "paper_lanterns.afloat", 1, 1, 1},
        {"noise", "work", clouds, sea, true, "noise/bake", "noise.", 1, 1, 3, 1},
        {"pixel_art", "shadows", 1.0, 0.0, true, "pixel_art/sun", "pixel_art.shadow", 1, 1, 1},
        {"pixel_art", "smoothing", 2.0, 0.0, true, "pixel_art/smooth", "pixel_art.facets", 1, 1, 1},
        // The depth view has neither normals nor shadows.
        {"pixel_art", "view", finished, depthView, true, "pixel_art/normals", "pixel_art.surface", 1, 1, 2, 1},
        {"sdf_scenes", "split", 1.0, 0.0, true, "sdf_scenes/right", "", 1, 0, 0},
        {"hall", "heatMap", 1.0, 0.0, false, "hall/overdraw", "hall.overdraw", 2, 2, 2},
        {"hall", "floorMirror", onScreen, shapes, false, "hall/floor/mirror", "backdrop.", 1, 3, 4, 2},
        {"hall", "reflectionProbe", 1.0, 0.0, true, "probe/", "probe", 11, 3, 3},
        {"hall", "sunShadows", 1.0, 0.0, false, "hall/shadow", "shadow.", 4, 2, 3, 3},
    };
    for (const Switch& s : switches) {
        SCOPED_TRACE(std::string(s.exhibit) + '.' + s.row);
        const std::size_t exhibit = *gallery().museum.find(s.exhibit);
        Shot on = shotOf(exhibit == hallIndex && s.alone ? *gallery().museum.find("sdf_morph") : exhibit, s.alone);
        test::letTheSunIn(on.sceneState.hall());
        const std::size_t row = *on.sceneState.values[exhibit].table().find(s.row);
        Shot off = on;
        on.sceneState.values[exhibit].setParameter(row, s.on);
        off.sceneState.values[exhibit].setParameter(row, s.off);
        const render::FramePlan with = test::planned(gallery().museum, on.sceneState, on.request.frame);
        const render::FramePlan without = test::planned(gallery().museum, off.sceneState, off.request.frame);
        const auto passesOf = [&](const render::FramePlan& plan) {
            return std::count_if(plan.passes().begin(), plan.passes().end(),
                                 [&](const render::Pass& p) { return begins(p.name, s.pass); });
        };
        EXPECT_EQ(passesOf(with), s.passes) << toString(with);
        EXPECT_EQ(passesOf(without), 0);
        for (const auto& [name, info] : without.images()) EXPECT_FALSE(begins(name, s.image)) << name;
        for (const render::Pass& pass : without.passes())
            for (const std::string& image : inputsOf(pass))
                EXPECT_FALSE(begins(image, s.image)) << pass.name << " reads " << image;
        auto held = heldFor(on);
        auto heldWithout = heldFor(off);
        EXPECT_EQ(held["passes"], heldWithout["passes"] + s.passes + s.others);
        EXPECT_EQ(held["images"], heldWithout["images"] + s.images);
        EXPECT_GE(held["programs"], heldWithout["programs"] + s.programs);
    }
}

TEST_F(FrameReports, SwitchedOffWhileItRunsAnEffectGivesItsTextureBack)
{
    Shot shot = shotOf(gallery().museum.find("sdf_morph").value(), true);
    render::gl::Renderer renderer;
    const auto images = [&](bool prepass) {
        shot.values().set(sdfTable().conePrepass, prepass);
        std::int64_t held = 0;
        // Cached data are drawn in the first frame only. The second one has what is needed to show a picture again.
        for (int frame = 0; frame < 2; ++frame)
            held = renderer
                       .draw(test::planned(gallery().museum, shot.sceneState, shot.request.frame,
                                           renderer.persistentState()))
                       .counters.at("images");
        return held;
    };
    const std::int64_t with = images(true);
    EXPECT_EQ(images(false), with - 1);
    EXPECT_EQ(images(true), with);
}

/// Picture alone with its evaluations, and their sum.
struct Counted {
    Picture picture;
    double evaluations = 0;
};

Counted counted(Shot shot)
{
    shot.request.frame.channels.evaluations = true;
    Counted made{shot.take(), 0};
    const int last = made.picture.image.channels - 1;
    made.picture.each([&](int x, int y) { made.evaluations += made.picture.image.at(x, y, last); });
    return made;
}

double colorsDiffer(const Picture& a, const Picture& b)
{
    double largest = 0;
    a.each([&](int x, int y) {
        for (int c = 0; c < 4; ++c)
            largest = std::max(largest, std::abs(double{a.image.at(x, y, c)} - double{b.image.at(x, y, c)}));
    });
    return largest;
}

TEST_F(FrameReports, OcclusionOfABlackLightIsNotEvaluated)
{
    const std::size_t exhibit = *gallery().museum.find("ice_cream");
    const ice_cream::IceCreamTable table;
    Shot shot = shotOf(exhibit, true);
    ParameterValues& values = shot.sceneState.values[exhibit];
    values.set(table.lighting, ice_cream::IceCreamLighting::reference);
    shot.request.frame.camera = gallery().museum.subject(exhibit).bestView(values);
    const Counted lit = counted(shot);
    values.set(table.referenceAmbient, ColorValue{glm::dvec3(0)});
    const Counted black = counted(shot);
    shot.request.frame.runEverything = true;
    const Counted everything = counted(shot);
    shot.request.frame.runEverything = false;
    values.set(table.ambientOcclusion, false);
    EXPECT_EQ(black.evaluations, counted(shot).evaluations);
    EXPECT_LT(black.evaluations, 0.97 * lit.evaluations);
    EXPECT_EQ(everything.evaluations, lit.evaluations);
    EXPECT_EQ(colorsDiffer(black.picture, everything.picture), 0);
}

TEST_F(FrameReports, ShadowsOnWhatSendsNoLightOfTheLightsAreNotEvaluated)
{
    const std::size_t exhibit = *gallery().museum.find("sdf_scenes");
    const scenes::SdfScenesTable table;
    Shot shot = shotOf(exhibit, true);
    const auto take = [&](scenes::SceneShadow shadows) {
        ParameterValues& values = shot.sceneState.values[exhibit];
        values.set(table.scene, std::string(VITRINE_SOURCE_DIR "/assets/scenes/ambient_occlusion.json"));
        values.set(table.look, scenes::SceneLook::reference);
        values.set(table.shadowMethod, shadows);
        shot.sceneState = gallery().museum.readTables(shot.sceneState).sceneState;
        shot.request.frame.camera = gallery().museum.subject(exhibit).bestView(shot.sceneState.values[exhibit]);
        return counted(shot);
    };
    const Counted none = take(scenes::SceneShadow::none);
    const Counted any = take(scenes::SceneShadow::look);
    EXPECT_EQ(any.evaluations, none.evaluations);
    EXPECT_EQ(colorsDiffer(any.picture, none.picture), 0);
}

TEST_F(FrameReports, TheSmallWorldsSunAndNormalsAreDrawnOnlyForViewsThatShowThem)
{
    const std::size_t exhibit = *gallery().museum.find("pixel_art");
    const PixelArtTable table;
    Shot shot = shotOf(exhibit, true);
    ParameterValues& values = shot.sceneState.values[exhibit];
    const auto plan = [&] { return test::planned(gallery().museum, shot.sceneState, shot.request.frame); };
    // The map and the normals have no effect here: with shadows, by another method, the picture is the same.
    const auto isLeftOut = [&](const char* pass) {
        const Picture without = shot.take();
        EXPECT_EQ(plan().find(pass), nullptr) << pass;
        const ParameterValues before = values;
        values.set(table.shadows, !values[table.shadows]);
        values.set(table.method, NormalsBy::vote);
        if (std::string_view(pass) != "pixel_art/normals") values.set(table.method, before[table.method]);
        EXPECT_EQ(colorsDiffer(shot.take(), without), 0) << pass;
        values = before;
    };
    EXPECT_NE(plan().find("pixel_art/sun"), nullptr);
    for (const PixelView view : {PixelView::normals, PixelView::depth, PixelView::edges, PixelView::error}) {
        values.set(table.view, view);
        isLeftOut("pixel_art/sun");
        const render::Pass* normals = plan().find("pixel_art/normals");
        EXPECT_EQ(normals == nullptr, view == PixelView::depth);
        if (view == PixelView::depth) isLeftOut("pixel_art/normals");
    }
    values.set(table.split, true);
    EXPECT_NE(plan().find("pixel_art/sun"), nullptr) << "the right half is the finished picture";
    values = table.initial();
    values.set(table.sunLight, ColorValue{glm::dvec3(0)});
    EXPECT_NE(plan().find("pixel_art/sun"), nullptr) << "edges are lighter in the sun";
    values.set(table.highlightStrength, 0.0);
    isLeftOut("pixel_art/sun");
}

TEST_F(LongFrameReports, ASunOfNoStrengthCastsNoShadowPass)
{
    Shot shot = shotOf(0, false);
    shot.hall().set(hallTable().sunStrength, 0.0);
    const render::FramePlan plan = test::planned(gallery().museum, shot.sceneState, shot.request.frame);
    EXPECT_EQ(plan.find("hall/shadow"), nullptr);
    ASSERT_NE(plan.findSkipped("hall/shadow"), nullptr);
    EXPECT_TRUE(plan.findSkipped("hall/shadow")->boundIsZero);
    EXPECT_EQ(plan.findSkipped("hall/shadow")->reason, "the sun's strength is 0");
    EXPECT_EQ(changeByRunningEverything(shot), 0);
}

/// Returns the hall's first view with a heat map of overdraw, one sample a pixel.
Shot shotOfOverdraw(double scale)
{
    Shot shot = shotOf(hallIndex, false);
    shot.request.frame.raster.size = {96, 60};
    shot.hall().set(hallTable().heatMap, hall::HallHeatMap::overdraw);
    shot.hall().set(hallTable().heatScale, scale);
    return shot;
}

TEST_F(LongFrameReports, OverdrawIsTheNumberOfFragmentsThatTheSurfacesShade)
{
    const Shot shot = shotOfOverdraw(8);
    render::FramePlan plan = planned(gallery().museum, shot.sceneState, shot.request.frame);
    plan.allSlices = true;
    render::gl::Renderer& renderer = gallery().renderer;
    // The driver counts the fragments that pass the depth test in passes that draw triangles and discard none.
    int passes = 0;
    const auto counted = [&](const std::function<bool(const render::Pass&)>& of) {
        passes = 0;
        for (const render::Pass& pass : plan.passes()) {
            const_cast<render::Pass&>(pass).countSamples = of(pass);
            passes += pass.countSamples;
        }
        return renderer.draw(plan).counters.at("samples");
    };
    const std::int64_t shaded = counted([](const render::Pass& pass) {
        return pass.phase == render::PassPhase::opaque && pass.shader.fragment == "kit/surface.frag";
    });
    EXPECT_GT(passes, 3);
    const std::int64_t mapped = counted([](const render::Pass& pass) { return pass.name == "hall/overdraw"; });
    EXPECT_EQ(passes, 1);
    EXPECT_EQ(mapped, shaded);
    const render::Image map = renderer.read("hall.overdraw");
    double sum = 0, most = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            sum += map.at(x, y, 0);
            most = std::max(most, static_cast<double>(map.at(x, y, 0)));
        }
    EXPECT_EQ(sum, static_cast<double>(mapped));
    EXPECT_GE(most, 2) << "some surfaces are drawn over others";
    EXPECT_LT(sum, 4.0 * map.width * map.height);
}

TEST_F(FrameReports, TheHeatMapOfOverdrawIsBrighterTheMoreIsShaded)
{
    const Picture fine = shotOfOverdraw(2).take();
    const render::Image map = gallery().renderer.read("hall.overdraw");
    const Picture coarse = shotOfOverdraw(32).take();
    std::map<int, glm::dvec3> colors;
    fine.each([&](int x, int y) {
        const int count = static_cast<int>(map.at(x, y, 0));
        const glm::dvec3 color = fine.color(x, y);
        const auto [known, isNew] = colors.try_emplace(std::min(count, 2), color);
        EXPECT_LT(glm::distance(known->second, color), 1e-3) << count << " at " << x << ", " << y;
        if (count > 0) {
            EXPECT_LT(coarse.luminance(x, y), fine.luminance(x, y));
        }
    });
    ASSERT_TRUE(colors.contains(1) && colors.contains(2));
    EXPECT_GT(colors.at(2).x, 0.95) << "the scale's number and more are white";
    EXPECT_GT(colors.at(2).y, colors.at(1).y + 0.3);
}

}  // namespace
}  // namespace vitrine
