#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace vitrine::render {

/// Reader of a PNG, a few rows at a time, from the top: RGB, 8 or 16 bits. Palettes, gray and fewer bits are converted
/// to that; transparency is dropped.
class PngRowReader {
public:
    /// Every function returns a half sentence that says what went wrong; empty: success.
    explicit PngRowReader(std::filesystem::path);
    ~PngRowReader();
    PngRowReader(const PngRowReader&) = delete;
    PngRowReader& operator=(const PngRowReader&) = delete;

    /// Opens the file and reads its header. Call it again to restart at the top.
    [[nodiscard]] std::string begin();
    /// Reads the next `count` rows, without padding, in the machine's byte order.
    [[nodiscard]] std::string read(void* rows, std::int64_t count);

    [[nodiscard]] std::int64_t width() const;
    [[nodiscard]] std::int64_t height() const;
    [[nodiscard]] int bits() const;
    /// Orientation in a chunk eXIf before the pixels: 1 to 8, see `orient`.
    [[nodiscard]] int orientation() const;
    /// ICC profile; empty: none.
    [[nodiscard]] std::string profile() const;
    /// Text of chunk `key` before the pixels; empty if there is none.
    [[nodiscard]] std::string text(const char* key) const;

private:
    struct State;
    std::filesystem::path path_;
    std::unique_ptr<State> state_;
};

}  // namespace vitrine::render
