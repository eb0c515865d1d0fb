#include "tests/fuzz/promises.h"

#include <glm/gtc/type_ptr.hpp>

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace vitrine::fuzz {

void require(bool good, const char* promise)
{
    if (good) return;
    std::fprintf(stderr, "broken promise: %s\n", promise);
    std::abort();
}

void requireLegal(const ParameterValues& values)
{
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        require(nearestLegal(values.rows()[i], values.row(i)) == values.row(i), "accepted values are legal");
}

void requireFiniteView(const render::Camera& camera)
{
    const render::View view = render::makeView(camera, {});
    const glm::mat4 m(view.clipFromWorld);
    require(std::all_of(glm::value_ptr(m), glm::value_ptr(m) + 16, [](float x) { return std::isfinite(x); }),
            "an accepted camera can be looked through");
}

MemoryFile::MemoryFile(std::string_view bytes) : descriptor_(::memfd_create("file", 0))
{
    require(descriptor_ >= 0 && ::write(descriptor_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
            "there is memory for a file");
}

MemoryFile::~MemoryFile()
{
    ::close(descriptor_);
}

}  // namespace vitrine::fuzz
