#include "render/gl/program_binaries.h"

#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/hash.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
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

std::string fileName(std::string_view source)
{
    Hash hash;
    hash.add(source);
    for (const GLenum name : {GL_RENDERER, GL_VERSION, GL_VENDOR})
        if (const GLubyte* text = glGetString(name)) hash.add(reinterpret_cast<const char*>(text));
    char digits[32];
    std::snprintf(digits, sizeof digits, "%016llx.bin", static_cast<unsigned long long>(hash.value()));
    return digits;
}

}  // namespace

bool loadProgramBinary(GLuint program, std::string_view source)
{
    const std::optional<fs::path> folder = cacheFolder();
    if (!folder) return false;
    const fs::path file = *folder / fileName(source);
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return false;
    std::error_code ignored;
    fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);  // Used: what is old is deleted first.
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
    GLenum format = 0;
    if (bytes.size() <= sizeof format) return false;
    std::memcpy(&format, bytes.data(), sizeof format);
    glProgramBinary(program, format, bytes.data() + sizeof format, static_cast<GLsizei>(bytes.size() - sizeof format));
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
    std::vector<char> bytes(sizeof(GLenum) + static_cast<std::size_t>(length));
    GLenum format = 0;
    glGetProgramBinary(program, length, &length, &format, bytes.data() + sizeof format);
    std::memcpy(bytes.data(), &format, sizeof format);
    try {
        // Half a binary could end the driver that is given it.
        atomicWriteMakingFolder(*folder / fileName(source),
                                {bytes.data(), sizeof format + static_cast<std::size_t>(length)});
    } catch (const Failure&) {
        return;  // The program is compiled again the next time.
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
