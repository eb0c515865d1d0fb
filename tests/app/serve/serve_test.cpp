// `vitrine serve`: its answers equal those of the command line exactly. One server for all tests of the suite.

#include "app/serve/base64.h"
#include "app/serve/json_rpc.h"
#include "exhibits/jobs.h"
#include "exhibits/jobs/kit/job_options.h"
#include "tests/app/serve/served_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace vitrine {
namespace {

using render::Json;
using namespace test;

/// Returns the error message of an answer.
std::string messageOf(const Json& answer)
{
    return answer.contains("error") ? answer["error"]["message"].get<std::string>() : answer.dump();
}

/// Converts the error of the command line to the service's form.
std::string asServed(const Ended& ended)
{
    EXPECT_EQ(ended.err.rfind("vitrine: ", 0), 0U) << ended.err;
    return app::withoutDashes(ended.err.substr(9, ended.err.size() - 10));
}

class Serve : public testing::Test {
protected:
    static void SetUpTestSuite() { server_ = std::make_unique<ServedProgram>(); }
    static void TearDownTestSuite() { server_.reset(); }
    void SetUp() override { static_cast<void>(client_.result("reset")); }

    static std::unique_ptr<ServedProgram> server_;
    RpcClient client_{server_->socket()};
    test::TemporaryFolder folder_;
};
std::unique_ptr<ServedProgram> Serve::server_;

using LongServe = Serve;

TEST_F(Serve, ListsWhatTheCommandLineLists)
{
    const Json all = render::parseJson(test::vitrine({"list", "--json"}).out, "list").root()["exhibits"];
    EXPECT_EQ(client_.result("list"), all);
    const Json one = client_.result("list", {{"exhibit", "fur"}});
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0]["name"], "fur");
}

TEST_F(Serve, EveryValueOfEveryExhibitCanBeGivenBack)
{
    for (const Json& exhibit : client_.result("list")) {
        const Json before = client_.result("get", {{"exhibit", exhibit["name"]}});
        ASSERT_EQ(before["values"].size(), exhibit["parameters"].size());
        const Json set = client_.result("set", {{"exhibit", exhibit["name"]}, {"values", before["values"]}});
        EXPECT_EQ(set["notes"], Json::array()) << exhibit["name"];
        EXPECT_EQ(set["values"], before["values"]) << exhibit["name"];
        EXPECT_EQ(client_.result("get", {{"exhibit", exhibit["name"]}}), before) << exhibit["name"];
    }
}

TEST_F(Serve, VisitsTheBestViewOfAnExhibit)
{
    const std::string picture = folder_ / "seen.png", best = folder_ / "best.png";
    const Json small{{"exhibit", "sdf_morph"}, {"size", "32x18"}, {"samples", 1}, {"alone", true}};
    const auto drawn = [&](const std::string& out) {
        Json params = small;
        params["out"] = out;
        (void)client_.result("render", params);
        return test::bytesOf(out);
    };
    const std::string before = drawn(best);
    const Json camera = client_.result("visit", {{"exhibit", "sdf_morph"}})["camera"];
    ASSERT_EQ(camera["eye"].size(), 3U);
    EXPECT_NE(camera["eye"], camera["target"]);
    EXPECT_EQ(drawn(picture), before) << "a picture without a camera is of the best view";
    EXPECT_NE(client_.result("visit", {{"exhibit", "hall"}})["camera"]["eye"], camera["eye"]);
    const Json refused = client_.call("visit", {{"exhibit", "nobody"}});
    EXPECT_EQ(refused["error"]["code"], -32602) << refused;
}

