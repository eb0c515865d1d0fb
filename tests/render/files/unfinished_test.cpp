// Incomplete files left by killed processes.

#include "render/files/atomic_write.h"
#include "render/files/unfinished.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <functional>

namespace vitrine::render {
namespace {

namespace fs = std::filesystem;

/// Runs `work` in another process, and ends that by SIGKILL; without `kill`, waits for it.
pid_t inAnotherProcess(const std::function<void()>& work, bool kill)
{
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        if (kill) ::raise(SIGKILL);
        for (;;) ::pause();
    }
    if (kill) ::waitpid(child, nullptr, 0);
    return child;
}

TEST(Unfinished, PartsOfKilledProcessesGoWithTheNextWriteAndOthersStay)
{
    const test::TemporaryFolder folder;
    const auto begin = [&] {
        static const PartFile part(folder / "print.tif");
        test::writeBytes(part.path(), "half a print");
    };
    const pid_t alive = inAnotherProcess(begin, false);
    for (int wait = 0; wait < 10'000 && folder.files().empty(); ++wait) ::usleep(1000);
    inAnotherProcess(begin, true);
    ASSERT_EQ(folder.files().size(), 2U);
    // A file of another machine that shares the disk: whether its process lives is unknown here.
    test::writeBytes(folder / ".print.tif.part-00000000-999999999-1", "elsewhere");
    test::writeBytes(folder / "print.tif.part-visible", "a user's own");
    atomicWrite(folder / "other.txt", "written");
    std::vector<std::string> files = folder.files();
    EXPECT_EQ(files.size(), 4U);
    EXPECT_EQ(std::count_if(files.begin(), files.end(),
                            [&](const std::string& name) {
                                return name.find('-' + std::to_string(alive) + '-') != std::string::npos;
                            }),
              1);
    for (const char* name : {".print.tif.part-00000000-999999999-1", "print.tif.part-visible", "other.txt"})
        EXPECT_EQ(std::count(files.begin(), files.end(), name), 1) << name;
    ::kill(alive, SIGKILL);
    ::waitpid(alive, nullptr, 0);
}

TEST(Unfinished, TheNameOfAPartSaysWhoseItIs)
{
    const std::string own = ".a.tif" + partSuffix();
    EXPECT_FALSE(isLeftBehind(own));
    EXPECT_NE(own, ".a.tif" + partSuffix());
    const std::size_t pid = own.find('-' + std::to_string(::getpid()) + '-');
    ASSERT_NE(pid, std::string::npos);
    const std::string ofTheDead = own.substr(0, pid) + "-999999999-1";
    EXPECT_TRUE(isLeftBehind(ofTheDead));
    EXPECT_TRUE(isLeftBehind(ofTheDead + 'o'));
    EXPECT_FALSE(isLeftBehind(ofTheDead, "old"));
    for (const char* name : {"", ".part-", ".part-1-2", ".a.part-00000000-999999999-1", "a.txt"})
        EXPECT_FALSE(isLeftBehind(name)) << name;
}

TEST(Unfinished, WhatIsUnfinishedGoesWhenTheProgramIsStopped)
{
    const test::TemporaryFolder folder;
    inAnotherProcess(
        [&] {
            const PartFile part(folder / "a.txt");
            test::writeBytes(part.path(), "half");
            const Unfinished made(folder / "views", Unfinished::Content::onlyIfEmpty);
            const Unfinished kept(folder / "frames", Unfinished::Content::onlyIfEmpty);
            const Unfinished study(folder / "study");
            test::writeBytes(folder / "frames/1.png", "whole");
            test::writeBytes(folder / "study/pictures/1.png", "half");
            fs::create_directories(folder / "views");
            removeUnfinished();
            ::raise(SIGKILL);
        },
        true);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"frames/1.png"});
    EXPECT_FALSE(fs::exists(folder / "views"));
    EXPECT_FALSE(fs::exists(folder / "study"));
}

}  // namespace
}  // namespace vitrine::render
