// Runs the tests of `vitrine doctor --stability` on this driver: the library's arithmetic, promises about pictures, and
// every exhibit with random settings at extreme times, places and sizes.
//   VITRINE_SCAN_PRESETS=20000   number of random settings of each exhibit, instead of 1000
//   VITRINE_SCAN_SEED=123        first seed, instead of 1; .ci/full sets another one every day, and a failure names it

#include "exhibits/exhibits.h"
#include "exhibits/framework/table/random_values.h"
#include "exhibits/stability/poison.h"
#include "exhibits/stability/stability_cases.h"
#include "exhibits/stability/stability_scan.h"
#include "tests/support/environment_number.h"
#include "tests/support/gallery.h"

#include <cmath>

namespace vitrine {
namespace {

using stability::arithmeticCases;
using stability::causesOf;
using stability::faultOf;
using stability::pictureCases;
using stability::scanCase;
using stability::ScanCase;
using stability::scanExhibit;
using stability::StabilityResult;
using test::gallery;

class StabilityScan : public test::GlTest {};

TEST_F(StabilityScan, TheLibrarysNumbersAreThoseOfFloat64)
{
    int naiveFails = 0;
    for (const StabilityResult& result : arithmeticCases(gallery().renderer)) {
        EXPECT_TRUE(result.passed) << result.number << ' ' << result.what << ": " << result.value << " > "
                                   << result.limit << ", " << result.detail;
        naiveFails += result.detail.find("plain code") != std::string::npos;
    }
    EXPECT_GE(naiveFails, 10) << "the inputs are not hard any more";
}

TEST_F(StabilityScan, PicturesKeepTheirPromises)
{
    for (const StabilityResult& result : pictureCases(gallery().museum, gallery().renderer))
        EXPECT_TRUE(result.passed) << result.number << ' ' << result.what << ": " << result.value << ", "
                                   << result.detail;
}

class ScanOfExhibit : public StabilityScan, public testing::WithParamInterface<std::string> {};

TEST_P(ScanOfExhibit, FindsNothingThatIsNoNumberOrWasNeverWritten)
{
    const int presets = static_cast<int>(test::environmentNumber("VITRINE_SCAN_PRESETS", 1000));
    const std::uint64_t first = test::environmentNumber("VITRINE_SCAN_SEED", 1);
    const StabilityResult result =
        scanExhibit(gallery().museum, gallery().renderer, *gallery().museum.find(GetParam()), first, presets);
    EXPECT_TRUE(result.passed) << result.what << "\n  VITRINE_SCAN_SEED of " << result.detail;
}

std::vector<std::string> namesOfAll()
{
    std::vector<std::string> names{"hall"};
    for (const auto& exhibit : allExhibits()) names.emplace_back(exhibit->name());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Exhibits, ScanOfExhibit, testing::ValuesIn(namesOfAll()),
                         [](const auto& p) { return p.param; });

TEST_F(StabilityScan, EveryParameterOfEveryExhibitAtItsEndsGivesNumbers)
{
    // For a single layer, the relative height of layer 0 would be 0/0.
    const Museum& museum = gallery().museum;
    for (const auto& [i, exhibit] : museum.exhibits()) {
        const auto rows = exhibit.parameters().rows();
        ScanCase plain = scanCase(museum, i, 1);
        EXPECT_TRUE(plain.frame.finished) << "a pass could be drawn by the program of other settings";
        plain.sceneState = museum.initialSceneState();
        plain.sceneState.hall() = cheapestValues(museum.hall().parameters());
        plain.frame = {};
        plain.frame.finished = true;
        plain.frame.alone = i;
        plain.frame.transparent = true;
        plain.frame.raster.size = {24, 16};
        plain.frame.time = 1;
        plain.frame.averageIn = AverageIn::radiance;
        for (std::size_t row = 0; row < rows.size(); ++row) {
            if (rows[row].kind != Kind::real && rows[row].kind != Kind::count) continue;
            // Counts that trade accuracy for time are limited to their initial values, because higher ones take
            // minutes.
            const double high = rows[row].kind == Kind::count && rows[row].qualityReference
                                    ? std::get<double>(rows[row].initial)
                                    : rows[row].range.high;
            for (const double end : {rows[row].range.low, high}) {
                ScanCase c = plain;
                c.sceneState.values[i].setParameter(row, end);
                c.frame.camera = exhibit.bestView(c.sceneState.values[i]);
                EXPECT_EQ(faultOf(museum, gallery().renderer, c), "")
                    << exhibit.name() << '.' << rows[row].name << ' ' << end;
            }
        }
    }
}

/// Exhibit whose settings make it draw nothing, NaN or infinity. The scan must find each case and name its cause.
struct Broken final : Exhibit {
    struct Table final : Parameters {
        Real harmless = real("harmless", 0.5, none, {0, 1}, "Changes nothing.");
        Real divisor = real("divisor", 1, none, {0, 1}, "Its light is one over this.");
        Toggle forgetful = toggle("forgetful", false, "Whether it forgets to clear what it reads.");
    } table;

