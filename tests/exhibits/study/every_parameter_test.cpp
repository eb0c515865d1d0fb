// All accuracy parameters of all exhibits and of the hall, studied like by the plain command: each study shows an
// error, or the table says why there is none.

#include "exhibits/study/study.h"
#include "tests/support/gallery.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace vitrine::study {
namespace {

using namespace test;

StudyRequest plainRequest(std::size_t subject, std::size_t row)
{
    StudyRequest request;
    request.subject = subject;
    request.sceneState = gallery().museum.initialSceneState();
    request.size = subject == hallIndex ? glm::ivec2(64, 36) : glm::ivec2(96, 54);
    request.views = 2;
    request.runs = 1;
    request.modelError = false;
    request.axes = {*studyAxis(request.sceneState, subject, row, 3)};
    return request;
}

StudyResult measured(const StudyRequest& request)
{
    Study study(gallery().museum, gallery().renderer, request);
    while (study.step()) {
    }
    return study.takeResult();
}

/// Result of a small study of one parameter.
struct Found {
    StudyResult result;
    double largest = 0;  ///< Error of the least exact value.
    double second = 0;   ///< Error of the second most exact value; for a choice, the largest.
    bool costs = false;  ///< Counted work differs between two values.
};

Found measure(std::size_t subject, std::size_t row)
{
    StudyRequest request = plainRequest(subject, row);
    StudyAxis& axis = request.axes.front();
    const ParameterInfo& info = parameterOf(request.sceneState, axis);
    const Exactness exact = exactness(info);
    // If a study checks its reference with a nearby value, that value need not be among its points, because the most
    // exact values take longest. Pictures in motion are not checked.
    const bool isChecked = !exact.neighbors.empty() && !studiesMotion(request);
    double nearest = exact.exact;
    if (info.isNumeric()) {
        std::vector<double> all = axis.values;
        std::erase(all, exact.exact);
        nearest = exact.neighbors.empty() ? (exact.exact > all.back() ? all.back() : all.front()) : exact.neighbors[0];
        axis.values = isChecked ? std::vector{all.front(), all.back()} : std::vector{all.front(), nearest};
        std::sort(axis.values.begin(), axis.values.end());
        axis.values.erase(std::unique(axis.values.begin(), axis.values.end()), axis.values.end());
    }
    Found found{.result = measured(request)};
    for (const StudyPoint& point : found.result.points) {
        found.largest = std::max(found.largest, point.error);
        found.costs = found.costs || point.counters != found.result.points.front().counters;
        if (!info.isNumeric() || axis.values[point.setting[0]] == nearest)
            found.second = std::max(found.second, point.error);
    }
    if (info.isNumeric() && isChecked) found.second = found.result.uncertainty;
    return found;
}

/// Prints a line of the table of all parameters: where each is studied, and the result.
void print(const std::string& name, const Found& found)
{
    std::string where;
    for (const std::string& view : found.result.views) where += (where.empty() ? "" : ", ") + view;
    std::string with;
    for (const StudyChange& change : found.result.changes) {
        const Parameters& table = gallery().museum.subject(change.row.subject).parameters();
        const ParameterInfo& row = table.rows()[change.row.row];
        with +=
            (with.empty() ? "" : ", ") + std::string(row.name) + ' ' +
            axisValueText(gallery().museum.initialSceneState(), {change.row.subject, change.row.row, {}}, change.to);
    }
    std::printf("| %s | %s | %s | %.3g | %.3g | %s |\n", name.c_str(), where.c_str(), with.c_str(), found.largest,
                found.second, found.costs ? "yes" : "no");
    std::fflush(stdout);
}

/// Accuracy parameters of a subject, or every second one of those whose study takes many minutes, so that both halves
/// run side by side.
struct StudiedRows {
    std::string subject;
    std::size_t first = 0, step = 1;
};

class EveryParameter : public GlTest, public testing::WithParamInterface<StudiedRows> {};

TEST_P(EveryParameter, ShowsItsErrorOrSaysWhyThereIsNone)
{
    const Museum& museum = gallery().museum;
    const std::size_t subject = museum.find(GetParam().subject).value();
    const Parameters& table = museum.subject(subject).parameters();
    std::size_t studied = 0;
    for (std::size_t row = 0; row < table.rows().size(); ++row) {
        const ParameterInfo& info = table.rows()[row];
        if (!info.qualityReference || studied++ % GetParam().step != GetParam().first) continue;
        const std::string name = GetParam().subject + '.' + std::string(info.name);
        SCOPED_TRACE(name);
        const StudiedParameter declared = StudiedParameters::of(table, info.name);
        const Found found = measure(subject, row);
        print(name, found);
        if (!declared.same.empty()) {
            EXPECT_EQ(found.largest, 0) << "declared to be the same";
            EXPECT_EQ(found.result.convergence, declared.same);
            continue;
        }
        EXPECT_GT(found.largest, 0) << "no value is wrong: declare where it shows, or why all are the same";
        if (declared.settles.empty()) {
            EXPECT_GT(found.second, 0) << "declare what limits it, or why it settles";
        }
    }
}

std::vector<StudiedRows> rowsOfAllSubjects()
{
    std::vector<StudiedRows> all{{"hall", 0, 2}, {"hall", 1, 2}};
    for (const std::unique_ptr<Exhibit>& exhibit : allExhibits()) {
        const std::string name(exhibit->name());
        const std::size_t parts = name == "sdf_scenes" ? 2 : 1;
        for (std::size_t part = 0; part < parts; ++part) all.push_back({name, part, parts});
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(Of, EveryParameter, testing::ValuesIn(rowsOfAllSubjects()), [](const auto& each) {
    return each.param.step == 1 ? each.param.subject : each.param.subject + '_' + std::to_string(each.param.first + 1);
});

using OneParameter = GlTest;

TEST_F(OneParameter, ShellsAreNotCappedByTheLevelOfDetail)
{
    const std::size_t fur = gallery().museum.find("fur").value();
    const Parameters& table = gallery().museum.subject(fur).parameters();
    StudyRequest request = plainRequest(fur, table.find("shellCount").value());
    request.size = {48, 27};
    request.views = 1;
    request.axes.front().values = {16, 40, 256};
    const StudyResult result = measured(request);
    ASSERT_EQ(result.points.size(), 3U);
    EXPECT_GT(result.points[0].error, result.points[1].error);
    EXPECT_GT(result.points[1].error, 0);
    EXPECT_EQ(result.points[2].error, 0);
    EXPECT_NE(result.points[1].counters, result.points[2].counters);
    EXPECT_GT(result.uncertainty, 0) << "128 shells are not 256";

    // With unchanged settings, level of detail draws as many shells for 40 as for 256.
    request.asSet = true;
    const StudyResult capped = measured(request);
    EXPECT_TRUE(capped.changes.empty());
    EXPECT_EQ(capped.points[1].error, 0);
}

}  // namespace
}  // namespace vitrine::study
