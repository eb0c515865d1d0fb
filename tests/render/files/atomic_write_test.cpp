#include "render/files/atomic_write.h"

#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <thread>

namespace {

using namespace vitrine;
using render::atomicWrite;
namespace fs = std::filesystem;

/// File operations whose call number `failing` (from 0) fails with `error`; -1: none fails. Counts the calls.
class FailingOps : public render::FileOps {
public:
    FailingOps(int failing, int error) : failing_(failing), error_(error) {}

    int open(const char* path, int flags, mode_t mode) override
    {
        return fails() ? -1 : FileOps::open(path, flags, mode);
    }
    ssize_t write(int fd, const void* bytes, std::size_t size) override
    {
        return fails() ? -1 : FileOps::write(fd, bytes, size);
    }
    ssize_t read(int fd, void* bytes, std::size_t size) override
    {
        return fails() ? -1 : FileOps::read(fd, bytes, size);
    }
    int fchmod(int fd, mode_t mode) override { return fails() ? -1 : FileOps::fchmod(fd, mode); }
    int fstat(int fd, struct stat* status) override { return fails() ? -1 : FileOps::fstat(fd, status); }
    int fsync(int fd) override { return fails() ? -1 : FileOps::fsync(fd); }
    int close(int fd) override
    {
        FileOps::close(fd);  // On Linux, the descriptor is closed even if close reports an error.
        return fails() ? -1 : 0;
    }
    int rename(const char* from, const char* to) override { return fails() ? -1 : FileOps::rename(from, to); }

