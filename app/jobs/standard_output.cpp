#include "app/jobs/standard_output.h"

#include "render/failure.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace vitrine::app {

namespace fs = std::filesystem;

std::unique_ptr<StandardOutput> StandardOutput::named(const std::string& name, const std::string& usual)
{
    if (name != "-" && !name.starts_with("-.")) return nullptr;
    if (isatty(STDOUT_FILENO) != 0)
        throw Failure(ErrorKind::usage, "--out " + name +
                                            ": a terminal cannot show the bytes of a file; redirect standard output, "
                                            "or give a name.");
    return std::unique_ptr<StandardOutput>(
        new StandardOutput(name == "-" ? "output." + usual : "output" + name.substr(1)));
}

StandardOutput::StandardOutput(std::string name) : name_(std::move(name))
{
    std::error_code error;
    std::string pattern = (fs::temp_directory_path(error) / "vitrine-XXXXXX").string();
    if (error || !mkdtemp(pattern.data()))
        throw Failure(ErrorKind::file, "--out -: no temporary folder can be made; name another one in TMPDIR.");
    folder_ = pattern;
}

StandardOutput::~StandardOutput()
{
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void StandardOutput::send() const
{
    std::ifstream from(file(), std::ios::binary);
    std::array<char, 65536> bytes{};
    bool good = static_cast<bool>(from);
    while (good && from) {
        from.read(bytes.data(), bytes.size());
        const auto count = static_cast<std::size_t>(from.gcount());
        good = std::fwrite(bytes.data(), 1, count, stdout) == count;
    }
    if (!good || std::fflush(stdout) != 0)
        throw Failure(ErrorKind::file, "--out -: standard output was closed before the whole file was written.");
}

}  // namespace vitrine::app