TEST_F(Serve, SetsAndSaysWhatTheValuesAreThen)
{
    const Json values{{"morph", 0.25}, {"material", "glass"}, {"hall.sunElevation", "12deg"}};
    const Json set = client_.result("set", {{"exhibit", "sdf_morph"}, {"values", values}});
    EXPECT_EQ(set["values"]["morph"], 0.25);
    EXPECT_EQ(set["values"]["material"], "glass");
    EXPECT_NEAR(set["values"]["hall.sunElevation"].get<double>(), 12 * 3.14159265358979 / 180, 1e-12);
    const Json got =
        client_.result("get", {{"exhibit", "sdf_morph"}, {"names", {"morph", "material", "hall.sunElevation"}}});
    EXPECT_EQ(got["values"], set["values"]);
    // Another connection has the same scene state.
    RpcClient other(server_->socket());
    EXPECT_EQ(other.result("get", {{"exhibit", "sdf_morph"}, {"names", "morph"}})["values"]["morph"], 0.25);
    static_cast<void>(other.result("reset", {{"exhibit", "fur"}}));
    EXPECT_EQ(client_.result("get", {{"exhibit", "sdf_morph"}, {"names", "morph"}})["values"]["morph"], 0.25);
    static_cast<void>(other.result("reset", {{"exhibit", "sdf_morph"}}));
    EXPECT_NE(client_.result("get", {{"exhibit", "sdf_morph"}, {"names", "morph"}})["values"]["morph"], 0.25);
}

TEST_F(Serve, BringsToTheNearestAndRefusesAsTheCommandLineDoes)
{
    const Json before = client_.result("get", {{"exhibit", "sdf_morph"}});
    const auto rendered = [&](const std::string& assignment) {
        return test::vitrine({"render", "sdf_morph", "--alone", "--size", "8x8", "--samples", "1", "--out",
                              folder_ / "x.png", "--set", assignment});
    };
    const auto set = [&](const std::string& name, const Json& value) {
        return client_.call("set", {{"exhibit", "sdf_morph"}, {"values", {{name, value}}}});
    };
    const Json far = set("morph", 5);
    EXPECT_EQ(far["result"]["values"]["morph"], 1.0);
    EXPECT_EQ(far["result"]["notes"], Json::array({asServed(rendered("morph=5"))}));
    static_cast<void>(client_.result("reset"));
    for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
             {"morf", "0.5"}, {"morph", "soup"}, {"material", "wood"}, {"nobody.morph", "1"}}) {
        const Json answer = set(name, text);
        EXPECT_EQ(answer["error"]["code"], -32602) << answer;
        EXPECT_EQ(answer["error"]["data"]["kind"], "usage");
        EXPECT_EQ(messageOf(answer), asServed(rendered(name + '=' + text)));
    }
    // If one value is invalid, none is set.
    EXPECT_TRUE(
        client_.call("set", {{"exhibit", "sdf_morph"}, {"values", {{"morph", 0.1}, {"morf", 1}}}}).contains("error"));
    EXPECT_EQ(client_.result("get", {{"exhibit", "sdf_morph"}}), before);
}

/// Decodes base64 (RFC 4648); other characters are ignored.
std::string decoded(const std::string& text)
{
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit == std::string::npos) continue;
        bits = (bits << 6U | static_cast<unsigned>(digit)) & 0xffffU;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xffU);
    }
    return bytes;
}

