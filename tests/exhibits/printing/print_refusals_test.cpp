// Impossible prints: the sentence, the exit code, and no file.

#include "render/image/image_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <array>
#include <cstdio>

namespace vitrine::printing {
namespace {

using namespace vitrine::test;

struct Ended {
    int code = -1;
    std::string said{};
};

/// Runs a shell command that starts the program as $VITRINE.
Ended shell(const std::string& command)
{
    Ended ended;
    FILE* pipe =
        ::popen(("VITRINE='" + std::string(VITRINE_PROGRAM) + "'; " + command + " 2>&1 >/dev/null").c_str(), "r");
    if (!pipe) return ended;
    std::array<char, 512> text{};
    while (std::fgets(text.data(), text.size(), pipe)) ended.said += text.data();
    const int status = ::pclose(pipe);
    ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return ended;
}

class PrintRefusals : public testing::Test {
protected:
    PrintRefusals()
    {
        std::filesystem::create_directory(folder_ / "views");
        std::filesystem::create_directory(folder_ / "empty");
        for (int k = 0; k < 3; ++k)
            render::writePicture(folder_ / ("views/v" + std::to_string(k) + ".png"),
                                 render::Image(20 + k, 30 - k, 3, 0.2F * static_cast<float>(k + 1)),
                                 render::PictureFormat::png8);
        vitrine::test::writeBytes(folder_ / "cut.png", bytesOf(folder_ / "views/v0.png").substr(0, 60));
        vitrine::test::writeBytes(folder_ / "text.png", "this is no picture");
        before_ = folder_.files();
    }
    [[nodiscard]] std::string in(const std::string& name) const { return (folder_ / name).string(); }
    [[nodiscard]] std::string print(const std::string& views, const std::string& more) const
    {
        return "$VITRINE print --views " + views + " --out " + in("p.tif") + " --dpi 600 --height-mm 15 " + more;
    }

