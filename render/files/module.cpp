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
    Message problems;
    const auto add = [&](const Message& problem) {
        problems = problems.empty() ? problem : message("{1}{2}", problems, problem);
    };
    for (const fs::path& place : places) {
        if (!fs::exists(place, error)) continue;
        void* module = ::dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (void* symbol = module ? ::dlsym(module, file.symbol) : nullptr) {
            if (void* result = made(symbol)) return result;
            add(message("{1} belongs to another version; ", place));
        } else if (const char* why = ::dlerror()) {
            add(message("{1}; ", why));
        }
    }
    if (problems.empty()) {
        throw Failure(
            ErrorKind::file,
            message("Cannot open {1}, which {2}: it is not beside the program; install {3} or build Vitrine again.",
                    file.name, file.purpose, file.needs));
    }
    throw Failure(ErrorKind::file, message("Cannot open {1}, which {2}: {3}install {4} or build Vitrine again.",
                                           file.name, file.purpose, problems, file.needs));
}

}  // namespace vitrine::render
