#include "tests/ui/sample_tables.h"

#include "ui/controllers/control.h"
#include "ui/controllers/takeover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace vitrine;
using namespace vitrine::ui;

/// Returns the only move that these bytes of MIDI give; nullopt: none.
std::optional<ControlMove> midi(std::vector<unsigned char> bytes)
{
    const std::vector<ControlMove> moves = decode({.bytes = std::move(bytes)});
    EXPECT_LE(moves.size(), 1U);
    return moves.empty() ? std::nullopt : std::optional(moves.front());
}

TEST(ControlDecoding, ReadsControlChangesKeysAndPitchBend)
{
    // Bytes as in table 1 of the MIDI 1.0 specification: 0xBn controller value.
    const auto fader = midi({0xb0, 21, 127});
    ASSERT_TRUE(fader);
    EXPECT_EQ(fader->control, (Control{Control::Kind::controlChange, 1, 21, {}}));
    EXPECT_EQ(fader->position, 1);
    EXPECT_DOUBLE_EQ(midi({0xbf, 0, 64})->position, 64 / 127.0);
    EXPECT_EQ(midi({0xbf, 0, 64})->control.channel, 16);
    const auto pressed = midi({0x93, 60, 5}), released = midi({0x93, 60, 0}), off = midi({0x83, 60, 90});
    ASSERT_TRUE(pressed && released && off);
    EXPECT_EQ(pressed->control, (Control{Control::Kind::note, 4, 60, {}}));
    EXPECT_EQ(pressed->control, off->control);
    EXPECT_EQ(pressed->position, 1);  // A soft touch is a press.
    EXPECT_EQ(released->position, 0);
    EXPECT_EQ(off->position, 0);
    EXPECT_EQ(midi({0xe1, 0, 0})->position, 0);
    EXPECT_EQ(midi({0xe1, 127, 127})->position, 1);
    EXPECT_NEAR(midi({0xe1, 0, 64})->position, 0.5, 1e-4);  // Middle position: 8192 of 16383.
}

TEST(ControlDecoding, IgnoresOtherAndDamagedMessages)
{
    for (const std::vector<unsigned char>& bytes : std::vector<std::vector<unsigned char>>{{},
                                                                                           {0xb0},
                                                                                           {0xb0, 21},
                                                                                           {0xb0, 21, 200},
                                                                                           {0xb0, 200, 1},
                                                                                           {0xb0, 123, 0},
                                                                                           {0xc0, 5},
                                                                                           {0xf8},
                                                                                           {0x40, 1, 2},
                                                                                           {0xf0, 1, 2},
                                                                                           {0xb0, 1, 2, 3},
                                                                                           {0xd0, 3, 3}})
        EXPECT_FALSE(midi(bytes));
}

TEST(ControlDecoding, ReadsEachNumberOfAnOscMessage)
{
    const auto moves = decode({.address = "/pad/xy", .numbers = {0.25, 7}});
    ASSERT_EQ(moves.size(), 2U);
    EXPECT_EQ(moves[0].control, (Control{Control::Kind::osc, 1, 0, "/pad/xy"}));
    EXPECT_EQ(moves[0].position, 0.25);
    EXPECT_EQ(moves[1].control.channel, 2);
    EXPECT_EQ(moves[1].position, 1);  // Clamped.
    EXPECT_FALSE(moves[0].alone);
    EXPECT_TRUE(decode({.address = "/fader/1", .numbers = {0.5}}).front().alone);
}

TEST(ControlDecoding, IgnoresNumbersAndAddressesThatAreNone)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(decode({.address = "/a", .numbers = {nan}}).empty());
    EXPECT_TRUE(decode({.address = "/a", .numbers = {HUGE_VAL}}).empty());
    for (const char* address : {"/", "a", "/a b", "/a*", "/a\n", "/ä", "/@Variant("})
        EXPECT_TRUE(decode({.address = address, .numbers = {0.5}}).empty()) << address;
    EXPECT_TRUE(decode({.address = '/' + std::string(longestOscAddress, 'a'), .numbers = {0.5}}).empty());
    EXPECT_EQ(decode({.address = "/a", .numbers = std::vector<double>(100, 0.5)}).size(), mostOscNumbers);
}

