// Plans of the lenticular card: one print at rest, two while it rolls, none out of view.

#include "exhibits/lenticular/card_mesh.h"
#include "exhibits/lenticular/card_sheet.h"
#include "exhibits/lenticular/lenticular.h"
#include "exhibits/printing/print_file.h"
#include "exhibits/printing/print_json.h"
#include "exhibits/printing/sheet.h"
#include "shaders/lib/bindings.glsl"
#include "tests/exhibits/printing/values_of.h"
#include "tests/support/failures.h"
#include "tests/support/museum_on_paper.h"
#include "tests/support/planned.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

using lenticular::CardSheet;
using lenticular::LenticularTable;
using lenticular::scrollAt;
using render::FramePlan;
using render::Pass;
using namespace test;

struct CardScene : test::Scene {
    std::size_t card = *museum().find("lenticular");
    LenticularTable t;

    CardScene() { see(museum().bestView(card, values())); }
    [[nodiscard]] ParameterValues& values() { return sceneState.values[card]; }
};

bool binds(const Pass& pass, int unit)
{
    return std::any_of(pass.inputs.begin(), pass.inputs.end(),
                       [&](const render::SampledTexture& input) { return input.unit == unit; });
}

bool defines(const Pass& pass, std::string_view name)
{
    return std::find(pass.shader.defines.begin(), pass.shader.defines.end(), name) != pass.shader.defines.end();
}

TEST(CardPlan, AtRestOnePrintIsBoundAndWhileRollingTwo)
{
    CardScene scene;
    const FramePlan rest = scene.plan();
    ASSERT_TRUE(rest.find("lenticular/card"));
    EXPECT_TRUE(binds(*rest.find("lenticular/card"), UNIT_EXHIBIT_A));
    EXPECT_FALSE(binds(*rest.find("lenticular/card"), UNIT_EXHIBIT_B));
    EXPECT_FALSE(defines(*rest.find("lenticular/card"), "SCROLLING"));
    EXPECT_EQ(reasonFor(rest, "lenticular/count"), "no counts are requested");

    scene.request.time = 12 * (0.85 + 0.05);
    const FramePlan rolling = scene.plan();
    EXPECT_TRUE(binds(*rolling.find("lenticular/card"), UNIT_EXHIBIT_B));
    EXPECT_TRUE(defines(*rolling.find("lenticular/card"), "SCROLLING"));
    EXPECT_NE(rolling.find("lenticular/card")->reason.find("rolls"), std::string::npos);

    scene.values().set(scene.t.scroll, false);
    EXPECT_FALSE(binds(*scene.plan().find("lenticular/card"), UNIT_EXHIBIT_B));
}

TEST(CardPlan, TheButtonRollsTheOtherPrintIn)
{
    CardScene scene;
    scene.values().set(scene.t.scroll, false);
    const HasButton& button = *capability<HasButton>(museum().exhibit(scene.card));
    EXPECT_TRUE(button.press(scene.values()));
    scene.request.sincePressed.assign(scene.card + 1, 1e9);
    scene.request.sincePressed[scene.card] = 0.5;
    EXPECT_TRUE(defines(*scene.plan().find("lenticular/card"), "SCROLLING"));
    EXPECT_EQ(test::nextChange(museum(), scene.sceneState, scene.request), 0);
    scene.request.sincePressed[scene.card] = 1.3;
    EXPECT_FALSE(defines(*scene.plan().find("lenticular/card"), "SCROLLING"));
    EXPECT_EQ(test::nextChange(museum(), scene.sceneState, scene.request), std::numeric_limits<double>::infinity());
    // Another exhibit's button does not move this card.
    scene.request.sincePressed[scene.card] = 1e9;
    scene.request.sincePressed[scene.sdf] = 0.5;
    EXPECT_FALSE(defines(*scene.plan().find("lenticular/card"), "SCROLLING"));
}

TEST(CardPlan, OutOfViewNothingOfItIsPlanned)
{
    CardScene scene;
    scene.see({0, 1.65, 3}, {6, 1.65, 3});
    const FramePlan plan = scene.plan();
    EXPECT_EQ(reasonFor(plan, "lenticular"), "out of view");
    EXPECT_FALSE(test::runs(plan, "lenticular/card"));
}

