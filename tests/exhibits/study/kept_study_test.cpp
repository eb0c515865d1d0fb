// Kept studies: reading their files, refused files, and storage on disk.

#include "exhibits/study/kept_parameters.h"
#include "exhibits/study/study.h"
#include "exhibits/study/study_store.h"
#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "tests/exhibits/study/known_law.h"
#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace vitrine::study {
namespace {

using namespace test;
using render::Json;

/// Test with a finished study of an exhibit with a known law.
class KeptStudies : public testing::Test {
protected:
    static std::vector<std::unique_ptr<Exhibit>> exhibits()
    {
        std::vector<std::unique_ptr<Exhibit>> all;
        all.push_back(std::make_unique<KnownExhibit>(sumOfParts()));
        return all;
    }
    /// Returns the result, measured once for all tests.
    [[nodiscard]] static const StudyResult& measured(const Museum& museum, const StudyRequest& request)
    {
        static const StudyResult result = [&] {
            KnownBackend backend;
            Study study(museum, backend, request);
            while (study.step()) {
            }
            return study.result();
        }();
        return result;
    }
    void SetUp() override
    {
        request_.sceneState = museum_.initialSceneState();
        request_.axes.push_back(*studyAxis(request_.sceneState, 1, *table_.find("steps"), 6));
        request_.size = {16, 9};
        request_.alone = true;
        result_ = measured(museum_, request_);
        json_ = studyJson(museum_.subjects(), request_, result_, Json{{"renderer", "the painter"}, {"processors", 2}});
    }
    [[nodiscard]] static KeptStudy parsed(const Json& json)
    {
        return parseStudy(render::parseJson(render::writeJson(json), "study.json", studyLimits));
    }

