// Parameters without effect, according to their table, change no pixel: in all states that conditions distinguish, of
// every exhibit.

#include "tests/support/gallery.h"

#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/random_values.h"

#include <algorithm>
#include <limits>
#include <set>

namespace vitrine {
namespace {

using namespace test;

/// Settings of one exhibit, with a description of their difference from the initial ones.
struct State {
    std::string name;
    ParameterValues values;
};

/// Returns all values of a parameter that a condition may distinguish: all choices, on and off, 0 and the initial
/// number.
std::vector<Value> tellingValues(const ParameterInfo& parameter)
{
    std::vector<Value> values;
    if (parameter.kind == Kind::toggle || parameter.kind == Kind::choice)
        for (double x = 0; x <= parameter.range.high; ++x) values.emplace_back(x);
    else if (parameter.isNumeric() && parameter.range.low <= 0)
        values = {0.0, std::max(std::get<double>(parameter.initial), 0.5 * parameter.range.softHigh)};
    return values;
}

/// Returns the initial state with small maps of the hall, and a state for each value of each parameter in a condition.
std::vector<State> statesOf(std::size_t exhibit)
{
    ParameterValues start = Shot().sceneState.values[exhibit];
    const Parameters& table = start.table();
    // Beams of both kinds, so that there is something to compare.
    if (const auto technique = table.find("technique")) start.setParameter(*technique, 3.0);
    std::vector<State> states{{"initial", start}};
    std::set<std::string_view> asked;
    for (const ParameterInfo& parameter : table.rows())
        if (parameter.actsWhen)
            for (const std::string_view name : parametersOf(*parameter.actsWhen)) asked.insert(name);
    for (const std::string_view name : asked) {
        const std::size_t row = table.find(name).value();
        for (const Value& value : tellingValues(table.rows()[row])) {
            ParameterValues values = start;
            values.setParameter(row, value);
            if (!(values == start))
                states.push_back({std::string(name) + " = " + std::to_string(std::get<double>(value)), values});
        }
    }
    return states;
}

/// Returns the difference in luminance of the brightest and the darkest pixel: a mask is dark except for a few pixels.
double contrast(const Picture& picture)
{
    double darkest = std::numeric_limits<double>::infinity();
    double brightest = 0;
    picture.each([&](int x, int y) {
        darkest = std::min(darkest, picture.luminance(x, y));
        brightest = std::max(brightest, picture.luminance(x, y));
    });
    return brightest - darkest;
}

class IdleParameters : public GlTest {
protected:
    /// Takes a picture in the hall, half a second after the button was pressed, so that animations run.
    Picture take(std::size_t exhibit, const ParameterValues& values)
    {
        Shot shot;
        FrameRequest& frame = shot.request.frame;
        frame.transparent = false;
        frame.alone = std::nullopt;
        frame.subject = std::nullopt;
        frame.raster.size = {64, 36};
        frame.averageIn = AverageIn::radiance;
        frame.camera = gallery().museum.bestView(exhibit, gallery().museum.initialSceneState().values[exhibit]);
        frame.time = 0.7;
        frame.sincePressed.assign(gallery().museum.subjects().size(), 0.5);
        shot.sceneState.values[exhibit] = values;
        return shot.take();
    }

