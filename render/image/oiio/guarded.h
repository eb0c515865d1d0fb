#pragma once

#include <exception>
#include <new>
#include <string>

namespace vitrine::render {

/// Calls `work` and converts an exception to a half sentence.
template <typename Work> std::string guarded(const Work& work) noexcept
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return "memory is full";
    } catch (const std::exception& e) {
        return "OpenImageIO failed (" + std::string(e.what()) + ")";
    } catch (...) {
        return "OpenImageIO failed";
    }
}

}  // namespace vitrine::render
