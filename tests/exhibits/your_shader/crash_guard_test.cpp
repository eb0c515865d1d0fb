// Shaders whose first drawing ended the process: they are named and left off at the next start.

#include "exhibits/your_shader/crash_guard.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>

namespace vitrine {
namespace {

using guest::CrashGuard;

guest::Work workOf(const std::filesystem::path& file, std::uint64_t programs)
{
    guest::Work work;
    work.path = file;
    work.id = programs;
    return work;
}

/// Runs a function in a process that then dies, as in a crash of a driver.
void inProcessThatDies(const std::function<void()>& run)
{
    const pid_t child = ::fork();
    if (child == 0) {
        run();
        ::_exit(1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
}

TEST(CrashGuard, LeavesOffTheShaderDuringWhichAProcessDied)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "bad.fs", "void main() {}");
    test::writeBytes(folder / "good.fs", "void main() { }");
    const guest::Work bad = workOf(folder / "bad.fs", 12), good = workOf(folder / "good.fs", 34);
    inProcessThatDies([&] {
        auto* guard = new CrashGuard(folder / "state");  // The process dies without destructors.
        guard->begin(good);
        guard->drawn();
        guard->begin(bad);
    });
    {
        const CrashGuard next(folder / "state");
        EXPECT_TRUE(next.leavesOff(bad));
        EXPECT_FALSE(next.leavesOff(good));
        EXPECT_FALSE(next.leavesOff(workOf(bad.path, 13))) << "another text of the same file";
    }
    EXPECT_TRUE(CrashGuard(folder / "state").leavesOff(bad)) << "at each start, until it is saved again";
    std::filesystem::last_write_time(bad.path, std::filesystem::last_write_time(bad.path) + std::chrono::seconds(5));
    EXPECT_FALSE(CrashGuard(folder / "state").leavesOff(bad));
    EXPECT_TRUE(std::filesystem::is_empty(folder / "state")) << "the record is gone";
}

TEST(CrashGuard, LeavesNothingBehindAfterANormalEnd)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "own.fs", "void main() {}");
    const guest::Work work = workOf(folder / "own.fs", 12);
    {
        CrashGuard guard(folder / "state");
        guard.begin(work);
        EXPECT_FALSE(std::filesystem::is_empty(folder / "state"));
        // Another process that runs at the same time does not take it for a crash.
        EXPECT_FALSE(CrashGuard(folder / "state").leavesOff(work));
        guard.drawn();
        EXPECT_TRUE(std::filesystem::is_empty(folder / "state"));
        guard.begin(work);
        EXPECT_TRUE(std::filesystem::is_empty(folder / "state")) << "it was drawn before";
    }
    {
        CrashGuard guard(folder / "state");
        guard.begin(work);
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder / "state"));
    test::writeBytes(folder / "state/99999999-1.json", "{\"shaders\": [");
    EXPECT_FALSE(CrashGuard(folder / "state").leavesOff(work)) << "a record that was cut off";
}

}  // namespace
}  // namespace vitrine