TEST_F(Serve, RendersTheBytesOfTheCommandLine)
{
    const std::string wanted = folder_ / "wanted.png", file = folder_ / "file.png", exr = folder_ / "wanted.exr";
    const std::vector<std::string> words{"render", "sdf_morph", "--alone", "--size", "32x18",
                                         "--set",  "morph=0.3", "--eye",   "1,1,2",  "--out"};
    const auto commandLine = [&](const std::string& out, const std::vector<std::string>& more) {
        std::vector<std::string> all = words;
        all.push_back(out);
        all.insert(all.end(), more.begin(), more.end());
        const Ended ended = test::vitrine(all);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return test::bytesOf(out);
    };
    const std::string bytes = commandLine(wanted, {});
    Json params{
        {"exhibit", "sdf_morph"}, {"alone", true}, {"size", {32, 18}}, {"set", {{"morph", 0.3}}}, {"eye", {1, 1, 2}}};
    const Json inAnswer = client_.result("render", params);
    EXPECT_EQ(decoded(inAnswer["png"].get<std::string>()), bytes);
    EXPECT_EQ(inAnswer["size"], Json::array({32, 18}));
    // Values in a request apply to it alone; values of `set` apply to all clients.
    EXPECT_NE(client_.result("get", {{"exhibit", "sdf_morph"}, {"names", "morph"}})["values"]["morph"], 0.3);
    static_cast<void>(client_.result("set", {{"exhibit", "sdf_morph"}, {"values", {{"morph", "0.3"}}}}));
    params.erase("set");
    params["out"] = file;
    EXPECT_EQ(client_.result("render", params)["out"], file);
    EXPECT_EQ(test::bytesOf(file), bytes);

    params["out"] = folder_ / "file.exr";
    params["channels"] = "color,depth,normal";
    static_cast<void>(client_.result("render", params));
    EXPECT_EQ(test::bytesOf(folder_ / "file.exr"), commandLine(exr, {"--channels", "color,depth,normal"}));
    params.erase("out");
    EXPECT_EQ(client_.call("render", params)["error"]["code"], -32602) << "PNG has no place for depth";
}

TEST_F(Serve, RendersAVisitorsShaderWithItsInputsAndEvents)
{
    const std::string shader = folder_ / "own.fs", wanted = folder_ / "wanted.png";
    writeBytes(shader, "/*{\"INPUTS\": [{\"NAME\": \"gain\", \"TYPE\": \"float\", \"DEFAULT\": 0.5}, {\"NAME\": "
                       "\"flash\", \"TYPE\": \"event\"}]}*/\n"
                       "void main() { gl_FragColor = vec4(gain, flash ? 1.0 : 0.0, 0.0, 1.0); }\n");
    const Ended ended = test::vitrine({"render", "your_shader", "--alone", "--size", "8x8", "--set", "file=" + shader,
                                       "--set", "gain=0.25", "--set", "flashAt=0", "--out", wanted});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Json answer = client_.result("render", {{"exhibit", "your_shader"},
                                                  {"alone", true},
                                                  {"size", {8, 8}},
                                                  {"set", {{"file", shader}, {"gain", 0.25}, {"flashAt", 0}}}});
    EXPECT_EQ(decoded(answer["png"].get<std::string>()), test::bytesOf(wanted));
}

TEST_F(Serve, RecordsTheBytesOfTheCommandLineByTheSameOptions)
{
    const std::string wanted = folder_ / "wanted.apng", out = folder_ / "out.apng";
    ASSERT_EQ(test::vitrine({"record", "sdf_morph", "--alone", "--size", "32x18", "--samples", "1", "--fps", "4",
                             "--seconds", "0.5", "--shutter", "0.5", "--set", "morph=0.3", "--out", wanted})
                  .code,
              0);
    Json params{{"exhibit", "sdf_morph"}, {"alone", true},  {"size", {32, 18}},        {"samples", 1}, {"fps", 4},
                {"seconds", 0.5},         {"shutter", 0.5}, {"set", {{"morph", 0.3}}}, {"out", out}};
    params["dry_run"] = true;
    EXPECT_EQ(client_.result("record", params)["facts"][0]["value"], 2);
    EXPECT_FALSE(std::filesystem::exists(out));
    params["dry_run"] = false;
    const Json answer = client_.result("record", params);
    EXPECT_EQ(answer["files"], Json::array({out, out + ".vitrine-job.json"}));
    EXPECT_EQ(test::bytesOf(out), test::bytesOf(wanted));
    params["frames"] = 3;
    const std::string refused = messageOf(client_.call("record", params));
    for (const jobs::JobOption& option : jobs::optionsOf(jobs::findJob("record")->parameters())) {
        std::string key = option.name.substr(option.positional ? 0 : 2);
        std::replace(key.begin(), key.end(), '-', '_');
        EXPECT_NE(refused.find(key), std::string::npos) << key << ": " << refused;
    }
}

