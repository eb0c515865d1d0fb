#include "render/files/asset_store.h"

#include "render/failure.h"
#include "render/hash.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <chrono>
#include <future>
#include <memory>
#include <new>
#include <set>
#include <span>
#include <thread>
#include <vector>

namespace {

using namespace vitrine;
using render::Asset;
using render::AssetStore;
using namespace test;

/// Reader of texts that counts its calls.
struct Reader {
    AssetStore store;
    int reads = 0;

    explicit Reader(std::uint64_t mostBytes = 1000) : store(mostBytes) {}
    Asset<std::string> get(const std::filesystem::path& path, const char* use = "test.text", std::uint64_t variant = 0)
    {
        return store.get<std::string>(
            use, path.string(),
            [&](const std::string& file) -> AssetStore::Made<std::string> {
                ++reads;
                std::string text = test::bytesOf(file);
                if (text.empty() || text == "broken")
                    throw Failure(ErrorKind::file, "Cannot read " + file + ": it is broken.");
                if (text == "huge") throw std::bad_alloc();
                const std::uint64_t bytes = text.size();
                return {std::make_shared<std::string>(std::move(text)), bytes};
            },
            variant);
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
    // File times have a resolution of a few milliseconds.
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
    const std::string why = reader.get(folder / "a").failure.english();
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

TEST(AssetStore, DropsWhatWasNotUsedForAWhileBeforeTheLatestUse)
{
    const TemporaryFolder folder;
    Reader reader;
    for (const char* name : {"a", "b", "c", "d"}) writeBytes(folder / name, name);
    (void)reader.get(folder / "d", "test.other");
    (void)reader.get(folder / "a");
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    (void)reader.get(folder / "b");
    (void)reader.get(folder / "c");
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    reader.store.dropUnused(0.5);
    EXPECT_EQ(reader.store.entries(), 3U);
    const int before = reader.reads;
    (void)reader.get(folder / "b");
    (void)reader.get(folder / "c");
    (void)reader.get(folder / "d", "test.other");
    EXPECT_EQ(reader.reads, before) << "the last picture needs two, and the last one of each use stays";
    (void)reader.get(folder / "a");
    EXPECT_EQ(reader.reads, before + 1);
}

AssetStore::Made<std::string> text(std::string value)
{
    const std::uint64_t bytes = value.size();
    return {std::make_shared<std::string>(std::move(value)), bytes};
}

TEST(HashOfNumbers, TellsEveryBitAndEveryOrderApart)
{
    std::vector<double> numbers(64);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = 0.25 * static_cast<double>(i);
    const std::uint64_t whole = render::hashOfNumbers(numbers);
    std::set<std::uint64_t> keys{whole};
    double flipped = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (int bit = 0; bit < 64; ++bit) {
            std::vector<double> other = numbers;
            other[i] = std::bit_cast<double>(std::bit_cast<std::uint64_t>(other[i]) ^ std::uint64_t{1} << bit);
            const std::uint64_t key = render::hashOfNumbers(other);
            keys.insert(key);
            flipped += std::popcount(key ^ whole) / 64.0;
        }
    EXPECT_EQ(keys.size(), 1 + 64U * 64U);
    EXPECT_NEAR(flipped / (64 * 64), 0.5, 0.01) << "of a bit that changed, half of the key's do";
    for (std::size_t i = 1; i < numbers.size(); ++i) {
        std::vector<double> other = numbers;
        std::swap(other[i - 1], other[i]);
        EXPECT_TRUE(keys.insert(render::hashOfNumbers(other)).second) << i;
    }
    EXPECT_TRUE(keys.insert(render::hashOfNumbers(std::span(numbers).first(63))).second);
    EXPECT_EQ(render::hashOfNumbers(numbers), whole) << "control: the same numbers have the same key";
}

TEST(AssetStore, MakesOfParametersOnceForEachKeyAndOfEachSource)
{
    AssetStore store;
    auto source = std::make_shared<int>(1);
    const auto get = [&](const char* key, std::shared_ptr<const void> from = {}) {
        return store
            .made<std::string>(
                "test.made", key, [&] { return text(key); }, std::move(from))
            .value;
    };
    const auto first = get("a=1");
    EXPECT_EQ(get("a=1"), first);
    EXPECT_NE(get("a=2"), first);
    EXPECT_NE(get("a=1", source), first) << "made of something else";
    EXPECT_EQ(store.builds("test.made"), 3);
    EXPECT_EQ(get("a=1", source), get("a=1", source));
    EXPECT_EQ(store.builds("test."), 3);
    source = std::make_shared<int>(1);
    (void)get("a=1", source);
    EXPECT_EQ(store.builds("test.made"), 4) << "another source";
    EXPECT_EQ(store.builds("test.other"), 0);
}

TEST(AssetStore, WhatSomebodyHoldsIsNotMadeAgainHoweverFullItIs)
{
    AssetStore store(100);
    const auto get = [&](int i) {
        return store.made<std::string>("test.made", std::to_string(i), [&] { return text(std::string(80, 'x')); })
            .value;
    };
    const auto held = get(0);
    for (int i = 1; i < 50; ++i) (void)get(i);
    EXPECT_LE(store.bytes(), 180U);
    const std::int64_t builds = store.builds();
    EXPECT_EQ(get(0), held);
    EXPECT_EQ(store.builds(), builds);
    (void)get(1);
    EXPECT_EQ(store.builds(), builds + 1) << "what nobody holds was let go";
}

TEST(AssetStore, ManyThreadsThatAskForTheSameWaitForTheOneWhoMakesIt)
{
    AssetStore store;
    std::atomic<int> makes = 0;
    std::vector<std::shared_ptr<const std::string>> found(8);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < found.size(); ++t)
        threads.emplace_back([&, t] {
            found[t] = store
                           .made<std::string>("test.made", "same",
                                              [&] {
                                                  ++makes;
                                                  std::this_thread::sleep_for(std::chrono::milliseconds(20));
                                                  return text("made");
                                              })
                           .value;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(makes, 1);
    for (const auto& value : found) EXPECT_EQ(value, found[0]);
    EXPECT_TRUE(found[0]);
}

TEST(AssetStore, SlowThingsDoNotHoldUpOthers)
{
    AssetStore store;
    std::promise<void> begun, other;
    std::thread slow([&] {
        (void)store.made<std::string>("test.slow", "one", [&] {
            begun.set_value();
            // Succeeds if the other asset is made in the meantime.
            const bool made = other.get_future().wait_for(std::chrono::seconds(60)) == std::future_status::ready;
            return text(made ? "yes" : "no");
        });
    });
    begun.get_future().wait();
    EXPECT_EQ(*store.made<std::string>("test.quick", "two", [&] { return text("quick"); }).value, "quick");
    other.set_value();
    slow.join();
    EXPECT_EQ(*store.made<std::string>("test.slow", "one", [&] { return text("again"); }).value, "yes");
}

TEST(AssetStore, WhoMustNotWaitIsToldWhatIsStillToBeReadOrMade)
{
    const TemporaryFolder folder;
    writeBytes(folder / "a", "first");
    Reader reader;
    const auto peek = [&](AssetStore store) {
        const Asset<std::string> read = store.get<std::string>("test.text", (folder / "a").string(),
                                                               [](const std::string&) -> AssetStore::Made<std::string> {
                                                                   ADD_FAILURE() << "it was read";
                                                                   return {};
                                                               });
        return std::pair(read, store.pending());
    };
    auto [before, pending] = peek(reader.store.nonBlocking());
    EXPECT_TRUE(before.pending && !before.value && before.failure.empty());
    EXPECT_EQ(pending, (std::vector<render::PendingAsset>{{"test.text", (folder / "a").string()}}));
    EXPECT_EQ(reader.store.entries(), 0) << "whoever does not wait begins nothing";

    EXPECT_EQ(*reader.get(folder / "a").value, "first");
    const auto [after, none] = peek(reader.store.nonBlocking());
    EXPECT_EQ(*after.value, "first");
    EXPECT_TRUE(!after.pending && none.empty());

    writeBytes(folder / "a", "broken");
    EXPECT_TRUE(peek(reader.store.nonBlocking()).first.pending) << "it is another file now";
    EXPECT_NE(reader.get(folder / "a").failure, "");
    EXPECT_EQ(peek(reader.store.nonBlocking()).first.failure, reader.get(folder / "a").failure);
}

TEST(AssetStore, WhoMustNotWaitDoesNotWaitForTheOneWhoMakesIt)
{
    AssetStore store;
    std::promise<void> begun, asked;
    std::thread slow([&] {
        (void)store.made<std::string>("test.slow", "one", [&] {
            begun.set_value();
            // Succeeds if a query is answered in the meantime.
            const bool answered = asked.get_future().wait_for(std::chrono::seconds(60)) == std::future_status::ready;
            return text(answered ? "yes" : "no");
        });
    });
    begun.get_future().wait();
    AssetStore nonBlocking = store.nonBlocking();
    EXPECT_TRUE(nonBlocking.made<std::string>("test.slow", "one", [] { return text("twice"); }).pending);
    EXPECT_EQ(nonBlocking.pending(), (std::vector<render::PendingAsset>{{"test.slow", ""}}));
    asked.set_value();
    slow.join();
    EXPECT_EQ(*nonBlocking.made<std::string>("test.slow", "one", [] { return text("again"); }).value, "yes");
}

}  // namespace