    int calls = 0;

private:
    bool fails()
    {
        if (calls++ != failing_) return false;
        errno = error_;
        return true;
    }
    int failing_;
    int error_;
};

/// File operations that write at most three bytes at a time and are interrupted every second time.
class SlowOps : public render::FileOps {
public:
    ssize_t write(int fd, const void* bytes, std::size_t size) override
    {
        if (interrupted()) return -1;
        return FileOps::write(fd, bytes, std::min<std::size_t>(size, 3));
    }
    ssize_t read(int fd, void* bytes, std::size_t size) override
    {
        if (interrupted()) return -1;
        return FileOps::read(fd, bytes, std::min<std::size_t>(size, 3));
    }

private:
    bool interrupted()
    {
        errno = EINTR;
        return ++calls_ % 2 == 1;
    }
    int calls_ = 0;
};

/// Disk that loses or changes the end of its data and reports success.
class LyingOps : public render::FileOps {
public:
    explicit LyingOps(bool drops) : drops_(drops) {}
    ssize_t write(int fd, const void* bytes, std::size_t size) override
    {
        std::string other(static_cast<const char*>(bytes), size);
        if (drops_)
            other.pop_back();
        else
            other.back() ^= 1;
        FileOps::write(fd, other.data(), other.size());
        return static_cast<ssize_t>(size);
    }

private:
    bool drops_;
};

TEST(AtomicWrite, CreatesAndReplaces)
{
    const test::TemporaryFolder folder;
    atomicWrite(folder / "a", "first");
    EXPECT_EQ(test::bytesOf(folder / "a"), "first");
    atomicWrite(folder / "a", "");
    EXPECT_EQ(test::bytesOf(folder / "a"), "");
    atomicWrite(folder / "a", std::string(300'000, 'x'));
    EXPECT_EQ(test::bytesOf(folder / "a").size(), 300'000U);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a"});
}

TEST(AtomicWrite, MakesTheFolderWhereThatIsAskedFor)
{
    const test::TemporaryFolder folder;
    EXPECT_FAILURE(atomicWrite(folder / "a/b/c.json", "x"), "check that the folder exists");
    render::atomicWriteMakingFolder(folder / "a/b/c.json", "first");
    render::atomicWriteMakingFolder(folder / "a/b/c.json", "second");
    EXPECT_EQ(test::bytesOf(folder / "a/b/c.json"), "second");
    test::writeBytes(folder / "file", "x");
    EXPECT_FAILURE(render::atomicWriteMakingFolder(folder / "file/below.json", "x"), "Cannot write");
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"a/b/c.json", "file"}));
}

TEST(AtomicWrite, LeavesOldOrNewContentWhicheverStepFails)
{
    const std::string oldText = "the old content";
    const std::string newText(200'000, 'n');
    FailingOps counting(-1, 0);
    {
        const test::TemporaryFolder folder;
        test::writeBytes(folder / "a", oldText);
        atomicWrite(folder / "a", newText, counting);
    }
    ASSERT_GT(counting.calls, 12);
    int newStands = 0;
    for (const int error : {ENOSPC, EIO, EACCES, EXDEV, EDQUOT}) {
        for (int step = 0; step < counting.calls; ++step) {
            const test::TemporaryFolder folder;
            test::writeBytes(folder / "a", oldText);
            FailingOps ops(step, error);
            std::string message;
            try {
                atomicWrite(folder / "a", newText, ops);
            } catch (const Failure& failure) {
                message = failure.what();
                EXPECT_NE(message.find((folder / "a").string()), std::string::npos) << message;
                EXPECT_NE(message.find(std::strerror(error)), std::string::npos) << message;
            }
            const std::string now = test::bytesOf(folder / "a");
            const bool isNew = now == newText;
            EXPECT_TRUE(isNew || now == oldText) << "step " << step;
            // A failure to close a file that was only read loses nothing and may be ignored.
            EXPECT_TRUE(isNew || !message.empty()) << "step " << step << " failed in silence";
            newStands += isNew;
            EXPECT_EQ(folder.files(), std::vector<std::string>{"a"}) << "step " << step << " left debris";
        }
    }
    EXPECT_EQ(newStands % 5, 0);
}

TEST(AtomicWrite, OfSeveralFilesReplacesAllOrNoneWhicheverStepFails)
{
    const auto write = [](const test::TemporaryFolder& folder, render::FileOps& ops) {
        render::atomicWriteAll({{folder / "a", "new a"}, {folder / "b", "new b"}, {folder / "c", "new c"}}, ops);
    };
    FailingOps counting(-1, 0);
    {
        const test::TemporaryFolder folder;
        write(folder, counting);
        EXPECT_EQ(test::bytesOf(folder / "c"), "new c");
    }
    ASSERT_GT(counting.calls, 30);
    int oldStand = 0;
    // Three more steps, because old files keep their permissions.
    for (int step = 0; step < counting.calls + 3; ++step) {
        const test::TemporaryFolder folder;
        test::writeBytes(folder / "a", "old a");
        test::writeBytes(folder / "b", "old b");
        FailingOps ops(step, EIO);
        bool failed = false;
        try {
            write(folder, ops);
        } catch (const Failure&) {
            failed = true;
        }
        const bool isNew = test::bytesOf(folder / "a") == "new a";
        EXPECT_TRUE(isNew || failed) << step;
        EXPECT_EQ(test::bytesOf(folder / "a"), isNew ? "new a" : "old a") << step;
        EXPECT_EQ(test::bytesOf(folder / "b"), isNew ? "new b" : "old b") << step;
        EXPECT_EQ(folder.files(),
                  isNew ? (std::vector<std::string>{"a", "b", "c"}) : (std::vector<std::string>{"a", "b"}))
            << step;
        oldStand += !isNew;
    }
    EXPECT_GT(oldStand, 25);
}

TEST(AtomicWrite, OfSeveralFilesAsksForTheSpaceOfAllFirst)
{
    class SmallDiskOps : public render::FileOps {
        unsigned long long freeBytes(const char*) override { return 100; }
    } ops;
    const test::TemporaryFolder folder;
    EXPECT_FAILURE(
        render::atomicWriteAll({{folder / "a", std::string(60, 'x')}, {folder / "b", std::string(60, 'x')}}, ops),
        "free some space");
    EXPECT_TRUE(folder.files().empty());
    render::atomicWriteAll({{folder / "a", std::string(60, 'x')}}, ops);
    render::atomicWriteAll({}, ops);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a"});
}

TEST(AtomicWrite, WritesOnAfterShortWritesAndInterruptions)
{
    const test::TemporaryFolder folder;
    SlowOps ops;
    atomicWrite(folder / "a", "eleven byte", ops);
    EXPECT_EQ(test::bytesOf(folder / "a"), "eleven byte");
}

TEST(AtomicWrite, NoticesADiskThatLies)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "a", "old");
    for (const bool drops : {true, false}) {
        LyingOps ops(drops);
        EXPECT_FAILURE(atomicWrite(folder / "a", "new content", ops), "Cannot write");
        EXPECT_EQ(test::bytesOf(folder / "a"), "old");
    }
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a"});
}

