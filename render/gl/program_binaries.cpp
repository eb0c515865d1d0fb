#include "render/gl/program_binaries.h"

#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"
#include "render/hash.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::render::gl {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> cacheFolder()
{
    if (std::getenv("VITRINE_NO_PROGRAM_CACHE") != nullptr) return std::nullopt;
    GLint formats = 0;
    glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    if (formats == 0) return std::nullopt;
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
        return fs::path(cache) / "vitrine" / "programs";
    if (const char* home = std::getenv("HOME"); home && *home)
        return fs::path(home) / ".cache" / "vitrine" / "programs";
    return std::nullopt;
}

constexpr std::uint64_t mostBinaryBytes = 64U << 20U;

/// Header of a stored binary. It repeats the hash of the sources, so that a file under a wrong name is rejected.
struct StoredHead {
    std::array<char, 8> magic{'v', 'i', 't', 'r', 'i', 'n', 'e', '1'};
    std::uint64_t key = 0;          ///< Hash of source, renderer and driver version.
    std::uint64_t sourceBytes = 0;  ///< Length of the source.
    std::uint64_t binaryBytes = 0;  ///< Length of the binary that follows.
    std::uint32_t format = 0;       ///< Binary format of the driver.
    std::uint32_t unused = 0;
};

StoredHead headFor(std::string_view source)
{
    Hash hash;
    hash.add(source);
    constexpr GLenum names[] = {GL_RENDERER, GL_VERSION, GL_VENDOR};
    for (const GLenum name : names)
        if (const GLubyte* text = glGetString(name)) hash.add(reinterpret_cast<const char*>(text));
    StoredHead head;
    head.key = hash.value();
    head.sourceBytes = source.size();
    return head;
}

std::string fileName(const StoredHead& head)
{
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "%016llx.bin", static_cast<unsigned long long>(head.key));
    return name.data();
}

}  // namespace

bool loadProgramBinary(GLuint program, std::string_view source)
{
    const std::optional<fs::path> folder = cacheFolder();
    if (!folder) return false;
    const StoredHead wanted = headFor(source);
    const fs::path file = *folder / fileName(wanted);
    std::string bytes;
    try {
        bytes = readFile(file, mostBinaryBytes);  // Pipes and devices are not read.
    } catch (const Failure&) {
        return false;
    }
    StoredHead head;
    if (bytes.size() <= sizeof head) return false;
    std::memcpy(&head, bytes.data(), sizeof head);
    if (head.magic != wanted.magic || head.key != wanted.key || head.sourceBytes != wanted.sourceBytes ||
        head.binaryBytes != bytes.size() - sizeof head)
        return false;
    std::error_code ignored;
    // The file is marked as used: the files that were not used for the longest time are deleted first.
    fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
    glProgramBinary(program, head.format, bytes.data() + sizeof head, static_cast<GLsizei>(head.binaryBytes));
    GLint good = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    while (glGetError() != GL_NO_ERROR) {
    }
    return good == GL_TRUE;
}

void saveProgramBinary(GLuint program, std::string_view source)
{
    const std::optional<fs::path> folder = cacheFolder();
    if (!folder) return;
    GLint length = 0;
    glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &length);
    if (length <= 0) return;
    StoredHead head = headFor(source);
    std::vector<char> bytes(sizeof head + static_cast<std::size_t>(length));
    GLenum format = 0;
    glGetProgramBinary(program, length, &length, &format, bytes.data() + sizeof head);
    head.format = format;
    head.binaryBytes = static_cast<std::uint64_t>(length);
    std::memcpy(bytes.data(), &head, sizeof head);
    try {
        // A truncated binary could crash the driver. So it is written atomically.
        atomicWriteMakingFolder(*folder / fileName(head), {bytes.data(), sizeof head + head.binaryBytes});
    } catch (const Failure&) {
        return;  // The program will be compiled again next time.
    }
    dropOldBinaries(*folder, mostStored);
}

void dropOldBinaries(const fs::path& folder, std::size_t most)
{
    std::error_code error;
    std::vector<std::pair<fs::file_time_type, fs::path>> stored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        const fs::file_time_type time = entry.last_write_time(error);
        if (!error && entry.path().extension() == ".bin") stored.emplace_back(time, entry.path());
    }
    if (stored.size() <= most) return;
    std::sort(stored.begin(), stored.end());
    for (std::size_t i = 0; i < stored.size() - most; ++i) fs::remove(stored[i].second, error);
}

}  // namespace vitrine::render::gl
