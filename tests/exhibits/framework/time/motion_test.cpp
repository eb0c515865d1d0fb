// Animated parameters: values of each kind of animation over time, legal values, the time of the next change, and
// saving to files.

#include "exhibits/exhibits.h"
#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/time/animation.h"
#include "exhibits/framework/time/motion_json.h"
#include "tests/support/failures.h"
#include "tests/support/planned.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace vitrine {
namespace {

constexpr double noChange = std::numeric_limits<double>::infinity();

struct MotionTable final : Parameters {
    Group everything = group("All");
    Real width = real("width", 2, meter, {1, 9}, "Even.");
    Real radius = real("radius", 1, meter, {0.01, 100, logarithmic}, "By factors.");
    Count sides = count("sides", 4, {1, 64, logarithmic}, "Whole.");
    Count samples = count("samples", 4, {1, 64, logarithmic}, "Accuracy.", quality(64));
    Toggle lit = toggle("lit", false, "Switched.");
    Choice<int> method = choice("method", 0, {"rough", "fair", "exact"}, "Switched.", when(lit));
    Color color = this->Parameters::color("color", {1, 0, 0}, "In Oklab.");
    Direction axis = direction("axis", {1, 0, 0}, "On a great circle.");
    File file = this->Parameters::file("file", "Read.");
};
const MotionTable movingParameters;

/// Returns an animation of `radius` from 0.01 to 100 m in four seconds.
Motion movingRadius(MotionKind kind)
{
    Motion motion;
    motion.kind = kind;
    motion.from = 0.01;
    motion.to = 100.0;
    return motion;
}

double positionAfter(const Motion& motion, double seconds)
{
    return positionOf(motion, {seconds, 0});
}

TEST(Motions, OscillatorsGoThereAndBackInEachPeriod)
{
    for (const MotionKind kind : {MotionKind::sine, MotionKind::triangle}) {
        Motion motion = movingRadius(kind);
        for (const double begin : {0.0, 4.0, 4e6}) {
            EXPECT_NEAR(positionAfter(motion, begin), 0, 1e-12);
            EXPECT_NEAR(positionAfter(motion, begin + 1), 0.5, 1e-12);
            EXPECT_NEAR(positionAfter(motion, begin + 2), 1, 1e-12);
            EXPECT_NEAR(positionAfter(motion, begin + 3), 0.5, 1e-12);
        }
        motion.phase = 0.5;
        EXPECT_NEAR(positionAfter(motion, 0), 1, 1e-12);
    }
    Motion even = movingRadius(MotionKind::triangle);
    even.ease = Ease::linear;
    EXPECT_NEAR(positionAfter(even, 0.5), 0.25, 1e-12);
    EXPECT_NEAR(positionAfter(movingRadius(MotionKind::sine), 0.5), 0.5 - std::numbers::sqrt2 / 4, 1e-12);
}

TEST(Motions, StepsStandStillAtEvenlySpacedPositions)
{
    Motion motion = movingRadius(MotionKind::steps);
    motion.steps = 5;
    motion.period = 10;
    for (int step = 0; step < 5; ++step)
        for (const double within : {0.0, 1.9}) EXPECT_DOUBLE_EQ(positionAfter(motion, 2 * step + within), step / 4.0);
    EXPECT_DOUBLE_EQ(positionAfter(motion, 10), 0);
    EXPECT_NEAR(nextChangeOf(movingParameters.rows()[movingParameters.radius.row], motion, 3.5), 0.5, 1e-12);
}

TEST(Motions, NoiseIsSmoothFillsItsRangeAndIsAnotherOneForAnotherSeed)
{
    Motion motion = movingRadius(MotionKind::noise), other = motion;
    motion.period = other.period = 1;
    other.seed = 2;
    double low = 1, high = 0, largestStep = 0, apart = 0;
    for (int i = 0; i < 100000; ++i) {
        const double now = positionAfter(motion, i * 0.01), next = positionAfter(motion, (i + 1) * 0.01);
        low = std::min(low, now);
        high = std::max(high, now);
        largestStep = std::max(largestStep, std::abs(next - now));
        apart += std::abs(now - positionAfter(other, i * 0.01)) / 100000;
    }
    EXPECT_GE(low, 0);
    EXPECT_LE(high, 1);
    EXPECT_LT(low, 0.02);
    EXPECT_GT(high, 0.98);
    EXPECT_LT(largestStep, 0.02) << "the fade's steepest slope is 15/8";
    EXPECT_NEAR(apart, 0.29, 0.03) << "of independent noise";
    EXPECT_EQ(positionAfter(motion, 1234.5), positionAfter(motion, 1234.5));
}

TEST(Motions, AnEaseGoesOnceAndADistanceGoesByTheVisitor)
{
    Motion ease = movingRadius(MotionKind::ease);
    ease.start = 10;
    EXPECT_EQ(positionAfter(ease, 3), 0);
    EXPECT_NEAR(positionAfter(ease, 12), 0.5, 1e-12);
    EXPECT_EQ(positionAfter(ease, 1000), 1);
    Motion distance = movingRadius(MotionKind::distance);
    distance.nearest = 2;
    distance.farthest = 4;
    distance.ease = Ease::linear;
    EXPECT_EQ(positionOf(distance, {0, 0.1}), 0);
    EXPECT_NEAR(positionOf(distance, {77, 3.5}), 0.75, 1e-12) << "whatever the clock says";
    EXPECT_EQ(positionOf(distance, {0, 50}), 1);
    distance.farthest = 2;
    EXPECT_EQ(positionOf(distance, {0, 2}), 1) << "no way between: at once";
}

TEST(Motions, ValuesGoAsAMorphDoesAndAreAlwaysLegal)
{
    const ParameterInfo& radius = movingParameters.rows()[movingParameters.radius.row];
    EXPECT_NEAR(std::get<double>(valueOf(radius, movingRadius(MotionKind::sine), {1, 0})), 1, 1e-12)
        << "halfway by factors";
    std::mt19937 random(7);
    const auto anyOf = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (const ParameterInfo& parameter : movingParameters.rows()) {
        if (!whyUnmoved(parameter).empty()) continue;
        for (int i = 0; i < 300; ++i) {
            Motion motion;
            motion.kind = static_cast<MotionKind>(i % static_cast<int>(motionKinds.size()));
            motion.ease = static_cast<Ease>(i % static_cast<int>(easeNames.size()));
            const auto anyEnd = [&]() -> Value {
                if (parameter.kind == Kind::color || parameter.kind == Kind::direction)
                    return glm::dvec3(anyOf(-2, 2), anyOf(-2, 2), anyOf(-2, 2));
                return anyOf(-10, 200);
            };
            motion.from = nearestLegal(parameter, anyEnd()).value_or(parameter.initial);
            motion.to = nearestLegal(parameter, anyEnd()).value_or(parameter.initial);
            motion.period = anyOf(shortestPeriod, 20);
            motion.phase = anyOf(-3, 3);
            const Value value = valueOf(parameter, motion, {anyOf(-100, 1e6), anyOf(0, 20)});
            EXPECT_EQ(nearestLegal(parameter, value), value) << parameter.name << ' ' << describe(parameter, motion);
        }
    }
}

TEST(Motions, FilesAndParametersOfAccuracyStandStillAndAllOthersOfEveryExhibitMayMove)
{
    EXPECT_FALSE(whyUnmoved(movingParameters.rows()[movingParameters.file.row]).empty());
    EXPECT_FALSE(whyUnmoved(movingParameters.rows()[movingParameters.samples.row]).empty());
    std::size_t moved = 0;
    for (const auto& exhibit : allExhibits()) {
        ParameterValues values = exhibit->parameters().initial();
        for (std::size_t i = 0; i < values.rows().size(); ++i) {
            const ParameterInfo& row = values.rows()[i];
            Motion motion;
            motion.from = row.initial;
            motion.to = row.kind == Kind::color || row.kind == Kind::direction ? Value(glm::dvec3(0, 1, 0))
                        : row.isWritten()                                      ? row.initial
                                                                               : Value(row.range.high);
            EXPECT_EQ(values.setMotion(i, motion), whyUnmoved(row).empty()) << exhibit->name() << ' ' << row.name;
            moved += values.motion(i) != nullptr;
        }
        const ParameterValues then = valuesAt(values, {1.3, 3});
        for (std::size_t i = 0; i < values.rows().size(); ++i)
            EXPECT_EQ(nearestLegal(values.rows()[i], then.row(i)), then.row(i)) << values.rows()[i].name;
        EXPECT_EQ(then.motions(), values.motions());
    }
    EXPECT_GT(moved, 200U);
}

TEST(Motions, WhatHasNoValuesBetweenIsSwitchedInTheMiddleAndSaysWhen)
{
    const ParameterInfo& method = movingParameters.rows()[movingParameters.method.row];
    for (const MotionKind kind : {MotionKind::ease, MotionKind::sine, MotionKind::triangle})
        for (int ease = 0; ease < 4; ++ease) {
            Motion motion;
            motion.kind = kind;
            motion.ease = static_cast<Ease>(ease);
            motion.from = 0.0;
            motion.to = 2.0;
            motion.phase = 0.1;
            double time = 0.3;
            for (int change = 0; change < 4; ++change) {
                const double until = nextChangeOf(method, motion, time);
                if (until == noChange) break;
                ASSERT_GT(until, 0);
                const Value before = valueOf(method, motion, {time + 0.99 * until, 0});
                EXPECT_EQ(before, valueOf(method, motion, {time, 0})) << "none before it is due";
                time += until + 1e-6;
                EXPECT_NE(valueOf(method, motion, {time, 0}), before);
            }
        }
}

TEST(Motions, OnlyWhatActsAndGoesByTheClockAsksForPictures)
{
    ParameterValues values = movingParameters.initial();
    EXPECT_EQ(nextMotion(values, 5), noChange);
    Motion distance = movingRadius(MotionKind::distance);
    values.setMotion(movingParameters.radius.row, distance);
    EXPECT_EQ(nextMotion(values, 5), noChange);
    Motion switched;
    switched.from = 0.0;
    switched.to = 1.0;
    values.setMotion(movingParameters.method.row, switched);
    EXPECT_EQ(nextMotion(values, 5), noChange) << "it waits for another row";
    values.set(movingParameters.lit, true);
    EXPECT_NEAR(nextMotion(values, 4.5), 0.5, 1e-12);
    values.setMotion(movingParameters.radius.row, movingRadius(MotionKind::sine));
    EXPECT_EQ(nextMotion(values, 5), 0);
    values.setMotion(movingParameters.radius.row, held(movingRadius(MotionKind::sine), {5, 0}));
    values.setMotion(movingParameters.method.row, std::nullopt);
    EXPECT_EQ(nextMotion(values, 6), noChange);
}

TEST(Motions, HeldStandStillAndGoOnFromThere)
{
    for (const MotionKind kind : {MotionKind::ease, MotionKind::sine, MotionKind::triangle, MotionKind::noise}) {
        const Motion moving = movingRadius(kind);
        const Motion still = held(moving, {1.3, 2});
        EXPECT_EQ(positionAfter(still, 1.3), positionAfter(moving, 1.3));
        EXPECT_EQ(positionAfter(still, 99), positionAfter(moving, 1.3));
        const Motion again = resumed(still, {99, 2});
        EXPECT_NEAR(positionAfter(again, 99), positionAfter(moving, 1.3), 1e-9);
        EXPECT_NEAR(positionAfter(again, 99.7), positionAfter(moving, 2.0), 1e-9);
    }
}

TEST(Motions, FilesBringThemBackOfEveryKind)
{
    for (std::size_t kind = 0; kind < motionKinds.size(); ++kind) {
        ParameterValues values = movingParameters.initial();
        Motion motion = movingRadius(static_cast<MotionKind>(kind));
        motion.heldAt = 2.5;
        if (kind == static_cast<std::size_t>(MotionKind::ease)) motion.start = 3;
        if (kind == static_cast<std::size_t>(MotionKind::noise)) motion.seed = 4000000000U;
        values.setMotion(movingParameters.radius.row, motion);
        const Preset written{"some", "A", values, std::nullopt, render::Json::object(), {}};
        const std::string text = presetText(written);
        EXPECT_NE(text.find("\"version\": 1"), std::string::npos) << text;
        const Preset read = parsePreset(text, "a.json", "some", movingParameters);
        EXPECT_TRUE(read.notes.empty()) << read.notes.front();
        ASSERT_TRUE(read.values.motion(movingParameters.radius.row));
        EXPECT_EQ(*read.values.motion(movingParameters.radius.row), motion) << text;
        EXPECT_EQ(presetText(read), text);
    }
}

/// Returns a preset with this animation of `radius`.
std::string fileWithMotion(const std::string& motion, const std::string& row = "radius")
{
    return "{\"format\": \"vitrine-preset\", \"version\": 1, \"exhibit\": \"some\", \"name\": \"A\", \"values\": {},\n"
           "\"motions\": {\"" +
           row + "\": " + motion + "}}";
}

TEST(Motions, AFileThatIsWrongSaysWhichKeyAndWhatToDo)
{
    const auto readFile = [](const std::string& text) { return parsePreset(text, "a.json", "some", movingParameters); };
    for (const char* part : {"a.json", "motions.radius.kind", "waltz", "choose one of ease, sine"})
        EXPECT_FAILURE(readFile(fileWithMotion("{\"kind\": \"waltz\"}")), part);
    EXPECT_FAILURE(readFile(fileWithMotion("{\"from\": 1}")), "\"kind\" is missing");
    for (const char* part : {"samples", "accuracy parameter cannot be animated"})
        EXPECT_FAILURE(readFile(fileWithMotion("{\"kind\": \"sine\"}", "samples")), part);
    const Preset odd =
        readFile(fileWithMotion("{\"kind\": \"sine\", \"from\": 1e9, \"to\": 2, \"period\": 0, \"x\": 1}"));
    EXPECT_EQ(odd.notes.size(), 3U) << "out of range, too short, unknown";
    EXPECT_EQ(odd.values.motion(movingParameters.radius.row)->period, shortestPeriod);
    EXPECT_EQ(readFile(fileWithMotion("{\"kind\": \"sine\"}", "tail")).notes.size(), 1U) << "kept and said";
}

TEST(Motions, AFileWithoutThemIsReadByOlderPrograms)
{
    const Preset still{"some", "A", movingParameters.initial(), std::nullopt, render::Json::object(), {}};
    EXPECT_NE(presetText(still).find("\"version\": 1"), std::string::npos);
    EXPECT_EQ(presetText(still).find("motions"), std::string::npos);
}

TEST(Motions, WhatNobodySeesAsksForNoPictures)
{
    const Museum museum{allExhibits()};
    const auto mug = museum.find("sdf_morph");
    ASSERT_TRUE(mug);
    SceneState sceneState = museum.initialSceneState();
    const auto morph = sceneState.values[*mug].table().find("morph");
    ASSERT_TRUE(morph);
    Motion motion;
    motion.from = 0.1;
    motion.to = 0.9;
    ASSERT_TRUE(sceneState.values[*mug].setMotion(*morph, motion));
    FrameRequest seen;
    seen.raster.size = {64, 36};
    seen.alone = mug;
    seen.camera = museum.subject(*mug).bestView(sceneState.values[*mug]);
    FrameRequest unseen = seen;
    unseen.camera.target = 2.0 * seen.camera.eye - seen.camera.target;  // Behind the visitor.
    EXPECT_EQ(test::nextChange(museum, museum.initialSceneState(), seen), noChange);
    EXPECT_EQ(test::nextChange(museum, sceneState, seen), 0);
    EXPECT_EQ(test::nextChange(museum, sceneState, unseen), noChange);
    const auto valueAt = [&](double time) {
        seen.time = time;
        return std::get<double>(museum.atMoment(sceneState, seen).values[*mug].row(*morph));
    };
    EXPECT_NEAR(valueAt(0), 0.1, 1e-12);
    EXPECT_NEAR(valueAt(2), 0.9, 1e-12);
    EXPECT_EQ(valueAt(1.234), valueAt(1.234));
}

Motion typed(const std::string& text)
{
    const ParameterInfo& row = movingParameters.rows()[movingParameters.width.row];
    return typedMotion(row, "--animate width", text,
                       [](const std::string& x) -> std::optional<Value> { return std::stod(x); });
}

TEST(TypedMotion, RefusesWhatContradictsItself)
{
    const auto refused = [](const std::string& text) { return test::refusalOf([&] { return typed(text); }); };
    EXPECT_EQ(refused("sine:1:2:period=4:period=5"), "--animate width: period= is given twice; remove one of them.");
    EXPECT_EQ(refused("triangle:1:2:ease=in:ease=in"), "--animate width: ease= is given twice; remove one of them.");
    for (const char* order :
         {"distance:1:2:nearest=5:farthest=1", "distance:1:2:farthest=1:nearest=5", "distance:1:2:farthest=0"})
        EXPECT_PRED_FORMAT2(testing::IsSubstring, "is before nearest=", refused(order));
    for (const char* number : {"nan", "inf", "-inf", "1e400", "", "0,5"})
        EXPECT_PRED_FORMAT2(testing::IsSubstring, "give a number from 0.01",
                            refused(std::string("sine:1:2:period=") + number));
    EXPECT_EQ(typed("distance:1:2:nearest=5:farthest=5").farthest, 5);
}

TEST(MotionsOfFiles, HaveTheirFarEndBehindTheirNearOne)
{
    const ParameterInfo& row = movingParameters.rows()[movingParameters.width.row];
    std::vector<std::string> notes;
    const auto motion = motionFromText(row, R"({"kind": "distance", "nearest": 5, "farthest": 1})", notes);
    ASSERT_TRUE(motion);
    EXPECT_EQ(motion->farthest, 5);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes.front(), "width.farthest 1 -> 5 (allowed 5 to 10000)");
}

}  // namespace
}  // namespace vitrine
