// Jobs: each job in the list, and one made in the test, behaves as its table declares.

#include "exhibits/exhibits.h"
#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/random_values.h"
#include "exhibits/framework/table/value_text.h"
#include "exhibits/jobs.h"
#include "exhibits/jobs/comparison/comparison_job.h"
#include "exhibits/jobs/comparison/comparison_table.h"
#include "exhibits/jobs/kit/command_line.h"
#include "exhibits/jobs/kit/given_values.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/printing/print_table.h"
#include "render/files/number_text.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "tests/kit/contact_job.h"
#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>
#include <set>
#include <sstream>

namespace vitrine {
namespace {

using namespace jobs;
using test::ContactJob;
using test::ContactTable;
using test::TemporaryFolder;

const ContactJob contact;

std::vector<const Job*> everyJob()
{
    std::vector<const Job*> every{&contact};
    for (const auto& job : allJobs()) every.push_back(job.get());
    return every;
}

/// Returns random values. Every written parameter that must be given, and half of the others, gets a text or path.
ParameterValues randomOf(const Job& job, RandomNumbers& random)
{
    ParameterValues values = randomValues(job.parameters(), random, 0.7);
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const ParameterInfo& parameter = values.rows()[i];
        if (!parameter.isWritten() || (!parameter.given.mustBeGiven && random.chance(0.5))) continue;
        values.setParameter(i, std::string(parameter.several ? "a b.png\nc=1,2.png" : "folder/a b.png"));
    }
    return values;
}

/// Returns the values that a command line of these words gives.
ParameterValues typedValues(const Job& job, const std::vector<std::string>& words,
                            std::optional<ParameterValues> document = std::nullopt)
{
    GivenValues given = document ? GivenValues(*document) : GivenValues(job.parameters());
    std::map<std::string, std::vector<std::string>> typed;
    std::vector<std::string> positional;
    for (const std::string& word : words) {
        const std::size_t equals = word.find('=');
        if (word.rfind("--", 0) != 0)
            positional.push_back(word);
        else if (equals == std::string::npos)
            typed[word] = {};
        else
            typed[word.substr(0, equals)].push_back(word.substr(equals + 1));
    }
    for (const JobOption& option : std::vector<JobOption>(given.options())) {
        if (option.positional && !positional.empty()) {
            const auto last = option.several ? positional.end() : positional.begin() + 1;
            given.type(option, {positional.begin(), last});
            positional.erase(positional.begin(), last);
        } else if (option.isFlag) {
            if (typed.erase(option.name) > 0) given.turn(option, true);
            if (typed.erase(withoutFlag(option)) > 0) given.turn(option, false);
        } else if (const auto found = typed.find(option.name); found != typed.end()) {
            given.type(option, found->second);
            typed.erase(found);
        }
    }
    EXPECT_TRUE(typed.empty() && positional.empty())
        << job.name() << " has no " << (typed.empty() ? "" : typed.begin()->first);
    return given.settled("vitrine " + std::string(job.name()));
}

/// Expects that `work` is refused as a usage error whose sentence contains `part`.
template <typename Work> void expectRefused(const Work& work, const std::string& part)
{
    EXPECT_PRED_FORMAT2(testing::IsSubstring, part.c_str(),
                        test::failureOf(
                            [&] {
                                work();
                                return 0;
                            },
                            ErrorKind::usage));
}

TEST(EveryJob, HasAnOptionAKeyAndAHelpTextForEachParameter)
{
    for (const Job* job : everyJob()) {
        std::set<std::string> names{"--out", "--like", "--dry-run", "--json", "--preset", "--help", "--language"};
        if (job->needs().hasScene() && !job->needs().twoSettings) names.insert("--set");
        if (job->needs().choosesSubject()) names.insert(job->needs().sceneByOption ? "--exhibit" : "exhibit");
        if (job->needs().anyScene)
            names.insert({"--settings-only", "--animate", "--time", "--seed", "--eye", "--target", "--fov", "--scale",
                          "--rotate", "--alone", "--transparent", "--environment", "--model"});
        if (job->needs().twoSettings)
            names.insert({"a", "b", "--exhibit", "--time", "--seed", "--eye", "--target", "--fov"});
        // A parameter takes the place of an option of the scene.
        for (const JobOption& option : optionsOf(job->parameters()))
            if (job->needs().anyScene && option.name == "--transparent") names.erase(option.name);
        if (!job->needs().report.empty()) names.insert("--report");
        if (job->needs().inParts) names.insert({"--shard", "--from-parts"});
        std::set<std::size_t> given;
        const render::Json schema = schemaOf(*job);
        const render::Json initial = jsonOf(job->parameters().initial());
        for (const JobOption& option : optionsOf(job->parameters())) {
            EXPECT_TRUE(names.insert(option.name).second) << job->name() << " has two " << option.name;
            if (option.isFlag) {
                EXPECT_TRUE(names.insert(withoutFlag(option)).second) << job->name() << ' ' << option.name;
            }
            given.insert(option.parameters.begin(), option.parameters.end());
            EXPECT_FALSE(helpText(job->parameters(), option).empty()) << job->name() << ' ' << option.name;
            EXPECT_EQ(typeText(job->parameters(), option).empty(), option.isFlag) << job->name() << ' ' << option.name;
            ASSERT_TRUE(schema["properties"].contains(option.key)) << job->name() << ' ' << option.key;
            EXPECT_FALSE(schema["properties"][option.key]["description"].get<std::string>().empty());
            EXPECT_TRUE(initial.contains(option.key)) << job->name() << ' ' << option.key;
            EXPECT_EQ(schema["properties"][option.key].contains("default"), !option.mustBeGiven);
        }
        EXPECT_EQ(given.size(), job->parameters().rows().size()) << job->name();
        EXPECT_EQ(schema["properties"].size(), initial.size()) << job->name();
        EXPECT_EQ(findJob(job->name()), job == &contact ? nullptr : job);
    }
    EXPECT_EQ(findJob("nothing"), nullptr);
}

/// Returns what is hard to read in a label; empty: nothing.
std::string unclearWord(const std::string& label)
{
    // Units and abbreviations as a name without spaces has them, and words that say nothing alone.
    static const std::set<std::string> shortened{"kb",  "mb",  "gb",  "px",  "mm",  "cm",  "um",  "ms",  "hz",  "dpi",
                                                 "lpi", "fps", "deg", "num", "max", "min", "res", "pos", "dir", "idx"};
    static const std::set<std::string> alone{"set", "with", "find", "every", "alone", "use", "as",
                                             "at",  "by",   "from", "to",    "of",    "for", "godot"};
    std::istringstream words(label);
    std::string all;
    for (std::string word; words >> word;) {
        if (shortened.contains(word)) return word;
        word.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(word.front())));
        if (all.empty() && shortened.contains(word)) return word;
        all += (all.empty() ? "" : " ") + word;
    }
    return alone.contains(all) ? all : std::string();
}