    void expectIdleParametersChangeNothing(std::size_t exhibit)
    {
        const Parameters& table = gallery().museum.subject(exhibit).parameters();
        RandomNumbers random(20260101);
        std::set<std::size_t> proven;
        for (const State& state : statesOf(exhibit)) {
            ParameterValues moved = state.values;
            std::vector<std::size_t> idle;
            for (std::size_t row = 0; row < table.rows().size(); ++row) {
                if (acts(state.values, row)) continue;
                // An expensive count costs nothing while it has no effect. Its initial value may be the least.
                for (int tries = 0; tries < 20 && moved.row(row) == state.values.row(row); ++tries)
                    moved.setParameter(row, randomValue(table.rows()[row], random, {.affordable = false}));
                if (!(moved.row(row) == state.values.row(row))) idle.push_back(row);
            }
            if (idle.empty()) continue;
            const Picture before = take(exhibit, state.values);
            EXPECT_GT(contrast(before), 0.01) << state.name << ": an empty picture proves nothing";
            if (largestDifference(before.image, take(exhibit, moved).image) == 0) {
                proven.insert(idle.begin(), idle.end());
                continue;
            }
            for (const std::size_t row : idle) {
                ParameterValues one = state.values;
                one.setParameter(row, moved.row(row));
                EXPECT_EQ(largestDifference(before.image, take(exhibit, one).image), 0)
                    << state.name << ": " << table.rows()[row].name << " acts";
            }
            ADD_FAILURE() << state.name << ": rows that do not act change the picture";
        }
        for (std::size_t row = 0; row < table.rows().size(); ++row) {
            if (table.rows()[row].actsWhen) {
                EXPECT_TRUE(proven.contains(row)) << table.rows()[row].name << " was never seen idle";
            }
        }
    }
};

TEST_F(IdleParameters, ChangeNoPixelOfTheHall)
{
    expectIdleParametersChangeNothing(0);
}

TEST_F(IdleParameters, ChangeNoPixelOfTheTorusMug)
{
    expectIdleParametersChangeNothing(gallery().museum.find("sdf_morph").value());
}

TEST_F(IdleParameters, ChangeNoPixelOfTheLenticularCard)
{
    expectIdleParametersChangeNothing(gallery().museum.find("lenticular").value());
}

TEST_F(IdleParameters, ChangeNoPixelOfTheFur)
{
    expectIdleParametersChangeNothing(gallery().museum.find("fur").value());
}

TEST_F(IdleParameters, ChangeNoPixelOfTheSunbeams)
{
    expectIdleParametersChangeNothing(gallery().museum.find("crepuscular_rays").value());
}

TEST_F(IdleParameters, ChangeNoPixelOfThePaperLanterns)
{
    expectIdleParametersChangeNothing(gallery().museum.find("paper_lanterns").value());
}

TEST_F(IdleParameters, ChangeNoPixelOfTheIceCream)
{
    expectIdleParametersChangeNothing(gallery().museum.find("ice_cream").value());
}

TEST_F(IdleParameters, ChangeNoPixelOfTheNoise)
{
    expectIdleParametersChangeNothing(gallery().museum.find("noise").value());
}

TEST_F(IdleParameters, ChangeNoPixelOfThePixelArt)
{
    expectIdleParametersChangeNothing(gallery().museum.find("pixel_art").value());
}

TEST_F(IdleParameters, ChangeNoPixelOfTheScenes)
{
    expectIdleParametersChangeNothing(gallery().museum.find("sdf_scenes").value());
}

/// The states above may miss parameters that only have an effect together.
TEST_F(IdleParameters, ChangeNoPixelInRandomStates)
{
    RandomNumbers random(7);
    for (std::size_t exhibit = 0; exhibit < gallery().museum.subjects().size(); ++exhibit) {
        const Parameters& table = gallery().museum.subject(exhibit).parameters();
        for (int state = 0; state < 4; ++state) {
            ParameterValues values = Shot().sceneState.values[exhibit];
            for (std::size_t row = 0; row < table.rows().size(); ++row)
                if (random.chance(0.3) && table.rows()[row].kind != Kind::count)
                    values.setParameter(row, randomValue(table.rows()[row], random));
            const ParameterValues same = actingValues(values);
            if (same == values) continue;
            EXPECT_EQ(largestDifference(take(exhibit, values).image, take(exhibit, same).image), 0)
                << gallery().museum.subject(exhibit).name() << ", random state " << state;
        }
    }
}

}  // namespace
}  // namespace vitrine
