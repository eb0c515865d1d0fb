// Invalid input from clients of `vitrine serve`: it is answered with one sentence, and the server and other clients go
// on.

#include "tests/app/serve/served_program.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

namespace vitrine {
namespace {

using render::Json;
using namespace test;

class ServeHostile : public testing::Test {
protected:
    static void SetUpTestSuite() { hostile_ = std::make_unique<ServedProgram>(); }
    static void TearDownTestSuite() { hostile_.reset(); }
    void SetUp() override { before_ = bystander_.result("get", {{"exhibit", "sdf_morph"}}); }
    void TearDown() override
    {
        EXPECT_TRUE(hostile_->alive()) << hostile_->log();
        EXPECT_EQ(bystander_.result("get", {{"exhibit", "sdf_morph"}}), before_);
    }

    static std::unique_ptr<ServedProgram> hostile_;
    RpcClient bystander_{hostile_->socket()};
    Json before_;
};
std::unique_ptr<ServedProgram> ServeHostile::hostile_;

/// Returns a request with the params as written.
std::string asking(const std::string& method, const std::string& params)
{
    return R"({"jsonrpc":"2.0","id":1,"method":")" + method + R"(","params":)" + params + '}';
}

struct HostileLine {
    std::string line;
    int code;
    std::string part;  ///< Part of the expected message.
};

std::vector<HostileLine> linesThatAreNoRequests()
{
    return {
        {"{", -32700, "line 1"},
        {"nonsense", -32700, "line 1"},
        {std::string("\0\0\0", 3), -32700, "line 1"},
        {"\xff\xfe\x80", -32700, "line 1"},
        {std::string(R"({"jsonrpc":"2.0","id":1,"method":"li)") + '\0' + R"(st"})", -32700, "line 1"},
        {R"({"jsonrpc":"2.0","id":1,"method":"\u0000"})", -32700, "line 1"},
        {R"({"jsonrpc":"2.0","id":1,"id":2,"method":"list"})", -32700, "twice"},
        {R"({"jsonrpc":"2.0","id":1e999,"method":"list"})", -32700, "line 1"},
        {R"({"jsonrpc":"2.0","id":NaN,"method":"list"})", -32700, "line 1"},
        {std::string(1000, '['), -32700, "line 1"},
        {asking("list", std::string(100, '[') + std::string(100, ']')), -32700, "line 1"},
        {asking(
             "set", R"({"values":[)" +
                        [] {
                            std::string zeros = "0";
                            for (int i = 0; i < 20'000; ++i) zeros += ",0";
                            return zeros;
                        }() +
                        "]}"),
         -32700, "line 1"},
        {"[" + asking("list", "{}") + "]", -32600, "Batches"},
        {"[]", -32600, "Batches"},
        {"3", -32600, "object"},
        {"null", -32600, "object"},
        {"{}", -32600, "jsonrpc"},
        {R"({"jsonrpc":"1.0","id":1,"method":"list"})", -32600, "2.0"},
        {R"({"jsonrpc":2.0,"id":1,"method":"list"})", -32600, "2.0"},
        {R"({"jsonrpc":"2.0","id":{},"method":"list"})", -32600, "id"},
        {R"({"jsonrpc":"2.0","id":true,"method":"list"})", -32600, "id"},
        {R"({"jsonrpc":"2.0","id":1})", -32600, "method"},
        {R"({"jsonrpc":"2.0","id":1,"method":7})", -32600, "method"},
        {R"({"jsonrpc":"2.0","id":1,"method":"list","extra":1})", -32600, "extra"},
        {R"({"jsonrpc":"2.0","id":1,"method":"list","params":[1]})", -32602, "by name"},
        {R"({"jsonrpc":"2.0","id":1,"method":"list","params":null})", -32602, "by name"},
        {asking("", "{}"), -32601, "list, get, set"},
        {asking("shutdown", "{}"), -32601, "shutdown"},
    };
}

std::vector<HostileLine> requestsThatAreRefused()
{
    return {
        {asking("list", R"({"verbose":true})"), -32602, "list knows no \"verbose\"; it takes exhibit."},
        {asking("list", R"({"exhibit":"nobody"})"), -32602, "nobody"},
        {asking("get", "{}"), -32602, "exhibit is missing"},
        {asking("get", R"({"exhibit":null})"), -32602, "exhibit"},
        {asking("get", R"({"exhibit":{}})"), -32602, "exhibit"},
        {asking("get", R"({"exhibit":"fur","names":["morph"]})"), -32602, "morph"},
        {asking("get", R"({"exhibit":"fur","names":[[]]})"), -32602, "names"},
        {asking("set", R"({"exhibit":"sdf_morph","values":{"morph":null}})"), -32602, "values.morph"},
        {asking("set", R"({"exhibit":"sdf_morph","values":{"morph":{}}})"), -32602, "values.morph"},
        {asking("set", R"({"exhibit":"sdf_morph","values":{"morph":[]}})"), -32602, "values.morph"},
        {asking("set", R"({"exhibit":"sdf_morph","values":{"morph":[1,2]}})"), -32602, "morph"},
        {asking("set", R"({"exhibit":"sdf_morph","values":{"morph=1":0}})"), -32602, "morph=1"},
        {asking("set", R"({"exhibit":"sdf_morph","values":{"":0}})"), -32602, "values"},
        {asking("set", R"({"exhibit":"sdf_morph","values":{"morph":"nan"}})"), -32602, "morph"},
        {asking("set", R"({"exhibit":"sdf_morph","values":{"morph":"1e999"}})"), -32602, "morph"},
        {asking("set", R"({"exhibit":"sdf_morph","values":{"morph":"--help"}})"), -32602, "--help"},
        {asking("set", R"({"exhibit":"sdf_morph","values":"help"})"), -32602, "name=value"},
        {asking("set", R"({"exhibit":"sdf_morph","animate":{"morph":"jump"}})"), -32602, "animate"},
        {asking("set", R"({"exhibit":"--help","values":{}})"), -32602, "--help"},
        {asking("render", R"({"exhibit":"sdf_morph","max-error":1})"), -32602, "max-error"},
        {asking("render", R"({"exhibit":"sdf_morph","help":true})"), -32602, "help"},
        {asking("render", R"({"exhibit":"sdf_morph","alone":"yes"})"), -32602, "alone"},
        {asking("render", R"({"exhibit":"sdf_morph","alone":1})"), -32602, "alone"},
        {asking("render", R"({"exhibit":"sdf_morph","size":"0x9"})"), -32602, "size"},
        {asking("render", R"({"exhibit":"sdf_morph","size":[9]})"), -32602, "size"},
        {asking("render", R"({"exhibit":"sdf_morph","size":[-1,1e308]})"), -32602, "size"},
        {asking("render", R"({"exhibit":"sdf_morph","size":[1000000,1000000]})"), -32602, "GB of memory"},
        {asking("render", R"({"exhibit":"sdf_morph","samples":0})"), -32602, "samples"},
        {asking("render", R"({"exhibit":"sdf_morph","samples":99999999999999999999})"), -32602, "samples"},
        {asking("render", R"({"exhibit":"sdf_morph","samples":2.5})"), -32602, "samples"},
        {asking("render", R"({"exhibit":"sdf_morph","samples":"4x"})"), -32602, "samples"},
        {asking("render", R"({"exhibit":"sdf_morph","seed":-1})"), -32602, "seed"},
        {asking("render", R"({"exhibit":"sdf_morph","time":"inf"})"), -32602, "time"},
        {asking("render", R"({"exhibit":"sdf_morph","eye":[1,2]})"), -32602, "eye"},
        {asking("render", R"({"exhibit":"sdf_morph","eye":[1,2,null]})"), -32602, "eye"},
        {asking("render", R"({"exhibit":"sdf_morph","fov":1e300})"), -32602, "fov"},
        {asking("render", R"({"exhibit":"sdf_morph","size":"8x8","out":"/nowhere/x.png"})"), -32005, "/nowhere"},
        {asking("render", R"({"exhibit":"sdf_morph","out":"x.bmp"})"), -32602, ".png"},
        {asking("render", R"({"exhibit":"sdf_morph","environment":"/nowhere.hdr","size":"8x8"})"), -32005, "nowhere"},
        {asking("render", R"({"exhibit":"hall","alone":true})"), -32602, "alone"},
        {asking("load", R"({"exhibit":"sdf_morph"})"), -32602, "preset is missing"},
        {asking("load", R"({"exhibit":"sdf_morph","preset":"/dev/zero"})"), -32005, "/dev/zero"},
        {asking("load", R"({"exhibit":"sdf_morph","preset":"../../.."})"), -32005, ".."},
        {asking("study", R"({"exhibit":"sdf_morph","parameters":["soup"]})"), -32602, "soup"},
        {asking("study", R"({"exhibit":"sdf_morph","out":"x"})"), -32602, "out"},
        {asking("study", R"({"exhibit":"sdf_morph","runs":1e9})"), -32602, "runs"},
        {asking("plan", R"({"exhibit":"sdf_morph","out":"x.png"})"), -32602, "out"},
        {asking("events", R"({"on":1})"), -32602, "on"},
        {asking("events", R"({"off":1})"), -32602, "off"},
        {asking("cancel", R"({"everything":1})"), -32602, "cancel"},
    };
}

void expectRefused(RpcClient& client, const HostileLine& hostile)
{
    const std::string shown = hostile.line.substr(0, 200);
    const Json answer = client.ask(hostile.line);
    ASSERT_TRUE(answer.contains("error")) << shown << '\n' << answer;
    EXPECT_EQ(answer["error"]["code"], hostile.code) << shown << '\n' << answer;
    const std::string message = answer["error"]["message"].get<std::string>();
    EXPECT_NE(message.find(hostile.part), std::string::npos) << shown << '\n' << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.back(), '.') << message;
}

using LongServeHostile = ServeHostile;

TEST_F(ServeHostile, WhatIsNoRequestIsRefusedInOneSentence)
{
    RpcClient client(hostile_->socket());
    for (const HostileLine& hostile : linesThatAreNoRequests()) expectRefused(client, hostile);
    EXPECT_TRUE(client.call("list").contains("result"));
}

TEST_F(LongServeHostile, WhatCannotBeDoneIsRefusedInOneSentence)
{
    RpcClient client(hostile_->socket());
    for (const HostileLine& hostile : requestsThatAreRefused()) expectRefused(client, hostile);
    EXPECT_TRUE(client.call("list").contains("result"));
}

TEST_F(ServeHostile, ALineThatIsTooLongIsLeftOutAndTheNextIsRead)
{
    RpcClient client(hostile_->socket());
    const std::string megabytes(5U << 20U, 'x');
    client.send(megabytes + '\n' + test::requestLine(2, "get", {{"exhibit", "fur"}}));
    const Json refused = client.read();
    EXPECT_EQ(refused["error"]["code"], -32600);
    EXPECT_NE(refused["error"]["message"].get<std::string>().find("1048576"), std::string::npos) << refused;
    EXPECT_EQ(client.read()["id"], 2);
    // A line of the largest allowed size, and one that is longer by a byte.
    std::string longest = test::requestLine(3, "list", Json::object());
    longest.insert(longest.size() - 1, (1U << 20U) + 1 - longest.size(), ' ');
    client.send(longest);
    EXPECT_TRUE(client.read().contains("result"));
    longest.insert(longest.size() - 1, " ");
    client.send(longest);
    EXPECT_EQ(client.read()["error"]["code"], -32600);
}

TEST_F(ServeHostile, AHalfLineIsNamedAtItsEnd)
{
    RpcClient client(hostile_->socket());
    client.send(R"({"jsonrpc":"2.0","id":1,)");
    EXPECT_TRUE(bystander_.call("get", {{"exhibit", "fur"}}).contains("result"));
    client.endInput();
    EXPECT_EQ(client.read()["error"]["code"], -32700);
    EXPECT_EQ(client.readLine(), std::nullopt);
    RpcClient gone(hostile_->socket());
    gone.send("{\"half\"");
}

TEST_F(ServeHostile, RandomBytesAndBrokenRequestsForAWhile)
{
    test::Random random(20);
    const std::vector<std::string> seeds{
        asking("get", R"({"exhibit":"sdf_morph","names":["morph","hall.exposure"]})"),
        asking("plan", R"({"exhibit":"fur","alone":true,"size":[32,18],"set":{"seed":3},"time":0.5})"),
        asking("list", R"({"exhibit":"noise"})"), asking("presets", R"({"exhibit":"fur"})"),
        asking("events", R"({"off":true})")};
    const auto begun = std::chrono::steady_clock::now();
    int lines = 0;
    while (std::chrono::steady_clock::now() - begun < std::chrono::milliseconds(1500)) {
        RpcClient client(hostile_->socket());
        for (int i = 0; i < 20; ++i, ++lines) {
            std::string line;
            if (random.below(3) == 0) {
                for (int k = random.below(300); k >= 0; --k) line += static_cast<char>(random.below(256));
            } else {
                line = seeds[static_cast<std::size_t>(random.below(static_cast<int>(seeds.size())))];
                for (int k = random.below(4); k >= 0; --k) {
                    const auto at = static_cast<std::size_t>(random.below(static_cast<int>(line.size())));
                    if (random.below(2) == 0)
                        line.erase(at, static_cast<std::size_t>(random.below(9)));
                    else
                        line[at] = static_cast<char>(random.below(256));
                }
            }
            if (!client.send(line + (random.below(8) == 0 ? "" : "\n"))) break;
        }
        if (random.below(2) == 0) {  // Half of the clients read until the end.
            client.endInput();
            while (const auto answer = client.readLine()) {
                EXPECT_NO_THROW(static_cast<void>(render::parseJson(*answer, "answer"))) << *answer;
            }
        }
    }
    EXPECT_GT(lines, 100);
    EXPECT_TRUE(bystander_.call("list").contains("result"));
}

TEST_F(LongServeHostile, WhoDoesNotReadItsAnswersIsReadNoFurther)
{
    const std::string line = test::requestLine(1, "list", Json::object());
    const auto kilobytes = [] {
        const std::string status = test::bytesOf("/proc/" + std::to_string(hostile_->id()) + "/status");
        return std::stol(status.substr(status.find("VmRSS:") + 6));
    };
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(bystander_.call("list").contains("result"));
    const long before = kilobytes();
    RpcClient deaf(hostile_->socket());
    std::string many;
    for (int i = 0; i < 100; ++i) many += line;
    // Answers have half a megabyte: the server must not keep all of them.
    std::size_t sent = deaf.sendSome(many);
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(bystander_.call("get", {{"exhibit", "fur"}}).contains("result"));
    sent += deaf.sendSome(std::string_view(many).substr(sent));
    EXPECT_LT(kilobytes() - before, 20'000);
    std::size_t answers = 0;
    deaf.endInput();
    while (const auto answer = deaf.readLine()) answers += answer->find("\"result\"") != std::string::npos ? 1 : 0;
    EXPECT_EQ(answers, sent / line.size());
    EXPECT_GT(answers, 1U);
}

TEST_F(ServeHostile, WhoDoesNotReadItsEventsIsDroppedWithAReason)
{
    RpcClient deaf(hostile_->socket());
    static_cast<void>(deaf.result("events"));
    for (int i = 0; i < 12; ++i) {  // Each event has 300 kB.
        const Json values{{"environment", std::string(300'000, static_cast<char>('a' + i)) + ".hdr"}};
        ASSERT_TRUE(bystander_.call("set", {{"exhibit", "hall"}, {"values", values}}).contains("result"));
    }
    static_cast<void>(bystander_.result("reset"));
    std::vector<Json> lines;
    while (const auto line = deaf.readLine()) lines.push_back(render::parseJson(*line, "line").root());
    ASSERT_GT(lines.size(), 1U);
    EXPECT_LT(lines.size(), 12U);
    EXPECT_EQ(lines.front()["method"], "changed");
    EXPECT_EQ(lines.back()["error"]["code"], -32011) << lines.back().dump().substr(0, 300);
    EXPECT_NE(lines.back()["error"]["message"].get<std::string>().find("not read"), std::string::npos);
}

TEST_F(ServeHostile, OneConnectionTooManyIsToldSo)
{
    std::vector<std::unique_ptr<RpcClient>> clients;
    for (int i = 0; i < 15; ++i) {  // One place is taken by the bystander.
        clients.push_back(std::make_unique<RpcClient>(hostile_->socket()));
        ASSERT_TRUE(clients.back()->call("get", {{"exhibit", "fur"}}).contains("result")) << i;
    }
    RpcClient oneMore(hostile_->socket());
    EXPECT_EQ(oneMore.read()["error"]["code"], -32011);
    EXPECT_EQ(oneMore.readLine(), std::nullopt);
    clients.pop_back();
    bool served = false;  // The server accepts it once it has noticed that the other client has gone.
    for (int i = 0; i < 100 && !served; ++i)
        served = RpcClient(hostile_->socket()).ask(asking("get", R"({"exhibit":"fur"})")).contains("result");
    EXPECT_TRUE(served);
}

TEST(ServeIdle, AConnectionThatIsSilentGivesWayWhenAllPlacesAreTaken)
{
    const ServedProgram served(test::Environment{}, {"--idle-seconds", "1"});
    std::vector<std::unique_ptr<RpcClient>> silent;
    for (int i = 0; i < 16; ++i) {
        silent.push_back(std::make_unique<RpcClient>(served.socket()));
        ASSERT_TRUE(silent.back()->call("get", {{"exhibit", "fur"}}).contains("result")) << i;
    }
    // No client has been silent for long, so the seventeenth is refused, as by a server without the limit.
    EXPECT_EQ(RpcClient(served.socket()).read()["error"]["code"], -32011);
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));
    for (std::size_t i = 1; i < silent.size(); ++i)
        ASSERT_TRUE(silent[i]->call("get", {{"exhibit", "fur"}}).contains("result")) << i;
    EXPECT_TRUE(RpcClient(served.socket()).call("get", {{"exhibit", "fur"}}).contains("result"));
    const Json last = silent.front()->read();
    EXPECT_EQ(last["error"]["code"], -32011);
    EXPECT_NE(last["error"]["message"].get<std::string>().find("another one needs its place"), std::string::npos);
    EXPECT_EQ(silent.front()->readLine(), std::nullopt);
    EXPECT_TRUE(silent[1]->call("get", {{"exhibit", "fur"}}).contains("result")) << "who spoke last keeps the place";
}

/// An invalid line is answered with its id if it can be found, because the client waits for it.
TEST_F(ServeHostile, ALineThatIsNotReadIsAnsweredWithItsId)
{
    const std::string zero(1, '\0');
    const std::vector<std::pair<std::string, Json>> lines{
        {R"({"jsonrpc":"2.0","id":7,"method":"list","params":{"exhibit":"a\u0000"}})", 7},
        {R"({"jsonrpc":"2.0","method":"li\u0000st","params":{"id":3},"id":"seven"})", "seven"},
        {R"({"id":8,"jsonrpc":"2.0","method":"list","params":{"a":1,"a":2}})", 8},
        {R"({"id":9,"jsonrpc":"2.0","method":"list","params":{"exhibit":")" + zero + "\"}}", 9},
        {R"({"id":10,"jsonrpc":"2.0","method":"list"} and more)", 10},
        {R"({"jsonrpc":"2.0","method":"list","params":{"id":[1],"a\u0001":{"id":2}}})", nullptr},
        {R"({"id":[11],"jsonrpc":"2.0","jsonrpc":"2.0"})", nullptr},
        {R"({"id":"\u0000","jsonrpc":"2.0","method":"list"})", nullptr},
        {R"([{"id":12,"a":1,"a":2}])", nullptr},
    };
    for (const auto& [line, id] : lines) {
        const Json answer = bystander_.ask(line);
        EXPECT_EQ(answer["error"]["code"], -32700) << line;
        EXPECT_EQ(answer["id"], id) << line;
    }
}

}  // namespace
}  // namespace vitrine