TEST(ControlTexts, GiveTheSameControlAgain)
{
    for (const Control& control :
         {Control{Control::Kind::osc, 2, 0, "/fader/3"}, Control{Control::Kind::controlChange, 16, 119, {}},
          Control{Control::Kind::note, 1, 127, {}}, Control{Control::Kind::pitchBend, 7, 0, {}}})
        EXPECT_EQ(controlFrom(controlText(control)), control) << controlText(control);
    EXPECT_EQ(controlText({Control::Kind::controlChange, 1, 21, {}}), "cc 1 21");
    for (const char* text : {"", "cc", "cc 1", "cc 0 21", "cc 17 21", "cc 1 120", "cc 1 21 3", "cc 1 21x", "cc -1 2",
                             "bend", "bend 1 2", "osc 1", "osc 1 fader", "osc 17 /a", "osc 0 /a", "knob 1 2"})
        EXPECT_FALSE(controlFrom(text)) << text;
}

struct TakeoverTest : testing::Test {
    test::SampleTable table;
    Takeover takeover;
    [[nodiscard]] const ParameterInfo& info(std::string_view name) const { return table.rows()[*table.find(name)]; }
    /// Moves the control and gives its value to the parameter. Returns the parameter's value.
    double moved(std::string_view name, double& present, double position)
    {
        if (const auto value = takeover.move(info(name), present, position)) present = std::get<double>(*value);
        return present;
    }
};

TEST_F(TakeoverTest, TheValueStaysUntilTheControlPassesIt)
{
    double present = 0.6;
    for (const double position : {0.1, 0.3, 0.55}) {
        EXPECT_EQ(moved("roughness", present, position), 0.6);
        EXPECT_EQ(takeover.waitingAt(present), position);
    }
    EXPECT_DOUBLE_EQ(moved("roughness", present, 0.7), 0.7);  // It has passed 0.6 on the way.
    EXPECT_FALSE(takeover.waitingAt(present));
    EXPECT_DOUBLE_EQ(moved("roughness", present, 0.2), 0.2);
}

TEST_F(TakeoverTest, TouchingIsEnoughAndOneStepBesideIsNot)
{
    for (int at = 0; at <= 127; ++at) {
        Takeover each;
        const double present = 0.5;
        // The nearest two of the 128 positions of a control are half a step away.
        EXPECT_EQ(each.move(info("roughness"), present, at / 127.0).has_value(), at == 63 || at == 64) << at;
    }
}

TEST_F(TakeoverTest, AValueThatSomethingElseChangesIsLeftAlone)
{
    double present = 0.5;
    moved("roughness", present, 0.4);
    moved("roughness", present, 0.55);
    ASSERT_DOUBLE_EQ(present, 0.55);
    present = 0.9;  // By hand, or undone.
    EXPECT_EQ(takeover.waitingAt(present), 0.55);
    EXPECT_EQ(moved("roughness", present, 0.7), 0.9);
    EXPECT_EQ(moved("roughness", present, 0.6), 0.9);
    EXPECT_DOUBLE_EQ(moved("roughness", present, 0.95), 0.95);
}

TEST_F(TakeoverTest, AValueBeyondTheSliderIsTakenOverAtItsEnd)
{
    double present = 4;  // The slider ends at 0.5, the legal range at 5.
    EXPECT_EQ(moved("speed", present, 0.9), 4);
    EXPECT_EQ(moved("speed", present, 1), 0.5);
}

TEST_F(TakeoverTest, LogarithmicParametersFollowTheirSlider)
{
    EXPECT_NEAR(std::get<double>(valueAt(info("tubeRadius"), 0.5)), std::sqrt(0.002 * 0.1), 1e-4);
    for (const double position : {0.0, 0.25, 0.5, 1.0})
        EXPECT_NEAR(positionOf(info("tubeRadius"), valueAt(info("tubeRadius"), position)), position, 0.01);
}

TEST_F(TakeoverTest, SwitchesAndChoicesShareTheWay)
{
    EXPECT_EQ(std::get<double>(valueAt(info("animated"), 0.49)), 0);
    EXPECT_EQ(std::get<double>(valueAt(info("animated"), 0.5)), 1);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(std::get<double>(valueAt(info("material"), (i + 0.5) / 3)), i);
        EXPECT_DOUBLE_EQ(positionOf(info("material"), double(i)), (i + 0.5) / 3);
    }
    EXPECT_EQ(std::get<double>(valueAt(info("material"), 1)), 2);
    // A key that is pressed and released has passed the value; from then on each press switches.
    double on = 1;
    moved("animated", on, 1);  // As it is on already, this touches.
    EXPECT_EQ(moved("animated", on, 0), 0);
    EXPECT_EQ(moved("animated", on, 1), 1);
}

TEST_F(TakeoverTest, OnlyNumbersSwitchesAndChoicesCanBeMoved)
{
    for (const char* name : {"morph", "animated", "material", "tubeRadius"}) EXPECT_TRUE(isMovable(info(name))) << name;
    for (const char* name : {"baseColor", "lightDirection", "environment"}) EXPECT_FALSE(isMovable(info(name))) << name;
}

}  // namespace
