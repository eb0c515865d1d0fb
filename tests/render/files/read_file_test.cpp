#include "render/files/read_file.h"

#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

namespace {

using namespace vitrine;
using render::readFile;
using render::readFileBeneath;
namespace fs = std::filesystem;

TEST(ReadFile, ReadsRegularFilesUpToTheLimit)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "a", "12345");
    EXPECT_EQ(readFile(folder / "a", 5), "12345");
    EXPECT_FAILURE(readFile(folder / "a", 4), "more than the 4 allowed");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_FAILURE(readFile(folder / "pipe", 4), "not a regular file");
    EXPECT_FAILURE(readFile("/dev/zero", 4), "not a regular file");
    EXPECT_FAILURE(readFile(folder / "none", 4), "no such file");
}

TEST(ReadFile, DoesNotAllocateForAGiantSparseFile)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "big", "");
    fs::resize_file(folder / "big", 4ULL << 30U);
    EXPECT_FAILURE(readFile(folder / "big", 512ULL << 20U), "choose a smaller file");
}

TEST(ReadFile, FollowsReferencesOnlyBelowTheirFolder)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "in/sub/a", "inside");
    test::writeBytes(folder / "secret", "secret");
    fs::create_symlink("../secret", folder / "in/link");
    fs::create_directory_symlink("..", folder / "in/up");
    EXPECT_EQ(readFileBeneath(folder / "in", "sub/a", 100), "inside");
    EXPECT_EQ(readFileBeneath(folder / "in", "./sub//a", 100), "inside");
    for (const char* reference : {"../secret", "sub/../../secret", "/etc/passwd", "~/x", "$HOME", "C:/x",
                                  "file:///etc/passwd", "a\\b", "a\nb", "", "sub/", ".."}) {
        EXPECT_FAILURE(readFileBeneath(folder / "in", reference, 100), "use a plain relative path");
    }
    EXPECT_EQ(readFileBeneath(folder / "in", "sub/../sub/a", 100), "inside") << "what stays within once it is resolved";
    EXPECT_FAILURE(readFileBeneath(folder / "in", "link", 100), "symbolic link");
    EXPECT_FAILURE(readFileBeneath(folder / "in", "up/secret", 100), "Cannot read");
    EXPECT_FAILURE(readFileBeneath(folder / "in", "sub", 100), "not a regular file");
    EXPECT_FAILURE(readFileBeneath(folder / "in", "none", 100), "no such file");
}

TEST(ReadFile, ReachesTheFolderThatHoldsTheFoldersOnlyWhereThatIsGranted)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "pack/models/m", "model");
    test::writeBytes(folder / "pack/textures/a", "sibling");
    test::writeBytes(folder / "pack/secret", "beside");
    test::writeBytes(folder / "secret", "secret");
    fs::create_directory_symlink("../..", folder / "pack/textures/out");
    fs::create_directory_symlink("pack/models", folder / "alias");
    const auto read = [](const fs::path& from, const char* reference) {
        return readFileBeneath(from, reference, 100, render::Reach::parent);
    };
    EXPECT_EQ(read(folder / "pack/models", "../textures/a"), "sibling");
    EXPECT_EQ(read(folder / "pack/models", "./x/../../textures/./a"), "sibling");
    EXPECT_EQ(read(folder / "alias", "../textures/a"), "sibling") << "beside the folder itself, and not its link";
    EXPECT_EQ(read(folder / "alias", "../secret"), "beside");
    for (const char* reference : {"../../secret", "../textures/../../secret", "/etc/passwd", "..", "../", "a\\b"})
        EXPECT_FAILURE(read(folder / "pack/models", reference), "use a plain relative path");
    EXPECT_FAILURE(read(folder / "pack/models", "../textures/out/secret"), "Cannot read");
    EXPECT_FAILURE(readFileBeneath(folder / "pack/models", "../textures/a", 100), "leaves its folder");
}

}  // namespace
