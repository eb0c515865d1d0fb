// Failing allocations at any place: one sentence, exit code 2, and unchanged files.

#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace test;

/// Runs the program with memory for `count` allocations.
Ended withAllocations(long count, const std::vector<std::string>& words)
{
    return test::vitrine(words, {{"LD_PRELOAD", VITRINE_FAILING_MEMORY},
                                 {"VITRINE_TEST_ALLOCATIONS", std::to_string(count)},
                                 {"LC_ALL", "de_DE.UTF-8"}});
}

TEST(MemoryAtItsEnd, IsSaidInOneSentenceWhereverItEnds)
{
    const TemporaryFolder folder;
    const std::string out = folder / "ball.stl";
    test::writeBytes(folder / "ball.json",
                     R"({"format": "vitrine-scene", "version": 1, "root": {"kind": "sphere", "radius": 0.2}})");
    const std::vector<std::string> words{"mesh", folder / "ball.json", "--cell", "5cm", "--out", out};
    const Ended good = test::vitrine(words);
    ASSERT_EQ(good.code, 0) << good.err;
    test::writeBytes(out, "old");
    // The largest of these counts lets the command finish.
    int refused = 0;
    long count = 1500;
    for (; count < 1'000'000; count += count / 7) {
        const Ended ended = withAllocations(count, words);
        if (ended.code == 0) break;
        EXPECT_EQ(ended.code, 2) << count << " allocations: " << ended.err;
        EXPECT_TRUE(ended.err.find("There was not enough memory") != std::string::npos ||
                    ended.err.find("Speicher") != std::string::npos)
            << count << " allocations: " << ended.err;
        EXPECT_EQ(test::bytesOf(out), "old");
        ++refused;
    }
    EXPECT_GE(refused, 5);
    EXPECT_NE(test::bytesOf(out), "old") << "with " << count << " allocations";
}

}  // namespace
}  // namespace vitrine