TEST_F(Serve, LoadsPresetsByNameAndByFile)
{
    const Json presets = client_.result("presets", {{"exhibit", "sdf_morph"}});
    ASSERT_FALSE(presets.empty());
    EXPECT_TRUE(presets[0]["shipped"].get<bool>());
    const std::string name = presets[0]["preset"].get<std::string>();
    static_cast<void>(client_.result("load", {{"exhibit", "sdf_morph"}, {"preset", name}}));
    const std::string wanted = folder_ / "wanted.png", served = folder_ / "served.png";
    const Ended ended = test::vitrine(
        {"render", "sdf_morph", "--preset", name, "--alone", "--size", "32x18", "--samples", "1", "--out", wanted});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Json params{{"exhibit", "sdf_morph"}, {"alone", true}, {"size", "32x18"}, {"samples", 1}, {"out", served}};
    static_cast<void>(client_.result("render", params));
    EXPECT_EQ(test::bytesOf(served), test::bytesOf(wanted));
    // A picture restores its settings.
    static_cast<void>(client_.result("reset"));
    static_cast<void>(client_.result("load", {{"exhibit", "sdf_morph"}, {"preset", wanted}}));
    const Json again = client_.result("get", {{"exhibit", "sdf_morph"}});
    static_cast<void>(client_.result("load", {{"exhibit", "sdf_morph"}, {"preset", name}}));
    EXPECT_EQ(client_.result("get", {{"exhibit", "sdf_morph"}}), again);

    const Json gone = client_.call("load", {{"exhibit", "sdf_morph"}, {"preset", "no-such-preset"}});
    EXPECT_EQ(gone["error"]["code"], -32005) << gone;
    EXPECT_EQ(gone["error"]["data"], (Json{{"kind", "file"}, {"exitCode", 5}}));
    EXPECT_EQ(client_.result("get", {{"exhibit", "sdf_morph"}}), again);
}

std::vector<std::string> namesOf(const Json& passes)
{
    std::vector<std::string> names;
    for (const Json& pass : passes) names.push_back(pass["name"].get<std::string>());
    return names;
}

TEST_F(Serve, PlansWhatThenRuns)
{
    Json params{{"exhibit", "fur"}, {"alone", true}, {"size", "32x18"}, {"samples", 1}};
    const Json plan = client_.result("plan", params);
    params["frame_report"] = true;
    const Json report = client_.result("render", params)["frame_report"];
    EXPECT_EQ(namesOf(plan["runs"]), namesOf(report["ran"]));
    Json skipped = report["skipped"];
    for (Json& pass : skipped) pass.erase("wouldCostMs");
    EXPECT_EQ(plan["skipped"], skipped);
    // Passes that are kept from now on, such as shadows, are not timed.
    const Json& ran = report["ran"];
    EXPECT_TRUE(std::any_of(ran.begin(), ran.end(), [](const Json& pass) {
        return pass["name"] == "fur/coat" && pass["ms"].is_number() && pass["ms"] > 0;
    })) << ran;
    EXPECT_GT(plan["runs"].size(), 0U);
    EXPECT_GT(plan["skipped"].size(), 0U);
    for (const Json& pass : plan["skipped"]) EXPECT_FALSE(pass["reason"].get<std::string>().empty()) << pass;
    // The run_everything switch of the frame report.
    params.erase("frame_report");
    params["run_everything"] = true;
    EXPECT_GT(client_.result("plan", params)["runs"].size(), plan["runs"].size());
}