TEST(EveryJob, HasLabelsOfPlainWords)
{
    for (const Job* job : everyJob())
        for (const ParameterInfo& parameter : job->parameters().rows())
            EXPECT_EQ(unclearWord(label(parameter)), "") << job->name() << ": " << label(parameter);
    // Control: such labels are found.
    EXPECT_EQ(unclearWord("Memory mb"), "mb");
    EXPECT_EQ(unclearWord("Set"), "set");
    EXPECT_EQ(unclearWord("Dpi"), "dpi");
    EXPECT_EQ(unclearWord("Memory limit in MB"), "");
}

TEST(EveryJob, ReadsRandomValuesBackFromItsCommandLine)
{
    for (const Job* job : everyJob()) {
        RandomNumbers random(3);
        for (int i = 0; i < 300; ++i) {
            // Parameters without effect are not typed.
            const ParameterValues values = actingValues(randomOf(*job, random));
            const std::vector<std::string> words = wordsOf(values);
            std::string line;
            for (const std::string& word : words) line += word + ' ';
            EXPECT_EQ(actingValues(typedValues(*job, words)), values) << job->name() << ": " << line;
        }
    }
}

TEST(EveryJob, ReadsRandomValuesBackFromItsDocument)
{
    for (const Job* job : everyJob()) {
        RandomNumbers random(4);
        for (int i = 0; i < 100; ++i) {
            const ParameterValues values = randomOf(*job, random);
            const std::string text = documentText(*job, {values}, {{"Frames", 3.0}});
            const JobDocument read = parseDocument(text, "a.json", *job, nullptr);
            EXPECT_EQ(read.values, values) << text;
            EXPECT_TRUE(read.notes.empty()) << job->name() << ": " << (read.notes.empty() ? "" : read.notes.front());
        }
    }
}

TEST(EveryJob, ReadsWritesAndShowsEveryWord)
{
    for (const Job* job : everyJob())
        for (const JobOption& option : optionsOf(job->parameters()))
            for (const std::size_t i : option.parameters)
                for (const Word& word : job->parameters().rows()[i].words) {
                    const ParameterInfo& parameter = job->parameters().rows()[i];
                    EXPECT_EQ(readWord(option.name, parameter, std::string(word.text)), Value(word.value));
                    EXPECT_EQ(typedText(parameter, word.value), word.text);
                    const render::Json json = jsonFromValue(parameter, word.value);
                    EXPECT_TRUE(json.is_string() || std::isfinite(json.get<double>())) << parameter.name;
                }
}