TEST(CardPlan, TheSameValuesShareTheSameTexture)
{
    CardScene scene;
    const auto texture = [&] {
        const FramePlan plan = scene.plan();
        for (const render::SampledTexture& input : plan.find("lenticular/card")->inputs)
            if (input.unit == UNIT_EXHIBIT_A) return std::get<std::shared_ptr<const render::Texture>>(input.source);
        return std::shared_ptr<const render::Texture>();
    };
    const auto first = texture();
    scene.values().set(scene.t.roughness, 0.3);
    scene.values().set(scene.t.phase, 0.25);
    scene.values().set(scene.t.magnification, 0.5);
    EXPECT_EQ(first->layers, 16);
    EXPECT_EQ(texture(), first);
    scene.values().set(scene.t.views, 5);
    EXPECT_EQ(texture()->layers, 5);
    scene.values().set(scene.t.views, 1);
    EXPECT_EQ(texture()->layers, 2);  // One layer would be no array, so there are two equal ones.
}

TEST(CardPlan, ASheetThatCannotBeIsReplacedByTheNearestAndSaysSo)
{
    CardScene scene;
    scene.values().set(scene.t.sheetKind, CardSheet::custom);
    scene.values().set(scene.t.customLpi, 10.0);
    scene.values().set(scene.t.radius, 1e-4);
    scene.values().set(scene.t.thickness, 1e-4);
    const lenticular::CardSheetFound found = lenticular::cardSheet(scene.t, scene.values());
    EXPECT_NO_THROW(printing::check(found.sheet));
    EXPECT_NE(scene.plan().find("lenticular/card")->reason.find("radius raised"), std::string::npos);
}

TEST(CardPlan, EverySheetThatCanBeChosenIsKnownAndEveryTableMakesOneThatCanBe)
{
    const LenticularTable t;
    ParameterValues values = t.initial();
    const auto& choices = values.rows()[t.sheetKind.row].choices;
    for (std::size_t i = 0; i + 1 < choices.size(); ++i) {
        values.setParameter(t.sheetKind.row, static_cast<double>(i));
        EXPECT_EQ(lenticular::cardSheet(t, values).sheet.name, choices[i]);
        EXPECT_EQ(lenticular::cardSheet(t, values).note, "") << choices[i];
    }
    values.set(t.sheetKind, CardSheet::custom);
    for (const double lpi : {1.0, 40.0, 400.0})
        for (const double radius : {1e-5, 1e-3, 0.1})
            for (const double thickness : {1e-5, 0.3})
                for (const double conic : {-5.0, -1.0, 0.0, 2.0})
                    for (const int slices : {0, 1, 8000}) {
                        values.set(t.customLpi, lpi);
                        values.set(t.radius, radius);
                        values.set(t.thickness, thickness);
                        values.set(t.conic, conic);
                        values.set(t.slices, slices);
                        EXPECT_NO_THROW(printing::check(lenticular::cardSheet(t, values).sheet));
                    }
}

TEST(CardPlan, PrintsThatCannotBeReadAreNamed)
{
    CardScene scene;
    const test::TemporaryFolder folder;
    for (const std::string& path : {std::string("/no/such/folder"), folder.path().string()}) {
        scene.values().set(scene.t.frontPrint, path);
        scene.request.needsFiles = true;
        EXPECT_FAILURE(scene.plan(), path);
    }
    scene.values().set(scene.t.frontPrint, std::string());
    EXPECT_TRUE(scene.plan().find("lenticular/card"));
}