    [[nodiscard]] std::string_view name() const override { return "broken"; }
    [[nodiscard]] std::string_view title() const override { return "Broken"; }
    [[nodiscard]] std::string_view summary() const override { return "Broken."; }
    [[nodiscard]] int place() const override { return 3; }
    [[nodiscard]] const Parameters& parameters() const override { return table; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override { return {{-1, -1, -1}, {1, 1, 1}}; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override { return {{0, 0, 4}, {0, 0, 0}, 0.7}; }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override { return 1; }

    void plan(const PlanContext& context, render::FramePlan& plan) const override
    {
        render::Pass glow;
        glow.name = "broken/glow";
        glow.shader = {"kit/depth.vert", "kit/depth.frag", "", {}};
        const auto light = static_cast<float>(1 / context.values[table.divisor]);
        glow.colors = {{radianceImage, render::Load::clear, glm::vec4(light, light, light, 1), -1, 0}};
        plan.add(std::move(glow));
        if (!context.values[table.forgetful]) return;
        plan.image({.name = "broken.source", .format = render::Format::rgba16f});
        render::Pass half;  // Draws nothing.
        half.name = "broken/half";
        half.shader = {"kit/depth.vert", "kit/depth.frag", "", {}};
        half.colors = {{"broken.source", render::Load::keep, {}, -1, 0}};
        plan.add(std::move(half));
        render::Pass copy;
        copy.name = "broken/copy";
        copy.shader = {"lib/fullscreen.vert", "lib/copy.frag", "", {}};
        copy.inputs = {{12, std::string("broken.source")}};
        copy.colors = {{radianceImage, render::Load::keep, {}, -1, 0}};
        copy.draws = {render::Draw{}};
        plan.add(std::move(copy));
    }
};

TEST_F(StabilityScan, FaultsAreSeenAndBlamedOnWhatCausesThem)
{
    std::vector<std::unique_ptr<Exhibit>> guests;
    guests.push_back(std::make_unique<Broken>());
    const auto& table = static_cast<const Broken&>(*guests[0]).table;
    const Museum museum(std::move(guests));
    ScanCase c = scanCase(museum, 1, 32);
    c.sceneState.values[1] = table.initial();
    c.sceneState.values[1].set(table.harmless, 0.25);
    c.frame.alone = 1;
    c.frame.transparent = true;  // Otherwise the sky would cover it.
    c.frame.camera = museum.exhibit(1).bestView(c.sceneState.values[1]);
    EXPECT_EQ(faultOf(museum, gallery().renderer, c), "");

    ScanCase infinite = c;
    infinite.sceneState.values[1].set(table.divisor, 0.0);
    EXPECT_NE(faultOf(museum, gallery().renderer, infinite).find("infinity"), std::string::npos);
    EXPECT_EQ(causesOf(museum, gallery().renderer, infinite), std::vector<std::string>{"broken.divisor 0"});

    ScanCase unwritten = c;
    unwritten.sceneState.values[1].set(table.forgetful, true);
    EXPECT_NE(faultOf(museum, gallery().renderer, unwritten).find("nobody wrote"), std::string::npos);
    EXPECT_EQ(causesOf(museum, gallery().renderer, unwritten), std::vector<std::string>{"broken.forgetful on"});

    const StabilityResult result = scanExhibit(museum, gallery().renderer, 1, 1, 60);
    EXPECT_FALSE(result.passed);
    EXPECT_EQ(result.value, 3);
    EXPECT_NE(result.detail.find("seed "), std::string::npos) << result.detail;
}

TEST_F(StabilityScan, ASeedIsTheSameCaseEveryTime)
{
    for (const std::uint64_t seed : {1U, 77U, 1000U}) {
        const ScanCase a = scanCase(gallery().museum, 1, seed);
        const ScanCase b = scanCase(gallery().museum, 1, seed);
        EXPECT_EQ(a.sceneState, b.sceneState);
        EXPECT_EQ(a.frame.camera, b.frame.camera);
        EXPECT_FALSE(a.sceneState == scanCase(gallery().museum, 1, seed + 1).sceneState);
    }
}

}  // namespace
}  // namespace vitrine