TEST(JobOptions, RefuseWhatIsOutOfRangeWithTheRange)
{
    const auto refused = [](const std::vector<std::string>& words, const std::string& part) {
        std::vector<std::string> all{"a.png", "--title=T"};
        all.insert(all.end(), words.begin(), words.end());
        expectRefused([&] { static_cast<void>(typedValues(contact, all)); }, part);
    };
    refused({"--columns=65"}, "--columns \"65\": give a whole number from 1 to 64, or auto.");
    refused({"--columns=2.5"}, "--columns \"2.5\": give a whole number");
    refused({"--border-mm=60"}, "--border-mm \"60\": give a number from 0 to 50 mm.");
    refused({"--border-mm=6cm"}, "from 0 to 50 mm.");
    refused({"--border-mm=0,5"}, "write 0.5.");
    refused({"--dpi=0"}, "give a number from 1 to 10000, or none, or screen.");
    refused({"--dpi=inf"}, "give a number");
    refused({"--tile-size=20"}, "--tile-size \"20\": give WIDTHxHEIGHT, such as 16x12.");
    refused({"--tile-size=20x99999"}, "--tile-size 20x99999 \"99999\": give a whole number from 1 to 4096.");
    refused({"--source=paper"}, "--source \"paper\": give one of pictures, folder.");
    refused({"--paper=white"}, "--paper white: give #rrggbb or r,g,b.");
    expectRefused([&] { static_cast<void>(typedValues(contact, {"a.png"})); }, "`vitrine contact` needs --title;");
}

TEST(JobOptions, TakeNumbersInTheirUnitOrWithOneOfTheirOwn)
{
    const ContactTable t;
    const auto typed = [](const std::string& word) { return typedValues(contact, {"a.png", "--title=T", word}); };
    EXPECT_EQ(typed("--border-mm=3")[t.borderWidth], 0.003);
    EXPECT_EQ(typed("--border-mm=0.3cm")[t.borderWidth], 0.003);
    EXPECT_EQ(typed("--border-mm=50")[t.borderWidth], 0.05);
    EXPECT_DOUBLE_EQ(typed("--turn=90")[t.turn], std::acos(0.0));
    EXPECT_DOUBLE_EQ(typed("--turn=-90")[t.turn], -std::acos(0.0));
    EXPECT_EQ(typed("--turn=180")[t.turn], contact.parameters().rows()[t.turn.row].range.high);
    EXPECT_EQ(typed("--dpi=none")[t.pixelsPerInch], std::numeric_limits<double>::infinity());
    EXPECT_EQ(typed("--dpi=screen")[t.pixelsPerInch], -1);
    EXPECT_EQ(typed("--tile-size=7x9")[t.height], 9);
    EXPECT_FALSE(typed("--no-border")[t.border]);
    const ParameterValues several = typedValues(contact, {"a.png", "b.png", "--title=T"});
    EXPECT_EQ(several[t.pictures], "a.png\nb.png");
}

TEST(JobOptions, ATupleWithAFileTakesTwoWords)
{
    const Job& job = *findJob("print");
    const printing::PrintTable& t = printing::printTable();
    const auto typed = [&](const std::string& grid) {
        GivenValues given(t.initial());
        given.type(optionOf(given.options(), t.quilt.row), {grid, "a b.png"});
        return given.settled({});
    };
    for (const char* grid : {"3x40", "3X40", "3×40"}) {
        const ParameterValues values = typed(grid);
        EXPECT_EQ(values[t.quiltColumns], 3) << grid;
        EXPECT_EQ(values[t.quiltRows], 40) << grid;
        EXPECT_EQ(values[t.quilt], "a b.png");
        EXPECT_EQ(values[t.origin], printing::ViewOrigin::quilt);
        EXPECT_EQ(jsonOf(values)["quilt"], render::Json::array({3, 40, "a b.png"}));
    }
    expectRefused([&] { static_cast<void>(typed("many")); },
                  "--quilt \"many\": give COLUMNSxROWS FILE, such as --quilt 8x6 quilt.png.");
    expectRefused([&] { static_cast<void>(typed("0x4")); }, "--quilt 0x4 \"0\": give a whole number from 1 to 1000.");
    EXPECT_EQ(typeText(job.parameters(), optionOf(optionsOf(t), t.quilt.row)), "COLUMNSxROWS FILE");
}

