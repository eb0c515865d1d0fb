#pragma once

#include <cstdint>
#include <string>

namespace vitrine::render::gl {

/// How much of one kind of thing is kept on the graphics processor.
struct Stored {
    std::string what;  ///< "images", "buffers", "pictures", "meshes", "constant buffers", "programs".
    std::int64_t count = 0;
    std::int64_t bytes = 0;  ///< Of the data; 0 for programs, of which only the driver knows.

    void add(std::int64_t more)
    {
        ++count;
        bytes += more;
    }
    bool operator==(const Stored&) const = default;
};

/// Every GL name that the program owns, of all renderers and contexts.
[[nodiscard]] int liveGlNames();

}  // namespace vitrine::render::gl
