#pragma once

#include "render/video/ffmpeg/owned.h"

#include <exception>
#include <string>

namespace vitrine::render::ffmpeg {

/// Calls `work` and converts an exception to a half sentence; empty: there was none.
template <typename Work> std::string guarded(const Work& work) noexcept
{
    try {
        work();
        return {};
    } catch (const Problem& problem) {
        return problem.text;
    } catch (const std::exception& error) {
        return error.what();
    }
}

}  // namespace vitrine::render::ffmpeg
