#pragma once

#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace vitrine::render {

/// Runs `work(0)` to `work(count - 1)`, each on a thread of its own, the first one on the caller's. Returns when all
/// have ended. Throws what the first of them threw: an exception that leaves a thread's function ends the program.
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