    KnownTable table_;
    Museum museum_{exhibits()};
    StudyRequest request_;
    StudyResult result_;
    Json json_;
    TemporaryFolder folder_;
    StudyStore store_{folder_ / "studies", folder_ / "trash"};
};

TEST_F(KeptStudies, ComeBackAsTheyWereMeasured)
{
    const KeptStudy kept = parsed(json_);
    EXPECT_EQ(kept.exhibit, "known");
    EXPECT_EQ(kept.renderer, "the painter");
    EXPECT_EQ(kept.processors, 2);
    EXPECT_EQ(kept.cost, result_.costName);
    EXPECT_EQ(kept.views, result_.views);
    EXPECT_EQ(kept.front, result_.front);
    EXPECT_EQ(kept.knee, result_.knee);
    EXPECT_EQ(kept.clock, "the law");
    EXPECT_TRUE(kept.complete);
    ASSERT_EQ(kept.points.size(), result_.points.size());
    for (std::size_t i = 0; i < kept.points.size(); ++i) {
        EXPECT_EQ(kept.points[i].error, result_.points[i].error);
        EXPECT_EQ(kept.points[i].worstError, result_.points[i].worstError);
        EXPECT_EQ(kept.points[i].cost, result_.points[i].cost);
        EXPECT_EQ(kept.points[i].time->median, result_.points[i].time->median);
        EXPECT_EQ(kept.points[i].counters.at("work"), static_cast<double>(result_.points[i].counters.at("work")));
        EXPECT_EQ(kept.pointText(i), pointText(museum_.subjects(), request_, result_.points[i]));
    }
    EXPECT_EQ(kept.sentences, std::vector<std::string>{result_.convergence});
}

TEST_F(KeptStudies, GiveTheirValuesToTheParametersThatAreThere)
{
    const KeptStudy kept = parsed(json_);
    const SceneState look = museum_.initialSceneState();
    const KeptParameters rows = parametersOf(kept, museum_.subjects(), look);
    ASSERT_TRUE(rows.all());
    std::string wrong;
    for (std::size_t i = 0; i < kept.points.size(); ++i) {
        const auto values = valuesOf(kept, i, rows, look, wrong);
        ASSERT_TRUE(values);
        EXPECT_EQ(values->at(0), Value(request_.axes[0].values[result_.points[i].setting[0]]));
    }
    KeptStudy other = kept;
    other.exhibit = "unknown";
    EXPECT_EQ(parametersOf(other, museum_.subjects(), look).missingExhibit, "unknown");
    other = kept;
    other.parameters[0].name = "strides";
    EXPECT_EQ(parametersOf(other, museum_.subjects(), look).missingParameter, "strides");
    other = kept;
    other.points[0].values[0] = 1e9;  // Beyond the parameter's range.
    EXPECT_FALSE(valuesOf(other, 0, rows, look, wrong));
    EXPECT_EQ(wrong, "steps");
}

TEST_F(KeptStudies, DamagedFilesAreRefusedWithFileAndKey)
{
    const auto expectRefusal = [&](const std::string& pointer, const Json& value, const std::string& key) {
        Json damaged = json_;
        damaged[Json::json_pointer(pointer)] = value;
        try {
            (void)parsed(damaged);
            ADD_FAILURE() << pointer << " was taken";
        } catch (const Failure& failure) {
            EXPECT_NE(std::string(failure.what()).find("study.json"), std::string::npos) << failure.what();
            EXPECT_NE(std::string(failure.what()).find(key), std::string::npos) << failure.what();
        }
    };
    expectRefusal("/format", "vitrine-preset", "format");
    expectRefusal("/version", 99, "version");
    expectRefusal("/name", std::string(5000, 'x'), "name");
    expectRefusal("/measured", "yesterday", "measured");
    expectRefusal("/size", Json::array({16}), "size");
    expectRefusal("/size/0", 1e12, "size[0]");
    expectRefusal("/views", Json::array(), "views");
    expectRefusal("/metric", "beauty", "metric");
    expectRefusal("/machine", "mine", "machine");
    expectRefusal("/clock", Json::object(), "clock");
    expectRefusal("/front/0", 1000, "front[0]");
    expectRefusal("/front/0", -1, "front[0]");
    expectRefusal("/points", Json::array(), "points");
    expectRefusal("/points/1", 3, "points[1]");
    expectRefusal("/points/1/values", Json::object(), "points[1].values");
    expectRefusal("/points/1/error", "small", "points[1].error");
    expectRefusal("/points/1/modelError", "much", "points[1].modelError");
    expectRefusal("/points/1/cost", -2, "points[1].cost");
    expectRefusal("/points/1/uncertain", 1, "points[1].uncertain");
    expectRefusal("/points/1/counters/work", "much", "points[1].counters.work");
    expectRefusal("/points/1/ms/interval", Json::array({1e9, 2e9}), "points[1].ms.interval");
    expectRefusal("/points/1/ms/confidence", 7, "points[1].ms.confidence");
    for (const auto& [key, value] : json_.items()) {
        Json damaged = json_;
        damaged[key] = Json::array({Json::object()});
        const bool unread = key == "app" || key == "errorsAreOf" || key == "pixelsPerDegree" || key == "timing";
        if (unread)
            EXPECT_NO_THROW((void)parsed(damaged)) << key;
        else
            EXPECT_THROW((void)parsed(damaged), Failure) << key;
    }
    EXPECT_THROW((void)parseStudy(render::parseJson("[]", "study.json", studyLimits)), Failure);
    EXPECT_THROW((void)render::parseJson(std::string(17U << 20U, ' '), "study.json", studyLimits), Failure);
}

TEST_F(KeptStudies, AreListedTheNewestFirstRenamedDeletedAndBroughtBack)
{
    const auto older = store_.keep(json_, "2026-11-24T10:00:00", true);
    const auto newer = store_.keep(json_, "2026-11-25T10:00:00", false);
    std::vector<StudyEntry> all = store_.list();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].path, newer);
    EXPECT_FALSE(all[0].study.complete);
    store_.rename(older, "Before the grid");
    EXPECT_EQ(readStudy(older).name, "Before the grid");
    EXPECT_EQ(readStudy(older).points.size(), result_.points.size());
    const RemovedDocument removed = store_.remove(older);
    EXPECT_EQ(store_.list().size(), 1U);
    EXPECT_EQ(readStudy(store_.restore(removed)).name, "Before the grid");
    store_.rename(older, "");
    EXPECT_EQ(readStudy(older).name, "");

    // An unreadable file is listed and left alone.
    writeBytes(folder_ / "studies/broken.json", "{\"format\": ");
    all = store_.list();
    ASSERT_EQ(all.size(), 3U);
    EXPECT_NE(all[2].problem.find("broken.json"), std::string::npos);
    EXPECT_FAILURE(store_.rename(all[2].path, "X"), "broken.json");
    EXPECT_EQ(bytesOf(folder_ / "studies/broken.json"), "{\"format\": ");
}

