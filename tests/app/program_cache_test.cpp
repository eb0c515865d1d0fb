// Cache of linked programs: whatever its folder contains, pictures are the same and no command waits.

#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <string>
#include <vector>

namespace vitrine {
namespace {

namespace fs = std::filesystem;

/// Returns the bytes of a small picture drawn with the cache in `folder`.
std::string drawn(const test::TemporaryFolder& folder)
{
    const fs::path out = folder / "picture.png";
    const test::Ended ended =
        test::vitrine({"render", "sdf_morph", "--alone", "--size", "32x18", "--samples", "1", "--out", out},
                      {{"XDG_CACHE_HOME", folder.path().string()}});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return test::bytesOf(out);
}

std::vector<fs::path> storedPrograms(const test::TemporaryFolder& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder / "vitrine/programs")) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

TEST(ProgramCache, NoticesExchangedFilesAndReadsNoPipes)
{
    const test::TemporaryFolder folder;
    const std::string picture = drawn(folder);
    const std::vector<fs::path> files = storedPrograms(folder);
    ASSERT_GE(files.size(), 2U);
    EXPECT_EQ(drawn(folder), picture) << "from the cache";

    // Each file gets the name of the next one.
    fs::rename(files.back(), folder / "aside");
    for (std::size_t i = files.size() - 1; i > 0; --i) fs::rename(files[i - 1], files[i]);
    fs::rename(folder / "aside", files.front());
    EXPECT_EQ(drawn(folder), picture) << "with exchanged files";

    for (const fs::path& file : files) {
        fs::remove(file);
        ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    }
    EXPECT_EQ(drawn(folder), picture) << "with pipes in place of files";
}

}  // namespace
}  // namespace vitrine
