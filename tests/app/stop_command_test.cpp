// Ctrl-C and SIGTERM: every command ends with 130 and leaves no unfinished file.

#include "render/image/image_io.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <exception>
#include <filesystem>
#include <iterator>
#include <thread>

namespace vitrine {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using Typed = std::vector<std::string>;

/// Returns whether the name is that of an unfinished file.
bool isPart(const fs::path& path)
{
    const std::string name = path.filename().string();
    return name.find(".part-") != std::string::npos || name.find(".old-") != std::string::npos;
}

bool holdsPart(const fs::path& folder)
{
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (isPart(entry->path())) return true;
    return false;
}

/// Sends `signal` to the command once an unfinished file exists, or after `most`. Returns its exit code.
int stoppedBy(int signal, const Typed& arguments, const fs::path& folder, std::chrono::milliseconds most)
{
    const pid_t child = test::startProgram(arguments);
    const auto begun = std::chrono::steady_clock::now();
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        if (holdsPart(folder) || std::chrono::steady_clock::now() - begun > most) {
            ::kill(child, signal);
            ::waitpid(child, &status, 0);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Returns whether the only file of the folder is this picture, and whole: a signal may come between the last step of a
/// command and the end of the program.
bool holdsOnlyWhole(const fs::path& picture)
{
    const auto files = std::distance(fs::directory_iterator(picture.parent_path()), fs::directory_iterator());
    try {
        return files == 1 && !render::readImage(picture).pixels.empty();
    } catch (const std::exception&) {
        return false;
    }
}

TEST(LongStopCommand, EveryCommandEndsWith130AndLeavesNothingHalfMade)
{
    const TemporaryFolder given;
    const render::Image image(600, 600, 3, 0.5F);
    render::writePicture(given / "a.png", image, render::PictureFormat::png8);
    const Typed commands[] = {
        {"render", "fur", "--alone", "--size", "2000x2000", "--samples", "64", "--out", "OUT.png"},
        {"tour", "--size", "1000x1000", "--samples", "64", "--out", "OUT"},
        {"compare", given / "a.png", given / "a.png", "--metric", "flip", "--heatmap", "OUT.png"},
        {"sprite", "--directions", "64", "--frames", "1", "--size", "256x256", "--out", "OUT.png"},
        {"study", "sdf_morph", "stepLimit", "--alone", "--size", "400x400", "--runs", "50", "--out", "OUT"},
        {"record", "sdf_morph", "--alone", "--size", "400x400", "--seconds", "600", "--out", "OUT.webm"},
        {"print", "--exhibit", "sdf_morph", "--alone", "--count", "64", "--view-size", "800x800", "--lpi", "40",
         "--dpi", "300", "--width-mm", "100", "--height-mm", "100", "--out", "OUT.tif"}};
    for (const Typed& command : commands)
        for (const auto& [signal, most] : {std::pair{SIGINT, 100}, {SIGTERM, 2500}}) {
            const TemporaryFolder folder;
            Typed words = command;
            const std::string end = words.back().substr(3);
            words.back() = folder / ("out" + end);
            const int code = stoppedBy(signal, words, folder.path(), std::chrono::milliseconds(most));
            const bool done = code == 0;  // The command finished first.
            EXPECT_TRUE(done || code == 130) << command.front() << " ended with " << code;
            EXPECT_FALSE(holdsPart(folder.path())) << command.front();
            if (!done && command.front() != "tour") {
                EXPECT_TRUE(fs::is_empty(folder.path()) || holdsOnlyWhole(words.back())) << command.front();
            }
        }
}

TEST(StopCommand, AKilledStudysFolderIsClearedByTheNextOneAndTheOldOneStands)
{
    const TemporaryFolder folder;
    const std::string out = folder / "study";
    const Typed study{"study",   "sdf_morph", "stepLimit", "--values", "8,32",    "--size", "32x18",
                      "--views", "1",         "--runs",    "1",        "--alone", "--out",  out};
    ASSERT_EQ(test::vitrine(study).code, 0);
    test::writeBytes(folder / "study/notes.txt", "a user's own");
    const std::string before = test::bytesOf(folder / "study/study.json");
    // Killed as soon as it has made its folder.
    const pid_t child = test::startProgram(study);
    int status = 0;
    while (!holdsPart(folder.path()) && ::waitpid(child, &status, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(fs::exists(out + "/study.json")) << "there is no moment without a study";
    ASSERT_EQ(test::vitrine(study).code, 0);
    EXPECT_FALSE(holdsPart(folder.path()));
    EXPECT_EQ(test::bytesOf(folder / "study/notes.txt"), "a user's own");
    EXPECT_FALSE(before.empty());
}

}  // namespace
}  // namespace vitrine