TEST(JobOptions, SetWhatTheyImply)
{
    const ContactTable t;
    const ParameterValues folder = typedValues(contact, {"--folder=f", "--title=T"});
    EXPECT_EQ(folder[t.source], test::ContactSource::folder);
    expectRefused(
        [&] {
            static_cast<void>(typedValues(contact, {"a.png", "--folder=f", "--title=T"}));
        },
        "pictures and --folder exclude each other; give one of them.");
    // The other way round, on top of a document: typed words override its values.
    const ParameterValues pictures = typedValues(contact, {"a.png"}, folder);
    EXPECT_EQ(pictures[t.source], test::ContactSource::pictures);
    EXPECT_EQ(pictures[t.folder], "f");
    EXPECT_EQ(pictures[t.title], "T");
}

TEST(JobOptions, RefuseWhatHasNoEffectAndSayWhatWouldGiveItOne)
{
    const auto refused = [](const std::vector<std::string>& words, const std::string& part) {
        std::vector<std::string> all{"a.png", "--title=T"};
        all.insert(all.end(), words.begin(), words.end());
        expectRefused([&] { static_cast<void>(typedValues(contact, all)); }, part);
    };
    refused({"--no-border", "--border-mm=3"}, "--border-mm has no effect without --border;");
    refused({"--source=pictures", "--folder=f"}, "--folder has no effect without --source folder;");
    // In a document, the value without effect is no error.
    ParameterValues values = typedValues(contact, {"--folder=f", "--title=T"});
    EXPECT_NO_THROW(static_cast<void>(typedValues(contact, {"--source=pictures"}, values)));
}

TEST(JobDocument, IsRefusedWithFileLineAndKey)
{
    const ContactTable t;
    ParameterValues values(contact.parameters());
    values.set(t.title, std::string("T"));
    const std::string good = documentText(contact, {values}, {});
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    const auto refused = [&](const std::string& text, const std::string& part) {
        EXPECT_FAILURE(static_cast<void>(parseDocument(text, "a.json", contact, nullptr)), part);
    };
    EXPECT_NO_THROW(static_cast<void>(parseDocument(good, "a.json", contact, nullptr)));
    refused("{}", "a.json: this is no settings document");
    refused("[1]", "this is no settings document");
    refused(with("\"version\": 1", "\"version\": 2"), "version: this document is newer");
    refused(with("\"version\": 1", "\"version\": true"), "version: this must be a whole number");
    refused(with("\"contact\"", "\"print\""), "job: this document is not of the job contact");
    refused(with("\"border\"", "\"bordre\""), "values.bordre: there is no such parameter; did you mean border?");
    refused(with("[16, 12]", "[16]"), "values.tileSize: this must be an array of 2 values");
    refused(with("[16, 12]", "\"16x12\""), "values.tileSize");
    refused(with("\"border\": true", "\"border\": 1"), "values.border: this must be true or false");
    const JobDocument read = parseDocument(with("[16, 12]", "[16, 99999]"), "a.json", contact, nullptr);
    EXPECT_EQ(read.values[t.height], 4096);
    ASSERT_EQ(read.notes.size(), 1U);
    EXPECT_NE(read.notes.front().find("tileSize 99999 -> 4096"), std::string::npos) << read.notes.front();
}

/// Writes a gray picture into the folder and returns its path.
std::string pictureIn(const TemporaryFolder& folder, const std::string& name, float gray)
{
    const std::string file = folder / name;
    render::writePicture(file, render::Image(4, 4, 3, gray), render::PictureFormat::png8);
    return file;
}

/// Backend of these tests.
class TestBackend final : public render::RenderBackend {
public:
    render::FrameReport draw(const render::FramePlan& plan) override { return renderer_.draw(plan); }
    [[nodiscard]] render::Image read(const std::string& image) override { return renderer_.read(image); }
    [[nodiscard]] const render::PersistentState& persistentState() const override
    {
        return renderer_.persistentState();
    }
    [[nodiscard]] int largestSide() const override { return renderer_.largestSide(); }

private:
    render::gl::HeadlessContext context_;
    render::gl::Renderer renderer_;
};

/// Returns the name of an output of the job: "out.png", or "out" for a folder.
std::string outOf(const Job& job)
{
    const auto extensions = job.needs().extensions;
    return extensions.empty() ? "out" : "out." + std::string(extensions.front());
}

/// Returns whether the job measures times, which differ from run to run. Its own test runs it.
bool isMeasured(const Job& job)
{
    return job.needs().answers;
}

