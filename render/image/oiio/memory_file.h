#pragma once

#include <OpenImageIO/filesystem.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace vitrine::render {

/// Bytes in memory as a file that OpenImageIO can read. Its own IOMemReader (2.4.7) adds offset and size without
/// checking for negative offsets, and offsets come from the file.
class MemoryFile final : public OIIO::Filesystem::IOProxy {
public:
    explicit MemoryFile(std::string_view bytes) : IOProxy("", Read), bytes_(bytes) {}

    [[nodiscard]] const char* proxytype() const override { return "vitrine"; }
    bool seek(int64_t offset) override
    {
        if (offset < 0) return false;
        m_pos = offset;
        return true;
    }
    std::size_t read(void* out, std::size_t size) override
    {
        const std::size_t got = pread(out, size, m_pos);
        m_pos += static_cast<int64_t>(got);
        return got;
    }
    std::size_t pread(void* out, std::size_t size, int64_t offset) override
    {
        if (offset < 0 || static_cast<std::uint64_t>(offset) >= bytes_.size()) return 0;
        const std::size_t got = std::min(size, bytes_.size() - static_cast<std::size_t>(offset));
        std::memcpy(out, bytes_.data() + offset, got);
        return got;
    }
    [[nodiscard]] std::size_t size() const override { return bytes_.size(); }

private:
    std::string_view bytes_;
};

}  // namespace vitrine::render