TEST(AtomicWrite, KeepsModeAndSymbolicLinks)
{
    const test::TemporaryFolder folder;
    test::writeBytes(folder / "real/a", "old");
    fs::permissions(folder / "real/a", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real/a", folder / "link");
    fs::create_symlink("link", folder / "link2");
    atomicWrite(folder / "link2", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_symlink(folder / "link2"));
    EXPECT_EQ(test::bytesOf(folder / "real/a"), "new");
    EXPECT_EQ(fs::status(folder / "real/a").permissions(), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real/b", folder / "dangling");
    atomicWrite(folder / "dangling", "b");
    EXPECT_EQ(test::bytesOf(folder / "real/b"), "b");
}

TEST(AtomicWrite, RefusesWhatIsNoFile)
{
    const test::TemporaryFolder folder;
    fs::create_symlink("loop2", folder / "loop1");
    fs::create_symlink("loop1", folder / "loop2");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_FAILURE(atomicWrite(folder / "loop1", "x"), "in a circle");
    EXPECT_FAILURE(atomicWrite(folder / "pipe", "x"), "not a regular file");
    EXPECT_FAILURE(atomicWrite(folder.path(), "x"), "it is a folder");
    EXPECT_FAILURE(atomicWrite("/dev/null", "x"), "not a regular file");
    EXPECT_FAILURE(atomicWrite(folder / "missing/a", "x"), "check that the folder exists");
    EXPECT_FAILURE(atomicWrite(folder / std::string(300, 'x'), "x"), "choose a shorter name");
}

TEST(AtomicWrite, TakesNamesOfAllKinds)
{
    const test::TemporaryFolder folder;
    for (const std::string& name : {std::string(255, 'x'), std::string("two\nlines"), std::string("😀 é"),
                                    std::string("-rf"), std::string("\xff\xfe")}) {
        atomicWrite(folder / name, name);
        EXPECT_EQ(test::bytesOf(folder / name), name);
    }
}

TEST(AtomicWrite, LetsOneOfManyWritersWin)
{
    const test::TemporaryFolder folder;
    std::vector<std::thread> writers;
    for (int i = 0; i < 8; ++i) {
        writers.emplace_back([&folder, i] {
            for (int n = 0; n < 5; ++n) atomicWrite(folder / "a", std::string(50'000, static_cast<char>('a' + i)));
        });
    }
    for (std::thread& writer : writers) writer.join();
    const std::string content = test::bytesOf(folder / "a");
    EXPECT_EQ(content, std::string(50'000, content[0]));
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a"});
}

TEST(AtomicWrite, KeepsTheOldFileOnAFullDisk)
{
    const test::TemporaryFolder folder;
    if (::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0)
        GTEST_SKIP() << "only root can mount a small disk";
    test::writeBytes(folder / "a", "old");
    EXPECT_FAILURE(atomicWrite(folder / "a", std::string(100'000, 'x')), "free some space");
    EXPECT_FAILURE(render::requireSpace(folder / "a", 100'000), "free some space");
    EXPECT_EQ(test::bytesOf(folder / "a"), "old");
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a"});
    ::umount(folder.path().c_str());
}

}  // namespace
