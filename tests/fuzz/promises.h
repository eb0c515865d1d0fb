#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/failure.h"
#include "render/scene/camera.h"

#include <string>
#include <string_view>

namespace vitrine::fuzz {

/// Ends the program, in a way that fuzzers and tests detect, if `good` is false.
void require(bool good, const char* promise);

/// Calls `work`. Returns false if it refused with a Failure that says why; other exceptions pass.
template <typename Work> bool accepts(const Work& work)
{
    try {
        work();
        return true;
    } catch (const Failure& failure) {
        require(failure.what()[0] != '\0', "a refusal says why");
        return false;
    }
}

void requireLegal(const ParameterValues&);
void requireFiniteView(const render::Camera&);

/// File in memory, under a name that readers can open.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes);
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
    int descriptor_;
};

}  // namespace vitrine::fuzz
