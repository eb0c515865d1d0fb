#include "tests/app/child_process.h"

#include "tests/support/temporary_folder.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <regex>

namespace vitrine::test {

namespace {

/// Replaces this child process by the program with these arguments. Exits with 127 if that fails.
[[noreturn]] void becomeProgram(const std::vector<std::string>& arguments)
{
    std::vector<std::string> words{VITRINE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execv(VITRINE_PROGRAM, pointers.data());
    ::_exit(127);
}

}  // namespace

Ended vitrine(const std::vector<std::string>& arguments, const Environment& changes)
{
    const TemporaryFolder folder;
    const std::string out = folder / "out";
    const std::string err = folder / "err";
    const pid_t child = ::fork();
    if (child == 0) {
        for (const char* display : {"DISPLAY", "WAYLAND_DISPLAY"}) ::unsetenv(display);
        for (const auto& [name, value] : changes)
            value.empty() ? ::unsetenv(name.c_str()) : ::setenv(name.c_str(), value.c_str(), 1);
        ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT, 0600), 1);
        ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT, 0600), 2);
        becomeProgram(arguments);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), bytesOf(out), bytesOf(err)};
}

pid_t startProgram(const std::vector<std::string>& arguments)
{
    const pid_t child = ::fork();
    if (child != 0) return child;
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    becomeProgram(arguments);
}

std::string withoutProgress(const std::string& err)
{
    static const std::regex progress("vitrine: [^\n]* [0-9]+ %(, [0-9:]+ left)?\n");
    return std::regex_replace(err, progress, "");
}

void expectOneSentence(const Ended& ended, const std::vector<std::string>& parts)
{
    EXPECT_EQ(ended.out, "");
    const std::string sentence = withoutProgress(ended.err);  // A slow machine shows progress before the refusal.
    EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 1) << ended.err;
    EXPECT_EQ(sentence.rfind("vitrine: ", 0), 0U) << ended.err;
    EXPECT_TRUE(sentence.size() > 2 && sentence[sentence.size() - 2] == '.') << ended.err;
    for (const std::string& part : parts)
        EXPECT_NE(sentence.find(part), std::string::npos) << part << " is missing in: " << ended.err;
}

}  // namespace vitrine::test
