#include "tests/bench/child.h"

#include "render/measure/clock.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>

namespace vitrine::bench {
namespace {

/// Returns the program beside this one, as in the portable folder; else the one of the build tree.
const std::string& programFile()
{
    static const std::string file = [] {
        std::error_code error;
        const auto beside = std::filesystem::read_symlink("/proc/self/exe", error).replace_filename("vitrine");
        return std::filesystem::exists(beside, error) ? beside.string() : std::string(VITRINE_PROGRAM);
    }();
    return file;
}

}  // namespace

Run runProgram(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& changes,
               double longest)
{
    Run run;
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return run;
    run.started = render::wallSeconds();
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(pipe[1], 1);
        ::alarm(static_cast<unsigned>(longest));  // Ends the child by a signal; the alarm survives exec.
        for (const auto& [name, value] : changes) ::setenv(name.c_str(), value.c_str(), 1);
        std::vector<std::string> words{programFile()};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> pointers;
        for (std::string& word : words) pointers.push_back(word.data());
        pointers.push_back(nullptr);
        ::execv(words.front().c_str(), pointers.data());
        ::_exit(127);
    }
    ::close(pipe[1]);
    std::array<char, 4096> bytes{};
    for (ssize_t got = 0; (got = ::read(pipe[0], bytes.data(), bytes.size())) > 0;)
        run.out.append(bytes.data(), static_cast<std::size_t>(got));
    ::close(pipe[0]);
    int status = 0;
    rusage used{};
    ::wait4(child, &status, 0, &used);
    run.wallSeconds = render::wallSeconds() - run.started;
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    run.cpuSeconds = seconds(used.ru_utime) + seconds(used.ru_stime);
    run.peakMegabytes = static_cast<double>(used.ru_maxrss) * 1024 / 1e6;
    run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return run;
}

}  // namespace vitrine::bench
