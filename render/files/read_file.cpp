#include "render/files/read_file.h"

#include "render/failure.h"
#include "render/files/descriptor.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

namespace vitrine::render {
namespace {

[[noreturn]] void failReading(const std::string& name, const Message& cause)
{
    throw Failure(ErrorKind::file, message("Cannot read {1}: {2}", name, cause), {name});
}

Message causeOf(int error)
{
    if (error == ELOOP) return message("it is a symbolic link, or a chain of them; name the file itself.");
    if (error == ENOENT) return message("there is no such file; check the name.");
    return message("{1}; check the name and your permissions.", std::strerror(error));
}

std::string readAll(const Descriptor& file, const std::string& name, std::uint64_t mostBytes)
{
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) failReading(name, causeOf(errno));
    if (!S_ISREG(status.st_mode)) failReading(name, message("it is not a regular file; choose a file."));
    const std::uint64_t size = static_cast<std::uint64_t>(status.st_size);
    if (size > mostBytes) {
        failReading(
            name, message("it has {1} bytes, more than the {2} allowed here; choose a smaller file.", size, mostBytes));
    }
    std::string bytes(size, '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = ::read(file.get(), bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) failReading(name, causeOf(errno));
        if (got == 0) failReading(name, message("it became shorter while it was read; try again."));
        done += static_cast<std::size_t>(got);
    }
    return bytes;
}

/// A relative path with its "." and ".." resolved.
struct Walk {
    std::size_t up = 0;               ///< Number of folders to go up first ...
    std::vector<std::string> down{};  ///< ... then the folders to go down, the file last.
};

Walk walkOf(std::string_view reference)
{
    Walk walk;
    for (std::size_t start = 0; start <= reference.size();) {
        const std::size_t end = std::min(reference.find('/', start), reference.size());
        const std::string_view component = reference.substr(start, end - start);
        start = end + 1;
        if (component.empty() || component == ".") continue;
        if (component != "..")
            walk.down.emplace_back(component);
        else if (walk.down.empty())
            ++walk.up;
        else
            walk.down.pop_back();
    }
    return walk;
}

}  // namespace

std::string readFile(const std::filesystem::path& path, std::uint64_t mostBytes)
{
    // Without O_NONBLOCK, opening a named pipe would wait for a writer forever.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file.open()) failReading(path.string(), causeOf(errno));
    return readAll(file, path.string(), mostBytes);
}

Message whyRefused(std::string_view reference, Reach reach)
{
    if (reference.empty()) return message("it is empty");
    if (reference.size() > 4096) return message("it is longer than 4096 bytes");
    const auto forbidden = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\' || c == '$' || c == '~' || c == ':';
    };
    if (std::any_of(reference.begin(), reference.end(), forbidden)) {
        return message("it has one of the characters \\ $ ~ : or a control character");
    }
    if (reference.front() == '/') return message("it is an absolute path");
    const Walk walk = walkOf(reference);
    if (walk.up > (reach == Reach::parent ? 1U : 0U)) return message("it leaves its folder with \"..\"");
    if (reference.back() == '/' || walk.down.empty()) return message("it names a folder");
    return {};
}

std::string readFileBeneath(const std::filesystem::path& folder, std::string_view reference, std::uint64_t mostBytes,
                            Reach reach)
{
    const std::string shown = (folder / reference).string();
    if (const Message why = whyRefused(reference, reach); !why.empty()) {
        throw Failure(ErrorKind::file,
                      message("Cannot follow the reference \"{1}\" inside {2}: {3}; use a plain relative path.",
                              reference, folder, why));
    }
    // Opens one component at a time, none of them a link. That equals openat2 with RESOLVE_BENEATH and
    // RESOLVE_NO_SYMLINKS, but works also in sandboxes that refuse that call.
    const Walk walk = walkOf(reference);
    Descriptor at(::open(folder.empty() ? "." : folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (walk.up > 0 && at.open()) at = Descriptor(::openat(at.get(), "..", O_PATH | O_DIRECTORY | O_CLOEXEC));
    for (std::size_t i = 0; at.open() && i < walk.down.size(); ++i) {
        const bool last = i + 1 == walk.down.size();
        const int flags = last ? O_RDONLY | O_NONBLOCK : O_PATH | O_DIRECTORY;
        at = Descriptor(::openat(at.get(), walk.down[i].c_str(), flags | O_NOFOLLOW | O_CLOEXEC));
        if (last && at.open()) return readAll(at, shown, mostBytes);
    }
    failReading(shown, causeOf(errno));
}

}  // namespace vitrine::render