TEST_F(Serve, StudiesAsTheCommandLineDoes)
{
    const std::string out = folder_ / "study";
    const Ended ended =
        test::vitrine({"study", "sdf_morph", "hitTolerance", "--values", "0.25,1,4", "--alone", "--size", "32x18",
                       "--views", "2", "--runs", "1", "--no-model-error", "--out", out});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Json wanted = render::readJson(out + "/study.json").root();
    const Json params{{"exhibit", "sdf_morph"},
                      {"parameters", {"hitTolerance"}},
                      {"values", {0.25, 1, 4}},
                      {"alone", true},
                      {"size", {32, 18}},
                      {"views", 2},
                      {"runs", 1},
                      {"no_model_error", true}};
    const Json study = client_.result("study", params);
    EXPECT_EQ(study["parameters"], wanted["parameters"]);
    EXPECT_EQ(study["reference"], wanted["reference"]);
    EXPECT_EQ(study["machine"], wanted["machine"]);
    ASSERT_EQ(study["points"].size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
        for (const char* key : {"values", "error", "errorOverViews", "counters", "present"})
            EXPECT_EQ(study["points"][i][key], wanted["points"][i][key]) << i << ' ' << key;
    EXPECT_EQ(client_.call("study", {{"exhibit", "sdf_morph"}, {"max_error", 1}, {"max_ms", 1}})["error"]["code"],
              -32602);
}

TEST_F(Serve, AnswersInTurnAndNotificationsNotAtAll)
{
    client_.send(test::requestLine("first", "get", {{"exhibit", "fur"}}) +
                 R"({"jsonrpc":"2.0","method":"set","params":{"exhibit":"sdf_morph","values":{"morph":0.75}}})"
                 "\n" +
                 R"({"jsonrpc":"2.0","method":"no such method"})"
                 "\n\n \r\n" +
                 test::requestLine(2.5, "get", {{"exhibit", "sdf_morph"}, {"names", "morph"}}));
    EXPECT_EQ(client_.read()["id"], "first");
    const Json second = client_.read();
    EXPECT_EQ(second["id"], 2.5);
    EXPECT_EQ(second["result"]["values"]["morph"], 0.75);
    // A client that has closed its sending side still gets its answer.
    client_.send(test::requestLine(3, "list", Json::object()));
    client_.endInput();
    EXPECT_EQ(client_.read()["id"], 3);
    EXPECT_EQ(client_.readLine(), std::nullopt);
}

TEST_F(Serve, TellsOthersWhatHasChanged)
{
    RpcClient other(server_->socket());
    EXPECT_EQ(client_.result("events")["events"], true);
    EXPECT_EQ(other.result("events")["events"], true);
    const Json values{{"morph", 0.5}, {"hall.exposure", 1}};
    static_cast<void>(other.result("set", {{"exhibit", "sdf_morph"}, {"values", values}}));
    static_cast<void>(
        other.result("set", {{"exhibit", "sdf_morph"}, {"animate", {{"morph", "sine:0.1:0.9:period=4"}}}}));
    static_cast<void>(other.result("get", {{"exhibit", "sdf_morph"}}));
    EXPECT_TRUE(other.events.empty()) << "what one does oneself is no news";
    EXPECT_EQ(client_.read(),
              (Json{{"jsonrpc", "2.0"},
                    {"method", "changed"},
                    {"params",
                     Json{{"exhibit", "hall"}, {"values", Json{{"exposure", 1.0}}}, {"motions", Json::object()}}}}));
    EXPECT_EQ(client_.read()["params"]["values"], (Json{{"morph", 0.5}}));
    EXPECT_EQ(client_.read()["params"]["motions"]["morph"]["kind"], "sine");
    EXPECT_EQ(client_.result("events", {{"off", true}})["events"], false);
    static_cast<void>(other.result("reset"));
    static_cast<void>(client_.result("get", {{"exhibit", "fur"}}));
    EXPECT_TRUE(client_.events.empty());
}

/// Request with at least half a minute of work in short steps.
const Json longWork{{"exhibit", "sdf_morph"}, {"alone", true}, {"size", "320x180"}, {"samples", 4096}};

TEST_F(Serve, WorkTellsItsProgressAndIsCanceled)
{
    static_cast<void>(client_.result("events"));
    client_.send(test::requestLine("work", "render", longWork) + test::requestLine("next", "render", longWork));
    Json progress = client_.read();
    EXPECT_EQ(progress["method"], "progress");
    EXPECT_EQ(progress["params"],
              (Json{{"method", "render"}, {"own", true}, {"id", "work"}, {"part", 0.0}, {"doing", "drawing"}}));
    double part = 0;
    for (int i = 0; i < 3; ++i) {
        progress = client_.read();
        EXPECT_GT(progress["params"]["part"].get<double>(), part);
        part = progress["params"]["part"].get<double>();
    }
    // Another connection cannot cancel the work.
    RpcClient other(server_->socket());
    other.send(test::requestLine(1, "cancel", Json::object()));
    EXPECT_EQ(other.read()["result"]["canceled"], 0);
    client_.send(test::requestLine("stop", "cancel", {{"id", "next"}}) +
                 test::requestLine("all", "cancel", Json::object()));
    std::map<std::string, Json> answers;
    while (answers.size() < 4) {
        const Json line = client_.read();
        if (line.contains("method")) continue;
        answers[line["id"].get<std::string>()] = line;
    }
    EXPECT_EQ(answers["next"]["error"]["code"], -32010);
    EXPECT_EQ(answers["work"]["error"]["code"], -32010) << answers["work"];
    EXPECT_EQ(answers["stop"]["result"]["canceled"], 1);
    EXPECT_EQ(answers["all"]["result"]["canceled"], 1);
    EXPECT_EQ(client_.read()["params"]["how"], "canceled");
    EXPECT_TRUE(client_.call("get", {{"exhibit", "fur"}}).contains("result"));
}

TEST_F(LongServe, WorkOfAClosedConnectionStopsAndOthersWaitUntilThen)
{
    static_cast<void>(client_.result("events"));
    auto leaving = std::make_unique<RpcClient>(server_->socket());
    Json studying{{"exhibit", "sdf_morph"}, {"size", "320x180"}, {"runs", 1000}};
    leaving->send(test::requestLine(1, "study", studying));
    EXPECT_EQ(client_.read()["params"]["own"], false);
    client_.send(test::requestLine("waits", "get", {{"exhibit", "fur"}}));
    EXPECT_EQ(client_.read()["method"], "progress");
    leaving.reset();
    Json line = client_.read();
    while (line["method"] == "progress") line = client_.read();
    EXPECT_EQ(line["params"], (Json{{"method", "study"}, {"own", false}, {"id", nullptr}, {"how", "canceled"}}));
    EXPECT_EQ(client_.read()["id"], "waits");
}

TEST(Base64, IsThatOfTheStandard)
{
    // Examples of RFC 4648, section 10.
    const std::vector<std::pair<std::string, std::string>> known{{"", ""},
                                                                 {"f", "Zg=="},
                                                                 {"fo", "Zm8="},
                                                                 {"foo", "Zm9v"},
                                                                 {"foob", "Zm9vYg=="},
                                                                 {"fooba", "Zm9vYmE="},
                                                                 {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : known) {
        EXPECT_EQ(app::base64(bytes), text);
        EXPECT_EQ(decoded(text), bytes);
    }
    EXPECT_EQ(app::base64("\xff\xfe\xfb"), "//77");
}

TEST(ServeMessages, NameParamsInPlaceOfOptions)
{
    EXPECT_EQ(app::withoutDashes("--max-error: give 1."), "max_error: give 1.");
    EXPECT_EQ(app::withoutDashes("--set a-b: `list --json` has --no-model-error - or not."),
              "set a-b: `list --json` has no_model_error - or not.");
    EXPECT_EQ(app::withoutDashes("\"--size\" -- a--b --"), "\"--size\" -- a--b --");
}

}  // namespace
}  // namespace vitrine