/// Small orders, one for each job that needs no output of another job.
struct SmallOrders {
    SmallOrders()
    {
        pictureIn(inputs, "a.png", 0.2F);
        pictureIn(inputs, "b.png", 0.6F);
        test::writeBytes(inputs / "ball.json",
                         R"({"format": "vitrine-scene", "version": 1, "root": {"kind": "sphere", "radius": 0.2}})");
    }
    /// Returns the order of a job; nothing if it has none.
    std::optional<JobOrder> of(const Job& job) const
    {
        const std::map<std::string_view, std::vector<std::string>> words{
            {"contact", {inputs / "a.png", inputs / "b.png", "--title=T"}},
            {"mesh", {inputs / "ball.json", "--cell=5cm"}},
            {"print",
             {"--views=" + (inputs / "a.png").string(), "--views=" + (inputs / "b.png").string(), "--lpi=40",
              "--dpi=100", "--width-mm=20", "--height-mm=15"}},
            {"record", {"--turn=360", "--seconds=0.5", "--fps=4", "--size=32x18", "--samples=1"}},
            {"sprite", {"--directions=2", "--frames=1", "--size=12x10"}},
            {"study", {"hitTolerance", "--values=1,4", "--views=1", "--runs=1", "--size=16x9", "--alone"}}};
        const auto found = words.find(job.name());
        if (found == words.end()) return std::nullopt;
        JobOrder order{typedValues(job, found->second)};
        order.inputs = job.read(order.values);
        if (!job.needs().subject.empty())
            order.scene = {&museum, museum.initialSceneState(), museum.find(job.needs().subject).value(), {}};
        if (job.needs().choosesSubject() && !job.needs().sceneByOption) {
            const std::size_t shown = museum.find("sdf_morph").value();
            order.scene = {&museum, museum.initialSceneState(), shown, {}};
            order.scene.frame.alone = shown;
            order.scene.frame.camera = museum.subject(shown).bestView(order.scene.state.values[shown]);
        }
        order.backend = [] { return std::make_unique<TestBackend>(); };
        return order;
    }

    TemporaryFolder inputs;
    Museum museum{allExhibits()};
};

TEST(LongEveryJob, WritesExactlyThePlannedFilesAndItsDocumentRunsItAgain)
{
    const SmallOrders small;
    int ran = 0;
    for (const Job* job : everyJob()) {
        const std::optional<JobOrder> order = small.of(*job);
        if (!order || isMeasured(*job)) continue;
        const TemporaryFolder folder, again;
        JobOrder whole = *order;
        whole.out = folder / outOf(*job);
        const auto runTo = [&](JobOrder all) {
            const JobPlan plan = job->plan(all.values, all.scene, *all.inputs, all.out);
            EXPECT_EQ(plan.refusal, "") << job->name();
            const auto run = job->start(std::move(all));
            while (run->next() != JobRun::Next::done) run->step([](double) { return true; });
            run->publish();
            std::vector<std::filesystem::path> planned;
            for (const PlannedFile& file : plan.files) planned.push_back(file.path);
            EXPECT_EQ(run->report().files, planned) << job->name();
            return planned.size();
        };
        const std::size_t files = runTo(whole);
        EXPECT_EQ(folder.files().size(), files) << job->name();
        ++ran;
        if (job->needs().carriesSettings) continue;  // It has no document of its own.
        const JobDocument read = readDocument(whole.out, *job, whole.scene.museum);
        EXPECT_EQ(read.values, whole.values);
        EXPECT_EQ(read.out, whole.out);
        EXPECT_EQ(read.scene.values, whole.scene.state.values) << job->name();
        JobOrder second = *order;
        second.values = read.values;
        if (second.scene.museum) second.scene.state = read.scene;
        second.out = again / whole.out.filename().string();
        runTo(second);
        for (const std::string& file : folder.files())
            EXPECT_EQ(test::bytesOf(folder / file), test::bytesOf(again / file)) << job->name() << ' ' << file;
    }
    EXPECT_EQ(ran, 5);
}

TEST(EveryJob, MakesOrAsksForTheFolderOfItsOutputBeforeItBegins)
{
    const SmallOrders small;
    int made = 0, refused = 0;
    for (const Job* job : everyJob()) {
        const std::optional<JobOrder> order = small.of(*job);
        if (!order) continue;
        const TemporaryFolder folder;
        JobOrder whole = *order;
        whole.out = folder / "new/folder" / outOf(*job);
        try {
            requireWritable(*job, whole);
            EXPECT_TRUE(std::filesystem::is_directory(folder / "new/folder")) << job->name();
            ++made;
        } catch (const Failure& why) {
            EXPECT_NE(std::string(why.what()).find(outOf(*job)), std::string::npos) << why.what();
            EXPECT_TRUE(folder.files().empty()) << job->name();
            ++refused;
        }
        // A file where a folder should be is refused for each of them.
        test::writeBytes(folder / "file", "");
        whole.out = folder / "file/folder" / outOf(*job);
        EXPECT_THROW(requireWritable(*job, whole), Failure) << job->name();
    }
    EXPECT_EQ(made, 1);  // The study.
    EXPECT_EQ(refused, 5);

    const Job& record = *findJob("record");
    JobOrder frames = small.of(record).value();
    const TemporaryFolder folder;
    frames.out = folder / "new/%04d.png";
    requireWritable(record, frames);
    EXPECT_TRUE(std::filesystem::is_directory(folder / "new"));
}