TEST(CardPlan, ADescriptionBesideAPrintThatIsNotItsOwnIsNamed)
{
    const test::TemporaryFolder folder;
    const auto described = [](double lpi) {
        printing::PrintSettings settings;
        settings.sheet = printing::derivedSheet("derived", lpi, 30, 1.56);
        settings.dpiX = settings.dpiY = 600;
        settings.width = 8;
        settings.height = 6;
        settings.distance = 400;
        settings.views = 2;
        const printing::PrintLayout layout(settings);
        const ParameterValues values = printing::test::valuesOf(settings);
        return std::pair(layout, render::writeJson(printing::printJson(values, layout, 600, {{"two views"}})));
    };
    const auto [layout, own] = described(60);
    printing::ViewSet views;
    for (const float gray : {0.2F, 0.7F}) views.add(render::Image(12, 9, 3, gray));
    const std::string print = folder / "a.tif";
    (void)printing::writePrint(layout, views, {.path = print, .json = own});
    CardScene scene;
    scene.values().set(scene.t.frontPrint, print);
    scene.request.needsFiles = true;
    EXPECT_EQ(scene.plan().findSkipped("lenticular/front print"), nullptr);

    // The description belongs to another print. The file has a name of its own, because read files are cached.
    test::writeBytes(folder / "b.tif", test::bytesOf(print));
    test::writeBytes(folder / "b.tif.json", described(40).second);
    scene.values().set(scene.t.frontPrint, (folder / "b.tif").string());
    const FramePlan plan = scene.plan();
    ASSERT_TRUE(plan.find("lenticular/card")) << "it is shown all the same";
    const render::CulledPass* said = plan.findSkipped("lenticular/front print");
    ASSERT_TRUE(said);
    EXPECT_TRUE(said->complaint);
    EXPECT_NE(said->reason.find("b.tif.json does not describe"), std::string::npos) << said->reason;
}

TEST(CardScroll, RestsAtWholeNumbersAndRollsOn)
{
    EXPECT_EQ(scrollAt(0, 12, 0.85), 0);
    EXPECT_EQ(scrollAt(10.1, 12, 0.85), 0);
    EXPECT_GT(scrollAt(11, 12, 0.85), 0);
    EXPECT_EQ(scrollAt(12, 12, 0.85), 1);
    EXPECT_EQ(scrollAt(-1, 12, 0), -1 + scrollAt(11, 12, 0));
    EXPECT_EQ(scrollAt(NAN, 12, 0.5), 0);
    double before = 0;
    for (double time = 0; time < 40; time += 0.01) {
        const double y = scrollAt(time, 12, 0.85);
        EXPECT_GE(y, before);
        EXPECT_LT(y - before, 0.02);  // No jump.
        before = y;
    }
    // With a share of 1 it rests all the time and then jumps.
    EXPECT_EQ(scrollAt(11.99, 12, 1), 0);
    EXPECT_EQ(scrollAt(12.01, 12, 1), 1);
}

TEST(CardScroll, TheNextChangeIsTheEndOfTheRest)
{
    CardScene scene;
    const Exhibit& exhibit = museum().exhibit(scene.card);
    EXPECT_NEAR(exhibit.nextChange(scene.values(), 0), 12 * 0.85, 1e-9);
    EXPECT_NEAR(exhibit.nextChange(scene.values(), 13), 12 * 0.85 - 1, 1e-9);
    EXPECT_EQ(exhibit.nextChange(scene.values(), 11), 0);
    // Until then the picture stays the same.
    for (const double time : {0.0, 3.0, 10.19, 24.0}) EXPECT_EQ(std::fmod(scrollAt(time, 12, 0.85), 2), 0) << time;
    scene.values().set(scene.t.scroll, false);
    EXPECT_EQ(exhibit.nextChange(scene.values(), 11), std::numeric_limits<double>::infinity());
}

TEST(CardMesh, IsClosedAndFacesOutward)
{
    const render::Mesh& mesh = *lenticular::cardMesh();
    glm::dvec3 area(0);
    double volume = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.vertices[mesh.indices[i]].position), b(mesh.vertices[mesh.indices[i + 1]].position),
            c(mesh.vertices[mesh.indices[i + 2]].position);
        area += glm::cross(b - a, c - a);
        volume += glm::dot(a, glm::cross(b, c)) / 6;
        for (int k = 0; k < 3; ++k) {
            const render::Vertex& v = mesh.vertices[mesh.indices[i + static_cast<std::size_t>(k)]];
            EXPECT_GT(glm::dot(glm::cross(b - a, c - a), glm::dvec3(v.normal)), -1e-12);
        }
    }
    EXPECT_LT(glm::length(area), 1e-8);
    EXPECT_NEAR(volume, 8 * 0.3 * 0.2 * 0.0025, 1e-5);
}

}  // namespace
}  // namespace vitrine
