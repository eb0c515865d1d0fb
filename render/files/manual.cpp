#include "render/files/manual.h"

#include "render/files/assets.h"

namespace vitrine::render {

std::filesystem::path manualFile()
{
    namespace fs = std::filesystem;
    std::error_code error;
    for (const char* place : {"../doc/vitrine/README.md", "../README.md"}) {
        fs::path file = fs::weakly_canonical(asset(place), error);
        if (!error && fs::is_regular_file(file, error)) return file;
    }
    return {};
}

}  // namespace vitrine::render
