#include "render/files/asset_store.h"

#include "render/failure.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <new>
#include <thread>

namespace {

using namespace vitrine;
using render::Asset;
using render::AssetStore;
using test::TemporaryFolder;
using test::writeBytes;

/// Reads texts and counts how often.
struct Reader {
    AssetStore store;
    int reads = 0;

    explicit Reader(std::uint64_t mostBytes = 1000) : store(mostBytes) {}
    Asset<std::string> get(const std::filesystem::path& path, const char* use = "test.text", std::uint64_t variant = 0)
    {
        return store.get<std::string>(use, path.string(), [&](const std::string& file) -> AssetStore::Made<std::string> {
            ++reads;
            std::string text = test::bytesOf(file);
            if (text.empty() || text == "broken") throw Failure(Blame::file, "Cannot read " + file + ": it is broken.");
            if (text == "huge") throw std::bad_alloc();
            const std::uint64_t bytes = text.size();
            return {std::make_shared<std::string>(std::move(text)), bytes};
        }, variant);
    }
};

TEST(AssetStore, ReadsAFileOnceWhileItStaysAsItIsAndAgainWhenItChanged)
{
    const TemporaryFolder folder;
    writeBytes(folder / "a", "first");
    Reader reader;
    EXPECT_EQ(*reader.get(folder / "a").value, "first");
    EXPECT_EQ(*reader.get(folder / "a").value, "first");
    EXPECT_EQ(reader.reads, 1);
    writeBytes(folder / "other", "what stands beside it is nothing to a file that was read");
    EXPECT_EQ(*reader.get(folder / "a").value, "first");
    EXPECT_EQ(reader.reads, 1);
    writeBytes(folder / "a", "the second");
    EXPECT_EQ(*reader.get(folder / "a").value, "the second");
    EXPECT_EQ(reader.reads, 2);
}

TEST(AssetStore, AFailureIsAnEntryUntilTheFileComesBack)
{
    const TemporaryFolder folder;
    Reader reader;
    for (int i = 0; i < 3; ++i) {
        const Asset<std::string> missing = reader.get(folder / "a");
        EXPECT_FALSE(missing.value);
        EXPECT_EQ(missing.failure, "Cannot read " + (folder / "a").string() + ": it is broken.");
    }
    EXPECT_EQ(reader.reads, 1);
    writeBytes(folder / "a", "back");
    EXPECT_EQ(*reader.get(folder / "a").value, "back");
    EXPECT_EQ(reader.get(folder / "a").failure, "");
    std::filesystem::remove(folder / "a");
    EXPECT_FALSE(reader.get(folder / "a").value);
    EXPECT_EQ(reader.reads, 3);
}

TEST(AssetStore, WhatFailedIsTriedAgainWhenSomethingComesToStandBesideIt)
{
    const TemporaryFolder folder;
    writeBytes(folder / "a", "broken");
    Reader reader;
    EXPECT_FALSE(reader.get(folder / "a").value);
    EXPECT_FALSE(reader.get(folder / "a").value);
    EXPECT_EQ(reader.reads, 1);
    // File systems tell times in steps of a few milliseconds.
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    writeBytes(folder / "a.bin", "what it lacked");
    EXPECT_FALSE(reader.get(folder / "a").value);
    EXPECT_EQ(reader.reads, 2);
}

TEST(AssetStore, MemoryThatIsNotThereIsAFailureLikeAnyOther)
{
    const TemporaryFolder folder;
    writeBytes(folder / "a", "huge");
    Reader reader;
    const std::string why = reader.get(folder / "a").failure;
    EXPECT_NE(why.find((folder / "a").string()), std::string::npos) << why;
    EXPECT_NE(why.find("memory"), std::string::npos) << why;
}

TEST(AssetStore, TwoUsersInTurnDoNotReadAgainAndUsesAndVariantsAreToldApart)
{
    const TemporaryFolder folder;
    writeBytes(folder / "a", "one");
    writeBytes(folder / "b", "two");
    Reader reader;
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(*reader.get(folder / "a").value, "one");
        EXPECT_EQ(*reader.get(folder / "b").value, "two");
    }
    EXPECT_EQ(reader.reads, 2);
    (void)reader.get(folder / "a", "test.other");
    (void)reader.get(folder / "a", "test.text", 7);
    EXPECT_EQ(reader.reads, 4);
}

TEST(AssetStore, HoldsNoMoreThanItsLimitButTheLastOfEachUse)
{
    const TemporaryFolder folder;
    Reader reader(1000);
    const std::string large(600, 'x');
    for (int i = 0; i < 40; ++i) {
        const std::filesystem::path file = folder / ("f" + std::to_string(i));
        writeBytes(file, large);
        (void)reader.get(file, "test.text");
        (void)reader.get(file, "test.other");
        EXPECT_LE(reader.store.bytes(), 1200U) << i;
    }
    EXPECT_EQ(reader.store.entries(), 2U);
    const int before = reader.reads;
    (void)reader.get(folder / "f39", "test.text");
    (void)reader.get(folder / "f39", "test.other");
    EXPECT_EQ(reader.reads, before) << "what is in use stays, however large";
    for (int i = 0; i < 100; ++i) (void)reader.get(folder / ("absent" + std::to_string(i)));
    EXPECT_LE(reader.store.entries(), 33U) << "failures are counted, too";
}

}  // namespace
