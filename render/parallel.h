#pragma once

#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace vitrine::render {

/// Runs `work(0)` to `work(count - 1)` in parallel: the first on the caller's thread, each other on its own thread.
/// Returns when all have ended. If any of them throws, throws the first exception that was caught.
template <typename Work> void onThreads(std::size_t count, const Work& work)
{
    std::mutex mutex;
    std::exception_ptr thrown;
    const auto guarded = [&](std::size_t i) {
        try {
            work(i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!thrown) thrown = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < count; ++i) others.emplace_back(guarded, i);
        if (count > 0) guarded(0);
    }
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace vitrine::render