TEST(EveryJob, LeavesNothingWhereItIsCanceledAfterAnyStep)
{
    const SmallOrders small;
    for (const Job* job : everyJob()) {
        const std::optional<JobOrder> order = small.of(*job);
        if (!order || isMeasured(*job)) continue;
        bool isDone = false;
        for (int steps = 0; !isDone; ++steps) {
            const TemporaryFolder folder;
            {
                JobOrder whole = *order;
                whole.out = folder / outOf(*job);
                const auto run = job->start(std::move(whole));
                for (int i = 0; i < steps && run->next() != JobRun::Next::done; ++i) {
                    run->step([](double) { return true; });
                    EXPECT_GE(run->progress(), 0);
                    EXPECT_LE(run->progress(), 1);
                }
                isDone = run->next() == JobRun::Next::done;
            }
            EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << job->name() << " after " << steps << " steps";
        }
    }
}

TEST(LongEveryJob, PlansRandomValuesWithoutItsFilesAndTheSameOnAnyThread)
{
    std::map<const Job*, JobOrder> orders;
    const Museum museum{allExhibits()};
    {
        const SmallOrders small;
        for (const Job* job : everyJob())
            if (auto order = small.of(*job)) orders.emplace(job, std::move(*order));
    }  // The files are gone.
    for (auto& [job, order] : orders) {
        order.scene = {};
        RandomNumbers random(5);
        for (int i = 0; i < 200; ++i) {
            const ParameterValues values = randomOf(*job, random);
            const auto plan = [&, job = job, &inputs = *order.inputs] {
                return job->plan(values, {}, inputs, outOf(*job));
            };
            auto other = std::async(std::launch::async, plan);
            EXPECT_EQ(plan(), other.get()) << job->name();
        }
    }
}

TEST(RecordJob, TellsFramesAndWhatCannotBeBeforeItStarts)
{
    const Job& job = *findJob("record");
    const SmallOrders small;
    const JobOrder order = small.of(job).value();
    const auto planned = [&](const std::vector<std::string>& words, const std::string& out = {}) {
        return job.plan(typedValues(job, words), order.scene, *order.inputs, out);
    };
    const JobPlan plan = planned({"--seconds=2.5", "--fps=12", "--size=40x20"});
    EXPECT_EQ(plan.refusal, "");
    EXPECT_EQ(plan.facts, (std::vector<Fact>{{"Frames", 30.0}, {"Frame size", "40 × 20", "px"}}));
    EXPECT_TRUE(plan.files.empty());
    const auto refused = [&](const std::vector<std::string>& words, const std::string& out, const std::string& part) {
        EXPECT_PRED_FORMAT2(testing::IsSubstring, part.c_str(), planned(words, out).refusal);
    };
    refused({"--size=33x18"}, "a.mp4", "34x18");
    refused({"--fps=60"}, "a.gif", "50");
    refused({}, "a.avi", "a.avi: give a name that ends in .mp4, ");
    refused({}, "a.png", "frames/%04d.png");
    refused({"--path=tour"}, "", "A tour needs the hall");
    refused({"--path=bookmarks"}, "", "A tour needs the hall");
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "the frames so far are whole", planned({}, "f/%02d.png").ifStopped);
    EXPECT_EQ(planned({}, "a.mp4").ifStopped, "Stopped; nothing was written.");
}

