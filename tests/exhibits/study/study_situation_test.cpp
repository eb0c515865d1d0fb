// Situation of a study: settings and views in which its parameters have an effect, according to the tables.

#include "exhibits/framework/table/acting.h"
#include "exhibits/study/study_situation.h"
#include "tests/support/museum_on_paper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace vitrine::study {
namespace {

using namespace test;

StudyRequest requestOf(std::string_view subject, const std::vector<std::string>& rows)
{
    StudyRequest request;
    request.subject = museum().find(subject).value();
    request.sceneState = museum().initialSceneState();
    for (const std::string& row : rows) {
        const std::size_t index = request.sceneState.values[request.subject].table().find(row).value();
        request.axes.push_back(*studyAxis(request.sceneState, request.subject, index, 3));
    }
    return request;
}

StudySituation situationOf(const StudyRequest& request)
{
    return studySituation(museum().subjects(), request);
}

std::vector<std::string> sentencesOf(const StudyRequest& request)
{
    StudyResult result;
    result.changes = situationOf(request).changes;
    return situationSentences(museum().subjects(), request, result);
}

std::string valueOf(const StudySituation& situation, const StudyRequest& request, std::string_view row)
{
    const ParameterValues& values = situation.sceneState.values[request.subject];
    const std::size_t index = values.table().find(row).value();
    return axisValueText(situation.sceneState, {request.subject, index, {}}, std::get<double>(values.row(index)));
}

TEST(StudySituation, TablesDeclareParametersAndViewsThatTheyHave)
{
    for (const auto* subject : museum().subjects()) {
        const Parameters& table = subject->parameters();
        const auto isQuality = [&](std::string_view name) {
            const auto row = table.find(name);
            return row && table.rows()[*row].qualityReference.has_value();
        };
        const std::vector<StudyView> views = subject->studyViews(table.initial());
        std::vector<std::string_view> seen;
        for (const StudiedParameter& declared : StudiedParameters::allOf(table)) {
            SCOPED_TRACE(std::string(subject->name()) + '.' + std::string(declared.name));
            EXPECT_TRUE(isQuality(declared.name)) << "studies have nothing to say of it";
            EXPECT_EQ(std::find(seen.begin(), seen.end(), declared.name), seen.end()) << "declared twice";
            seen.push_back(declared.name);
            for (const std::string_view name : declared.lifted) EXPECT_TRUE(isQuality(name)) << name;
            for (const std::string_view name : declared.exactInReference) EXPECT_TRUE(isQuality(name)) << name;
            const auto expectLegal = [](const Parameters& changed, const StudiedParameter::Setting& setting) {
                const auto row = changed.find(setting.row);
                ASSERT_TRUE(row) << setting.row;
                EXPECT_EQ(nearestLegal(changed.rows()[*row], setting.value), Value(setting.value)) << setting.row;
            };
            for (const StudiedParameter::Setting& setting : declared.with) expectLegal(table, setting);
            for (const StudiedParameter::Setting& setting : declared.hall)
                expectLegal(museum().subject(hallIndex).parameters(), setting);
            for (const std::string_view name : declared.views)
                EXPECT_TRUE(std::any_of(views.begin(), views.end(), [&](const StudyView& view) {
                    return view.name == name;
                })) << name;
            EXPECT_TRUE(declared.same.empty() || declared.same.back() == '.') << declared.same;
            EXPECT_TRUE(declared.settles.empty() || declared.settles.back() == '.') << declared.settles;
        }
    }
}

TEST(StudySituation, EveryAccuracyParameterActsInEveryViewOfItsStudy)
{
    int studied = 0;
    for (std::size_t subject = 0; subject < museum().subjects().size(); ++subject) {
        const SceneState initial = museum().initialSceneState();
        for (const StudyAxis& axis : qualityAxes(initial, subject, 3)) {
            StudyRequest request;
            request.subject = subject;
            request.sceneState = initial;
            request.axes = {axis};
            SCOPED_TRACE(std::string(museum().subject(subject).name()) + '.' +
                         std::string(parameterOf(initial, axis).name));
            const StudySituation situation = situationOf(request);
            ASSERT_FALSE(situation.views.empty());
            for (const StudyView& view : situation.views) {
                EXPECT_TRUE(acts(view.values, axis.row)) << view.name;
                for (const StudyChange& change : situation.changes) {
                    const ParameterValues& changed =
                        change.row.subject == subject ? view.values : situation.sceneState.values[change.row.subject];
                    EXPECT_EQ(changed.row(change.row.row), Value(change.to)) << view.name;
                    EXPECT_TRUE(acts(changed, change.row.row)) << "a change without effect";
                }
            }
            ++studied;
        }
    }
    EXPECT_GT(studied, 80);
}

TEST(StudySituation, WhatCapsAParameterIsLiftedAndNamed)
{
    const StudyRequest request = requestOf("fur", {"shellCount"});
    EXPECT_EQ(valueOf(situationOf(request), request, "levelOfDetail"), "off");
    EXPECT_EQ(
        sentencesOf(request),
        std::vector<std::string>{"Studied with “levelOfDetail” at off instead of on, which would limit “shellCount”."});
}

TEST(StudySituation, WhatTheUserNamedStaysAndIsSaidToLimit)
{
    StudyRequest request = requestOf("fur", {"shellCount"});
    request.pinned = {
        {request.subject, request.sceneState.values[request.subject].table().find("levelOfDetail").value()}};
    EXPECT_TRUE(situationOf(request).changes.empty());
    const std::vector<std::string> sentences = sentencesOf(request);
    ASSERT_EQ(sentences.size(), 1U);
    EXPECT_EQ(sentences[0], "“levelOfDetail” at on limits “shellCount”: see the error against everything exact.");

    request.pinned.clear();
    request.asSet = true;
    EXPECT_TRUE(situationOf(request).changes.empty());
    EXPECT_EQ(sentencesOf(request), sentences);
}

TEST(StudySituation, ASearchForTheBestSettingKeepsTheSettingsThatItIsFor)
{
    StudyRequest request = requestOf("fur", {"shellCount"});
    request.maxError = 0.1;
    EXPECT_TRUE(situationOf(request).changes.empty());
    request = requestOf("noise", {"cloudSteps"});
    EXPECT_FALSE(situationOf(request).changes.empty());
    request.axes = qualityAxes(request.sceneState, request.subject);
    EXPECT_TRUE(situationOf(request).changes.empty());
}

TEST(StudySituation, AParameterGoesToTheWorkInWhichItActs)
{
    const StudyRequest request = requestOf("noise", {"bakeSize"});
    const StudySituation situation = situationOf(request);
    EXPECT_EQ(valueOf(situation, request, "work"), "clouds");
    EXPECT_EQ(sentencesOf(request),
              std::vector<std::string>{"Studied with “work” at clouds instead of sea, so that “bakeSize” acts."});
    EXPECT_EQ(valueOf(situation, request, "look"), "physically based") << "no more than it takes";
    EXPECT_EQ(request.sceneState, museum().initialSceneState()) << "the user's settings are a copy";
}

TEST(StudySituation, WhatIsStudiedItselfIsNotSetForTheOther)
{
    const StudyRequest request = requestOf("sdf_scenes", {"shadowMethod", "shadowRays"});
    EXPECT_TRUE(situationOf(request).changes.empty()) << "the rays are varied with each method";
}

TEST(StudySituation, ViewsThatShowNothingAreLeftOut)
{
    // In one of the fur's views the motion is set by hand, so no spring moves.
    const StudyRequest request = requestOf("fur", {"springModel"});
    for (const StudyView& view : situationOf(request).views) EXPECT_NE(view.name, "spin of 120 degrees");
}

TEST(StudySituation, ItsSettingsAreListedAsOptionsThatLeadToTheSameOne)
{
    StudyRequest request = requestOf("noise", {"cloudSteps"});
    const std::size_t elevation = request.sceneState.values[request.subject].table().find("sunElevation").value();
    request.sceneState.values[request.subject].setParameter(elevation, 0.25);
    StudyResult result;
    result.changes = situationOf(request).changes;
    EXPECT_EQ(settingsToRepeat(museum().subjects(), request, result),
              (std::vector<std::string>{"work=clouds", "sunElevation=0.25"}));
}

enum class ShadowKind : int { none, soft, hard };

struct ActingTable final : Parameters {
    Toggle light = toggle("light", true, "Lights it.");
    Choice<ShadowKind> kind = choice("kind", ShadowKind::none, {"none", "soft", "hard"}, "Of shadow.", when(light));
    Real width = real("width", 0.0, none, {0, 1}, "Of the light.");
    File picture = file("picture", "Of something.");
    Count rays = count("rays", 4, {1, 64}, "More is exact.", quality(64),
                       (when(kind, ShadowKind::soft) && whenAbove(width, 0)) || when(kind, ShadowKind::hard));
    Count texels = count("texels", 4, {1, 64}, "More is exact.", quality(64), whenGiven(picture));
};

TEST(MakeAct, ChangesAsFewParametersAsItTakesAndNoneThatIsFixed)
{
    const ActingTable table;
    ParameterValues values = table.initial();
    ASSERT_TRUE(makeAct(values, table.rays.row, {}));
    EXPECT_EQ(values[table.kind], ShadowKind::hard) << "one change, not two";
    EXPECT_EQ(values[table.width], 0);

    values = table.initial();
    values.set(table.light, false);
    ASSERT_TRUE(makeAct(values, table.rays.row, {}));
    EXPECT_TRUE(values[table.light]) << "what the condition looks at has to act, too";

    values = table.initial();
    const std::array<std::size_t, 1> fixed{table.kind.row};
    EXPECT_FALSE(makeAct(values, table.rays.row, fixed));
    EXPECT_EQ(values, table.initial());
    EXPECT_FALSE(makeAct(values, table.texels.row, {})) << "nobody chooses a file for the user";
    EXPECT_EQ(values, table.initial());
}

}  // namespace
}  // namespace vitrine::study
