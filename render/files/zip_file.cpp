#include "render/files/zip_file.h"

#include "render/failure.h"
#include "render/text/message.h"

#include <zlib.h>

#include <cstdint>
#include <limits>
#include <new>

namespace vitrine::render {
namespace {

/// Appends little-endian numbers.
class Fields {
public:
    Fields& two(std::uint64_t x) { return put(x, 2); }
    Fields& four(std::uint64_t x) { return put(x, 4); }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    Fields& put(std::uint64_t x, int count)
    {
        for (int i = 0; i < count; ++i) bytes_ += static_cast<char>(x >> (8 * i) & 255U);
        return *this;
    }
    std::string bytes_;
};

/// Returns the content as a raw deflate stream.
std::string deflated(const std::string& content)
{
    z_stream stream{};
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::bad_alloc();
    std::string out(deflateBound(&stream, static_cast<uLong>(content.size())), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);  // The bound makes one call enough.
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

}  // namespace

std::string zipFile(const std::vector<std::pair<std::string, std::string>>& entries)
{
    constexpr std::uint64_t version = 20, deflateMethod = 8, midnight = 0, firstOf1980 = 1U << 5U | 1U;
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max() - (1U << 20U);  // Leaves room for headers.
    std::string bytes, directory;
    for (const auto& [name, content] : entries) {
        if (content.size() >= most || bytes.size() >= most)
            throw Failure(ErrorKind::usage, message("A ZIP file holds less than 4 GiB, which {1} exceeds; make a "
                                                    "smaller one, or choose another format.",
                                                    name));
        const std::string packed = deflated(content);
        const std::uint64_t check =
            crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
        Fields common;
        common.two(version).two(0).two(deflateMethod).two(midnight).two(firstOf1980).four(check);
        common.four(packed.size()).four(content.size()).two(name.size()).two(0);
        const std::uint64_t at = bytes.size();
        bytes += Fields().four(0x04034b50).bytes() + common.bytes() + name + packed;
        directory += Fields().four(0x02014b50).two(version).bytes() + common.bytes() +
                     Fields().two(0).two(0).two(0).four(0).four(at).bytes() + name;
    }
    const Fields end = Fields().four(0x06054b50).two(0).two(0).two(entries.size()).two(entries.size());
    return bytes + directory + end.bytes() + Fields().four(directory.size()).four(bytes.size()).two(0).bytes();
}

}  // namespace vitrine::render