TEST(LongRecordJob, PreviewsFramesAlongItsPathAndJudgesTheSizeOfItsFile)
{
    const Job& job = *findJob("record");
    const SmallOrders small;
    JobOrder order = small.of(job).value();
    order.values = typedValues(job, {"--turn=360", "--seconds=1", "--fps=8", "--size=480x270", "--samples=1"});
    const ParameterValues whole = order.values;
    order.values = job.draft(whole, *order.inputs);
    const ParameterValues drawn = order.values;
    const auto run = job.start(std::move(order));
    int draws = 0;
    for (; run->next() != JobRun::Next::done; run->step([](double) { return true; }))
        draws += run->next() == JobRun::Next::draw ? 1 : 0;
    EXPECT_EQ(draws, 8);  // Six frames, and the one after two of them.
    // Two columns and three rows of 240 x 136 pixels, 2 apart.
    const render::Image picture = run->previewPicture();
    EXPECT_EQ(glm::ivec2(picture.width, picture.height), glm::ivec2(2 * 240 + 2, 3 * 136 + 4));
    const auto isAlike = [&](int frame, int other) {
        for (int y = 0; y < 136; ++y)
            for (int x = 0; x < 240; ++x)
                for (int c = 0; c < 3; ++c)
                    if (picture.at(frame % 2 * 242 + x, frame / 2 * 138 + y, c) !=
                        picture.at(other % 2 * 242 + x, other / 2 * 138 + y, c))
                        return false;
        return true;
    };
    for (int i = 1; i < 6; ++i) EXPECT_FALSE(isAlike(0, i)) << i;  // The camera turns.
    const auto megabytes = [&](const char* out) {
        const JobForecast forecast = job.forecast(whole, {drawn, *run, 1}, out);
        if (forecast.facts.size() != 1) return -1.0;
        EXPECT_EQ(forecast.facts[0].label, "File about");
        return std::get<double>(forecast.facts[0].value) * (forecast.facts[0].unit == "kB" ? 1e-3 : 1);
    };
    // Less than without compression, and more than nothing.
    for (const char* out : {"a.mp4", "a.webm", "a.gif", "a.webp", "a.apng", "f/%04d.png"}) {
        EXPECT_GT(megabytes(out), 0.001) << out;
        EXPECT_LT(megabytes(out), 8 * 480 * 270 * 3 / 1e6) << out;
    }
    EXPECT_EQ(megabytes("a.avi"), -1);
}

TEST(RecordJob, UsesTheCameraWhereItTurnsOrStays)
{
    const Job& job = *findJob("record");
    const SmallOrders small;
    JobScene scene = small.of(job)->scene;
    const auto uses = [&](const std::vector<std::string>& words) {
        return job.usesCamera(typedValues(job, words), scene);
    };
    EXPECT_TRUE(uses({}));
    EXPECT_TRUE(uses({"--path=still"}));
    EXPECT_FALSE(uses({"--path=tour"}));
    EXPECT_FALSE(uses({"--path=bookmarks"}));
    EXPECT_FALSE(uses({"--tour=a.json"}));
    scene.subject = hallIndex;
    EXPECT_FALSE(uses({})) << "a tour of the hall";
    EXPECT_TRUE(uses({"--turn=20"})) << "which implies the turntable";
    // The command line of a tour contains no camera, because the command would refuse it.
    JobOrder order{typedValues(job, {"--path=tour"}), scene};
    const auto holds = [&](const std::string& option) {
        const std::vector<std::string> words = commandOf(job, order);
        return std::any_of(words.begin(), words.end(), [&](const std::string& w) { return w.rfind(option, 0) == 0; });
    };
    EXPECT_FALSE(holds("--eye="));
    EXPECT_TRUE(holds("--time="));
    order.values = typedValues(job, {"--path=still"});
    EXPECT_TRUE(holds("--eye="));
}

TEST(JobDocument, OfAnySceneHoldsWhatIsShownAndHow)
{
    const Job& job = *findJob("record");
    const SmallOrders small;
    JobOrder order = small.of(job).value();
    order.scene.frame.time = 1.5;
    order.scene.frame.seed = 7;
    order.scene.frame.transparent = true;
    order.scene.usual.samples = 9;
    const JobDocument read = parseDocument(documentText(job, order, {}), "a.json", job, order.scene.museum);
    EXPECT_EQ(read.chosen, "sdf_morph");
    ASSERT_TRUE(read.taken);
    EXPECT_TRUE(read.taken->alone);
    EXPECT_TRUE(read.taken->transparent);
    EXPECT_EQ(read.taken->time, 1.5);
    EXPECT_EQ(read.taken->seed, 7U);
    EXPECT_EQ(read.taken->samples, 9);
    ASSERT_TRUE(read.taken->camera);
    EXPECT_EQ(*read.taken->camera, order.scene.frame.camera);
    EXPECT_EQ(read.scene.values, order.scene.state.values);
    EXPECT_TRUE(read.notes.empty());
}

