// What a measurement was made on, for the head of its file: one line each, the name, a tab, the value.
//   bench_machine            renderer, processor, load, memcpy
//   bench_machine memcpy     that alone

#include "render/gl/context.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace vitrine;

/// What follows the colon of the first line of /proc/cpuinfo that begins with `key`.
std::string processorEntry(const std::string& key)
{
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);)
        if (line.rfind(key, 0) == 0 && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
    return "unknown";
}

/// Bytes copied per second by one thread, in 1e9, median of 15 copies of more than the caches hold: how fast the
/// machine is just now, with whatever else it does.
double memcpyGigabytes()
{
    constexpr std::size_t bytes = std::size_t{128} << 20;
    const std::vector<char> from(bytes, 1);
    std::vector<char> to(bytes, 2);
    std::vector<double> rates;
    for (int run = 0; run < 15; ++run) {
        const auto start = std::chrono::steady_clock::now();
        std::memcpy(to.data(), from.data(), bytes);
        rates.push_back(static_cast<double>(bytes) /
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / 1e9);
        if (to[static_cast<std::size_t>(run)] != 1) return 0;  // So that the copy is used.
    }
    std::sort(rates.begin(), rates.end());
    return rates[rates.size() / 2];
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 2 || std::strcmp(argv[1], "memcpy") != 0) {
        std::string load = "unknown";
        std::ifstream("/proc/loadavg") >> load;  // Over the last minute, before anything is done here.
        const render::gl::HeadlessContext context;
        std::printf("renderer\t%s, %s\n", context.info().renderer.c_str(), context.info().version.c_str());
        std::printf("processor\t%s, %u threads\n", processorEntry("model name").c_str(),
                    std::thread::hardware_concurrency());
        std::printf("load\t%s\n", load.c_str());
    }
    std::printf("memcpy\t%.1f\n", memcpyGigabytes());
    return 0;
}