TEST_F(KeptStudies, TheOldestWithoutANameMakeRoom)
{
    const StudyStore small(folder_ / "studies", folder_ / "trash", {3, 1U << 20U});
    const auto first = small.keep(json_, "2026-11-01T10:00:00", true);
    small.rename(first, "Mine");
    const auto second = small.keep(json_, "2026-11-02T10:00:00", true);
    const auto third = small.keep(json_, "2026-11-03T10:00:00", true);
    const auto fourth = small.keep(json_, "2026-11-04T10:00:00", true);
    EXPECT_TRUE(std::filesystem::exists(first)) << "it has a name";
    EXPECT_FALSE(std::filesystem::exists(second));
    for (const auto& path : {third, fourth}) small.rename(path, "Mine, too");
    EXPECT_FAILURE(small.keep(json_, "2026-11-05T10:00:00", true), "not kept");
    EXPECT_EQ(small.list().size(), 3U);

    const auto bytes = std::filesystem::file_size(first);
    const StudyStore tight(folder_ / "tight", folder_ / "trash", {100, 2 * bytes + bytes / 2});
    const auto old = tight.keep(json_, "2026-11-01T10:00:00", true);
    (void)tight.keep(json_, "2026-11-02T10:00:00", true);
    (void)tight.keep(json_, "2026-11-03T10:00:00", true);
    EXPECT_EQ(tight.list().size(), 2U);
    EXPECT_FALSE(std::filesystem::exists(old));
}

TEST_F(KeptStudies, KeepTheirPictures)
{
    const auto path = store_.keep(json_, "2026-11-25T10:00:00", true);
    EXPECT_TRUE(store_.pictures(path, readStudy(path)).empty()) << "none were kept";
    store_.keepPictures(path, ContactSheet());
    EXPECT_TRUE(store_.pictures(path, readStudy(path)).empty()) << "an empty sheet is none";
    store_.keepPictures(path, contactSheet(result_));
    const auto expectAll = [&](const std::filesystem::path& study) {
        const ContactSheet sheet = store_.pictures(study, readStudy(study));
        ASSERT_EQ(sheet.views, result_.references.size());
        ASSERT_EQ(sheet.points, result_.points.size());
        for (std::size_t view = 0; view < sheet.views; ++view) {
            const auto expectSame = [&](const render::Image& kept, const render::Image& drawn) {
                ASSERT_EQ(kept.width, drawn.width);
                ASSERT_EQ(kept.height, drawn.height);
                for (int y = 0; y < drawn.height; ++y)
                    for (int x = 0; x < drawn.width; ++x)
                        for (int c = 0; c < 3; ++c) ASSERT_EQ(kept.at(x, y, c), drawn.at(x, y, c));
            };
            expectSame(sheet.reference(view), result_.references[view]);
            for (std::size_t i = 0; i < sheet.points; ++i)
                expectSame(sheet.picture(i, view), result_.points[i].shots[view].picture);
        }
        // Settings differ in these pictures, so mixing them up would be detected.
        EXPECT_NE(sheet.picture(0, 0).pixels, sheet.picture(sheet.points - 1, 0).pixels);
    };
    expectAll(path);
    store_.rename(path, "With pictures");
    const RemovedDocument removed = store_.remove(path);
    EXPECT_TRUE(std::filesystem::is_empty(folder_ / "studies"));
    expectAll(store_.restore(removed));

    // Pictures of another study, or of none.
    KeptStudy other = readStudy(path);
    other.points.pop_back();
    EXPECT_FAILURE(store_.pictures(path, other), "does not hold the pictures");
    std::filesystem::path file = path;
    writeBytes(file.replace_extension(".pictures.exr"), "no picture");
    EXPECT_FAILURE(store_.pictures(path, readStudy(path)), ".pictures.exr");
}