    TemporaryFolder folder_;
    std::vector<std::string> before_;
};

using LongPrintRefusals = PrintRefusals;

TEST_F(PrintRefusals, EachHasItsSentenceItsCodeAndNoFile)
{
    const std::string good = " --lpi 40 --width-mm 20 ";
    const std::string views = in("views");
    struct Case {
        std::string command;
        int code;
        const char* said;
    };
    const std::vector<Case> cases = {
        {print(in("empty"), good), 5, "no pictures"},
        {print(in("none"), good), 5, "none"},
        {print(in("cut.png"), good), 5, "cut.png"},
        {print(in("text.png"), good), 5, "text.png"},
        {print(in("views/v0.png") + " " + in("cut.png"), good), 5, "cut.png"},
        {print(views, "--lpi 0 --width-mm 20"), 2, "--lpi \"0\": give a number from 1"},
        {print(views, "--lpi -40 --width-mm 20"), 2, "--lpi \"-40\": give a number from 1"},
        {print(views, "--lpi nan --width-mm 20"), 2, "--lpi \"nan\": give a number from 1"},
        {print(views, "--lpi inf --width-mm 20"), 2, "--lpi \"inf\": give a number from 1"},
        {print(views, "--lpi 600 --width-mm 20"), 2, "one pixel for a lens"},
        {print(views, "--lpi 700 --width-mm 20"), 2, "one pixel for a lens"},
        {print(views, "--lpi 40 --width-mm -1"), 2, "width"},
        {print(views, "--lpi 40 --width-mm nan"), 2, "width"},
        {print(views, "--lpi 40 --width-mm 0"), 2, "width"},
        {print(views, "--lpi 40 --width-mm 1e9"), 2, "--width-mm \"1e9\": give a number from 0.1 to 1e+05 mm"},
        {print(views, "--lpi 40 --width-mm 60000"), 2, "1048576"},
        {print(views, good + "--bleed-mm -1"), 2, "bleed"},
        {print(views, good + "--border-mm -1"), 2, "border"},
        {print(views, good + "--border-mm nan"), 2, "border"},
        {print(views, good + "--ink-um -4"), 2, "ink"},
        {print(views, good + "--dither --bits 16"), 2, "--dither"},
        {print(views, good + "--phase nan"), 2, "phase"},
        {print(views, good + "--direction 120"), 2, "direction"},
        {print(views, good + "--radius-um 100 --thickness-um 900"), 2, "radius"},
        {print(views, good + "--index 1"), 2, "index"},
        {print(views, good + "--index 0.5 --radius-um 700 --thickness-um 2000"), 2, "index"},
        {print(views, good + "--distance-mm 0.1"), 2, "distance"},
        {print(views, good + "--distance-mm -5"), 2, "distance"},
        {print(views, good + "--distance-mm nan"), 2, "distance"},
        {print(views, good + "--tile-mm 0.1"), 2, "narrower than a lens"},
        {"$VITRINE print --views " + views + " --lpi 40 --width-mm 20 --height-mm 15 --out " + in("no/p.tif"), 5,
         "folder"},
        {"$VITRINE print --views " + views + " --lpi 40 --width-mm 20 --height-mm 15 --out /proc/p.tif", 5,
         "/proc/p.tif"},
        {"$VITRINE print --views " + views + " --lpi 40 --width-mm 20 --height-mm 15 --out " + in("p.jpg"), 2, ".tif"},
    };
    for (const Case& c : cases) {
        const Ended ended = shell(c.command);
        EXPECT_EQ(ended.code, c.code) << c.command << '\n' << ended.said;
        EXPECT_NE(ended.said.find(c.said), std::string::npos) << c.command << '\n' << ended.said;
        ASSERT_EQ(folder_.files(), before_) << c.command;
    }
}

TEST_F(PrintRefusals, OneViewAndViewsOfSeveralSizesArePrinted)
{
    const Ended one = shell(print(in("views/v0.png"), "--lpi 40 --width-mm 20"));
    EXPECT_EQ(one.code, 0) << one.said;
    EXPECT_NE(one.said.find("one view"), std::string::npos) << one.said;
    EXPECT_EQ(
        shell(print(in("views"), "--lpi 40 --width-mm 20 --border-mm 2 --dither --crosstalk-compensation --ink-um 15"))
            .code,
        0);
    const std::string json = bytesOf(folder_ / "p.tif.json");
    for (const char* key : {"\"crossTalk\"", "\"inkSpread\"", "\"border\"", "\"dither\""})
        EXPECT_NE(json.find(key), std::string::npos) << key;
}

TEST_F(LongPrintRefusals, AFullDiskIsExit5NothingIsLeftAndTheEarlierPrintStands)
{
    for (const char* name : {"p.tif", "p.png", "tiles.tif"}) {
        const std::string out = in(name);
        const std::string tiles = std::string(name) == "tiles.tif" ? " --tile-mm 20" : "";
        const std::string command = "$VITRINE print --views " + in("views") +
                                    " --lpi 40 --dpi 600 --height-mm 60 --width-mm 60 --out " + out + tiles;
        if (tiles.empty()) vitrine::test::writeBytes(out, "the earlier print");
        const std::vector<std::string> before = folder_.files();
        for (const char* blocks : {"0", "2", "12"}) {  // Blocks of 512 bytes; these views make a PNG of 30.
            const Ended ended = shell("ulimit -f " + std::string(blocks) + "; " + command);
            EXPECT_EQ(ended.code, 5) << name << ' ' << blocks << ' ' << ended.said;
            EXPECT_NE(ended.said.find(std::string("Cannot write ")), std::string::npos) << ended.said;
            EXPECT_EQ(folder_.files(), before) << name << ' ' << blocks;
        }
        if (tiles.empty()) {
            EXPECT_EQ(bytesOf(out), "the earlier print");
        }
    }
}

}  // namespace
}  // namespace vitrine::printing
