#include "exhibits/framework/save_bytes.h"

#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/mount.h>

#include <csignal>

namespace {

using namespace vitrine;
using test::TemporaryFolder;
namespace fs = std::filesystem;

TEST(SaveBytes, CreatesFoldersAndReplacesFiles)
{
    const TemporaryFolder folder;
    savePresetBytes(folder / "a/b/c.json", "first");
    savePresetBytes(folder / "a/b/c.json", "second");
    EXPECT_EQ(test::bytesOf(folder / "a/b/c.json"), "second");
    savePresetBytes(folder / "ö 杯.json", "");
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"a/b/c.json", "ö 杯.json"}));
}

TEST(SaveBytes, KeepsSymbolicLinks)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "real", "old");
    fs::create_symlink("real", folder / "link");
    savePresetBytes(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(test::bytesOf(folder / "real"), "new");
}

TEST(SaveBytes, RefusesWhatIsNoFile)
{
    const TemporaryFolder folder;
    EXPECT_FAILURE(savePresetBytes(folder.path(), "x"), "Cannot write");
    test::writeBytes(folder / "file", "x");
    EXPECT_FAILURE(savePresetBytes(folder / "file/below.json", "x"), "Cannot write");
}

// In Qt 6.4 QSaveFile::commit returns true here and replaces the good file by the part that fitted.
TEST(SaveBytes, KeepsTheOldFileOnAFullDisk)
{
    const TemporaryFolder folder;
    if (::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=16k") != 0)
        GTEST_SKIP() << "only root can mount a small disk";
    test::writeBytes(folder / "a.json", "old");
    for (const std::size_t size : {20'000UL, 14'000UL, 12'289UL}) {
        EXPECT_FAILURE(savePresetBytes(folder / "a.json", std::string(size, 'x')), "the old content is untouched");
        EXPECT_EQ(test::bytesOf(folder / "a.json"), "old");
    }
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a.json"});
    ::umount(folder.path().c_str());
}

}  // namespace