TEST_F(KeptStudies, ThePicturesOfTheOldestWithoutANameMakeRoom)
{
    const auto picturesOf = [](std::filesystem::path path) { return path.replace_extension(".pictures.exr"); };
    const ContactSheet sheet = contactSheet(result_);
    const auto first = store_.keep(json_, "2026-11-01T10:00:00", true);
    store_.keepPictures(first, sheet);
    const std::uintmax_t bytes = std::filesystem::file_size(picturesOf(first));
    const StudyStore tight(folder_ / "studies", folder_ / "trash", {3, 32U << 20U, 2 * bytes + bytes / 2});
    tight.rename(first, "Mine");
    const auto second = tight.keep(json_, "2026-11-02T10:00:00", true);
    tight.keepPictures(second, sheet);
    const auto third = tight.keep(json_, "2026-11-03T10:00:00", true);
    tight.keepPictures(third, sheet);
    EXPECT_TRUE(std::filesystem::exists(picturesOf(first))) << "it has a name";
    EXPECT_FALSE(std::filesystem::exists(picturesOf(second)));
    EXPECT_TRUE(std::filesystem::exists(second)) << "its numbers stay";
    EXPECT_TRUE(std::filesystem::exists(picturesOf(third)));
    // Pictures of named studies are kept, so the new ones are dropped.
    tight.rename(third, "Mine, too");
    EXPECT_FAILURE(tight.keepPictures(second, sheet), "were not kept");
    EXPECT_FALSE(std::filesystem::exists(picturesOf(second)));
    EXPECT_TRUE(std::filesystem::exists(picturesOf(first)) && std::filesystem::exists(picturesOf(third)));
    // Removing a study for space removes its pictures.
    const auto fourth = tight.keep(json_, "2026-11-04T10:00:00", true);
    EXPECT_FALSE(std::filesystem::exists(second));
    tight.rename(third, "");
    const auto fifth = tight.keep(json_, "2026-11-05T10:00:00", true);
    EXPECT_FALSE(std::filesystem::exists(third) || std::filesystem::exists(picturesOf(third)));
    EXPECT_TRUE(std::filesystem::exists(fourth) && std::filesystem::exists(fifth));
}

TEST_F(KeptStudies, FromElsewhereAreCopiedOnceUnderTheNameOfTheirFolder)
{
    const auto file = folder_ / "coarse march/study.json";
    writeBytes(file, render::writeJson(json_));
    const auto added = store_.add(file);
    ASSERT_EQ(added.size(), 1U);
    EXPECT_EQ(readStudy(added[0]).name, "coarse march");
    EXPECT_EQ(store_.add(file), added);
    EXPECT_EQ(store_.list().size(), 1U);

    const auto several = folder_ / "several.json";
    writeBytes(several, render::writeJson(studiesJson({named(json_, "A"), named(json_, "B")})));
    EXPECT_EQ(store_.add(several).size(), 2U);
    EXPECT_EQ(store_.list().size(), 3U);
    Json broken = studiesJson({named(json_, "C"), json_});
    broken["studies"][1]["points"][0]["cost"] = "soup";
    writeBytes(several, render::writeJson(broken));
    EXPECT_FAILURE(store_.add(several), "studies[1].points[0].cost");
    EXPECT_EQ(store_.list().size(), 3U) << "nothing of it was taken";
}

TEST_F(KeptStudies, NamesAreCutBetweenCharacters)
{
    std::string name;
    for (int i = 0; i < 120; ++i) name += "ä";
    const std::string kept = named(json_, name)["name"].get<std::string>();
    EXPECT_EQ(kept.size(), 200U);
    EXPECT_NO_THROW((void)parsed(named(json_, name + "x")));
    std::string odd = "x" + name;
    EXPECT_EQ(named(json_, odd)["name"].get<std::string>().size(), 199U);
}

TEST_F(KeptStudies, AreATableOfOneLineForEachPoint)
{
    const std::string csv = keptCsv({parsed(named(json_, "A, or \"B\"")), parsed(json_)});
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), 1 + 2 * result_.points.size());
    const std::string line = "\n\"A, or \"\"B\"\"\",,known,the painter,16,9,3," + parsed(json_).pointText(0) + ",rmse,";
    EXPECT_NE(csv.find(line), std::string::npos) << csv.substr(0, 600);
    EXPECT_NE(csv.substr(0, csv.find('\n')).find(",work,"), std::string::npos);
}

}  // namespace
}  // namespace vitrine::study
