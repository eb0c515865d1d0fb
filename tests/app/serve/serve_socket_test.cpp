// Socket of `vitrine serve`: its permissions, replacing an old one, removal with the server; and the example script.

#include "render/image/image_io.h"
#include "tests/app/serve/served_program.h"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

namespace vitrine {
namespace {

using render::Json;
using namespace test;
namespace fs = std::filesystem;

TEST(ServeSocket, IsItsOwnersAloneAndGoesWithTheServer)
{
    for (const int signal : {SIGTERM, SIGINT}) {
        ServedProgram server;
        struct stat socket {};
        ASSERT_EQ(::lstat(server.socket().c_str(), &socket), 0);
        EXPECT_EQ(socket.st_mode & 07777U, 0600U);
        EXPECT_TRUE(S_ISSOCK(socket.st_mode));
        // The server stops at once, even during work, and says so.
        RpcClient client(server.socket());
        static_cast<void>(client.result("events"));
        client.send(test::requestLine(
            1, "render", {{"exhibit", "sdf_morph"}, {"alone", true}, {"size", "320x180"}, {"samples", 4096}}));
        EXPECT_EQ(client.read()["method"], "progress");
        EXPECT_EQ(server.end(signal), 0) << server.log();
        EXPECT_FALSE(fs::exists(server.socket()));
        Json last;
        while (const auto line = client.readLine()) last = render::parseJson(*line, "line").root();
        EXPECT_EQ(last["error"]["code"], -32011) << last;
    }
}

TEST(ServeSocket, OfALiveServerIsLeftAlone)
{
    const ServedProgram server;
    const Ended second = test::vitrine({"serve", "--socket", server.socket()});
    EXPECT_EQ(second.code, 2);
    test::expectOneSentence(second, {server.socket(), "another server answers"});
    RpcClient client(server.socket());
    EXPECT_TRUE(client.call("list").contains("result"));
}

TEST(ServeSocket, OfADeadServerIsReplaced)
{
    const test::TemporaryFolder folder;
    const std::string path = folder / "socket";
    ServedProgram first(path);
    EXPECT_EQ(first.end(SIGKILL), 128 + SIGKILL);
    ASSERT_TRUE(fs::exists(path));
    const ServedProgram second(path);
    RpcClient client(path);
    EXPECT_TRUE(client.call("list").contains("result"));
}

TEST(ServeSocket, NothingElseIsReplaced)
{
    const test::TemporaryFolder folder;
    const auto expectRefused = [&](const std::string& path, int code, const std::string& part) {
        const Ended ended = test::vitrine({"serve", "--socket", path});
        EXPECT_EQ(ended.code, code);
        test::expectOneSentence(ended, {"The socket ", part});
    };
    const std::string letter = folder / "letter.txt";
    test::writeBytes(letter, "dear");
    expectRefused(letter, 5, "not a socket");
    EXPECT_EQ(test::bytesOf(letter), "dear");
    fs::create_symlink(letter, folder / "link");
    expectRefused(folder / "link", 5, "not a socket");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    expectRefused(folder.path(), 5, "not a socket");
    expectRefused(folder / "no-such-folder/socket", 5, "its folder");
    expectRefused(folder / std::string(200, 'x'), 2, "107 bytes");
    expectRefused("", 2, "bytes");
    EXPECT_EQ(test::vitrine({"serve"}).code, 2);
    // Without OpenGL there is neither a server nor its socket.
    const Ended old = test::vitrine({"serve", "--socket", folder / "socket"}, {{"MESA_GL_VERSION_OVERRIDE", "3.3"}});
    EXPECT_EQ(old.code, 3);
    EXPECT_FALSE(fs::exists(folder / "socket"));
}

TEST(ServeSocket, StrangersAreTurnedAwayEvenWhereTheModeLetsThemIn)
{
    if (::geteuid() != 0) GTEST_SKIP() << "only root can be somebody else";
    const ServedProgram server;
    fs::permissions(server.folder().path(), fs::perms(0755));
    const auto strangerIsServed = [&] {
        const pid_t child = ::fork();
        if (child == 0) {
            if (::setgid(65534) != 0 || ::setuid(65534) != 0) ::_exit(3);
            try {
                RpcClient client(server.socket());
                client.send(test::requestLine(1, "get", {{"exhibit", "fur"}}));
                ::_exit(client.readLine() ? 1 : 0);
            } catch (const std::exception&) {
                ::_exit(0);
            }
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        return status != 0;
    };
    EXPECT_FALSE(strangerIsServed());
    EXPECT_EQ(server.log(), "");  // The file system refused the connection.
    fs::permissions(server.socket(), fs::perms(0666));
    EXPECT_FALSE(strangerIsServed());
    EXPECT_NE(server.log().find("user 65534 was turned away"), std::string::npos) << server.log();
    RpcClient client(server.socket());
    EXPECT_TRUE(client.call("list").contains("result"));
}

TEST(ServeExample, InPythonDoesWhatItSays)
{
    if (std::system("python3 -c 'import json' 2>/dev/null") != 0) GTEST_SKIP() << "there is no python3 here";
    const std::string example = VITRINE_SOURCE_DIR "/app/serve/example.py";
    const std::string text = test::bytesOf(example);
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 30);
    const ServedProgram server;
    const test::TemporaryFolder folder;
    const std::string out = folder / "out.txt";
    const std::string command =
        "python3 " + example + ' ' + server.socket() + ' ' + folder.path().string() + " >" + out;
    ASSERT_EQ(std::system(command.c_str()), 0) << server.log();
    std::vector<std::string> pictures;
    for (const char* name : {"mug-0.png", "mug-0.5.png", "mug-1.png"}) {
        const render::Image picture = render::readImage(folder / name);
        EXPECT_EQ(picture.width, 32);
        EXPECT_EQ(picture.height, 18);
        pictures.push_back(test::bytesOf(folder / name));
    }
    EXPECT_NE(pictures[0], pictures[1]);
    EXPECT_NE(pictures[1], pictures[2]);
    const std::string said = test::bytesOf(out);
    EXPECT_NE(said.find("progress {'method': 'study'"), std::string::npos) << said;
    for (const char* value : {"0.25", "1.0", "4.0"})
        EXPECT_NE(said.find("{'hitTolerance': " + std::string(value) + "} error "), std::string::npos) << said;
}

}  // namespace
}  // namespace vitrine
