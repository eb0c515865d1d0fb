#pragma once

#include <cstdint>
#include <string>

namespace vitrine::render::gl {

/// Number and size of GPU resources of one kind.
struct Stored {
    std::string what;  ///< "images", "buffers", "pictures", "meshes", "constant buffers", "programs".
    std::int64_t count = 0;
    std::int64_t bytes = 0;  ///< Bytes of the data; 0 for programs, whose size only the driver knows.

    void add(std::int64_t more)
    {
        ++count;
        bytes += more;
    }
    bool operator==(const Stored&) const = default;
};

/// Number of GL objects that the program owns, of all renderers and contexts.
[[nodiscard]] int liveGlNames();

}  // namespace vitrine::render::gl
