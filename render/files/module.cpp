#include "render/files/module.h"

#include "render/failure.h"

#include <dlfcn.h>

#include <array>

namespace vitrine::render {

void* openModule(const ModuleFile& file, const std::function<void*(void*)>& made)
{
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
    const std::array<fs::path, 4> places = {here / file.name, here.parent_path() / file.name,
                                            here.parent_path() / "lib" / "vitrine" / "modules" / file.name, file.built};
    std::string problems;
    for (const fs::path& place : places) {
        if (!fs::exists(place, error)) continue;
        void* module = ::dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (void* symbol = module ? ::dlsym(module, file.symbol) : nullptr) {
            if (void* result = made(symbol)) return result;
            problems += place.string() + " belongs to another version; ";
        } else if (const char* why = ::dlerror()) {
            problems += std::string(why) + "; ";
        }
    }
    throw Failure(Blame::file, "Cannot open " + file.name + ", which " + file.purpose + ": " +
                                   (problems.empty() ? "it is not beside the program; " : problems) + "install " +
                                   file.needs + " or build Vitrine again.");
}

}  // namespace vitrine::render