TEST(ComparisonJob, PlansTwoSettingsOrSaysWhatIsMissing)
{
    const Museum museum{allExhibits()};
    const ComparisonJob job;
    ParameterValues values(job.parameters());
    JobScene scene{&museum, museum.initialSceneState(), museum.find("sdf_morph").value(), {}};
    const auto planned = [&] { return job.plan(values, scene, *job.read(values), "out"); };
    const auto refusedWith = [&](const char* part) {
        EXPECT_PRED_FORMAT2(testing::IsSubstring, part, planned().refusal);
    };
    refusedWith("no settings B");
    values.set(comparisonTable().with, std::string("mesh"));
    EXPECT_EQ(planned().refusal, "");
    EXPECT_EQ(planned().facts.back(), (Fact{"Parameters that differ", 1.0}));
    EXPECT_EQ(planned().offers.at("with"), (std::vector<std::string>{"", "mesh", "field", "cost"}));
    EXPECT_EQ(planned().files.front().path, "out");
    scene.other = OtherSettings{scene.state, "B"};
    refusedWith("not both");
    values.set(comparisonTable().with, std::string());
    EXPECT_EQ(planned().facts.back(), (Fact{"Parameters that differ", 0.0}));
    scene.other.reset();
    values.set(comparisonTable().with, std::string("soup"));
    refusedWith("mesh, field, cost");
    scene.subject = hallIndex;
    refusedWith("--exhibit");
}

TEST(ComparisonJob, KeepsBothSettingsInItsDocument)
{
    const Museum museum{allExhibits()};
    const ComparisonJob job;
    const std::size_t shown = museum.find("sdf_morph").value();
    const std::size_t morph = museum.subject(shown).parameters().find("morph").value();
    JobOrder order{ParameterValues(job.parameters()), {&museum, museum.initialSceneState(), shown, {}}};
    order.scene.name = "soft.json";
    order.scene.frame.time = 2;
    order.scene.state.values[shown].setParameter(morph, 0.25);
    order.scene.other = OtherSettings{museum.initialSceneState(), "hard.json"};
    order.scene.other->state.values[shown].setParameter(morph, 0.75);
    const JobDocument read = parseDocument(documentText(job, order, {}), "a.json", job, &museum);
    EXPECT_EQ(read.values, order.values);
    EXPECT_EQ(read.scene.values, order.scene.state.values);
    EXPECT_EQ(read.chosen, "sdf_morph");
    EXPECT_EQ(read.name, "soft.json");
    ASSERT_TRUE(read.taken);
    EXPECT_EQ(read.taken->time, 2);
    ASSERT_TRUE(read.other);
    EXPECT_EQ(read.other->name, "hard.json");
    EXPECT_EQ(read.other->state.values, order.scene.other->state.values);
}

TEST(JobRun, StopsWhereItsWatchSaysSo)
{
    const SmallOrders small;
    for (const Job* job : {static_cast<const Job*>(&contact), findJob("mesh")}) {
        const auto run = job->start(*small.of(*job));
        EXPECT_THROW(run->step([](double) { return false; }), Stopped) << job->name();
    }
}

TEST(Mesh, RefusesByItsFirstReasonAndSaysWhereNothingIsSolid)
{
    const SmallOrders small;
    const Job& mesh = *findJob("mesh");
    const auto ordered = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{small.inputs / "ball.json", "--cell=1cm"};
        words.insert(words.end(), more.begin(), more.end());
        JobOrder order{typedValues(mesh, words)};
        order.inputs = mesh.read(order.values);
        return order;
    };
    const JobOrder twice = ordered({"--time=2", "--high=1,1,1"});
    EXPECT_EQ(mesh.plan(twice.values, {}, *twice.inputs, "a.png").refusal,
              "--time has no effect on a scene in which nothing moves; leave it out.");
    const auto expectNothing = [&](const char* low, const char* high, ErrorKind kind, const std::string& sentence) {
        const auto run = mesh.start(ordered({"--low=" + std::string(low), "--high=" + std::string(high)}));
        const auto runAll = [&] {
            while (run->next() != JobRun::Next::done) run->step([](double) { return true; });
            return 0;
        };
        EXPECT_PRED_FORMAT2(testing::IsSubstring, sentence.c_str(), test::failureOf(runAll, kind));
    };
    expectNothing("1,1,1", "2,2,2", ErrorKind::usage, "Nothing of the scene lies between --low and --high;");
    // In a corner of the box around the ball: 0.26 m from its center.
    expectNothing("0.15,0.15,0.15", "0.2,0.2,0.2", ErrorKind::check, "Nothing solid lies between --low and --high;");
}

TEST(Fact, ShowsThreeDigitsAndItsUnit)
{
    EXPECT_EQ(valueText({"Frames", 1234567.0}), "1234567");
    EXPECT_EQ(valueText({"Volume", 0.5235987, "m³"}), "0.524 m³");
    EXPECT_EQ(valueText({"Sheet", "62 × 120", "px"}), "62 × 120 px");
}

}  // namespace
}  // namespace vitrine
