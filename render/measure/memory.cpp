#include "render/measure/memory.h"

#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace vitrine::render {

ProcessMemory processMemory()
{
    ProcessMemory memory;
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        const auto value = [&](const char* name) {
            const std::string wanted = std::string(name) + ":";
            return line.starts_with(wanted) ? 1024 * std::stoll(line.substr(wanted.size())) : 0;
        };
        memory.resident += value("VmRSS");
        memory.own += value("RssAnon");
    }
    return memory;
}

void returnFreedMemory()
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 256 << 10);
    mallopt(M_ARENA_MAX, 2);
#endif
}

void trimHeap()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace vitrine::render
