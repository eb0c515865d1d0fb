#include "render/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>

namespace vitrine::render {
namespace {

TEST(OnThreads, RunsEachAndThrowsWhatAnyOfThemThrew)
{
    for (const std::size_t count : {0U, 1U, 2U, 7U}) {
        std::atomic<unsigned> ran = 0;
        onThreads(count, [&](std::size_t i) { ran += 1U << i; });
        EXPECT_EQ(ran.load(), (1U << count) - 1);
    }
    for (const std::size_t thrower : {0U, 1U, 3U}) {
        std::atomic<int> ended = 0;
        const auto work = [&](std::size_t i) {
            if (i == thrower) throw std::bad_alloc();
            ++ended;
        };
        EXPECT_THROW(onThreads(4, work), std::bad_alloc);
        EXPECT_EQ(ended.load(), 3);
    }
    EXPECT_THROW(onThreads(3, [](std::size_t) { throw std::runtime_error("all"); }), std::runtime_error);
}

}  // namespace
}  // namespace vitrine::render
