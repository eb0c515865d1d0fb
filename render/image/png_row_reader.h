#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace vitrine::render {

/// A PNG that is read a few rows at a time, from the top: RGB, 8 or 16 bits; palettes, gray and fewer bits become
/// that, transparency is left out.
class PngRowReader {
public:
    /// Every function returns a half sentence on what went wrong, empty when nothing did.
    explicit PngRowReader(std::filesystem::path);
    ~PngRowReader();
    PngRowReader(const PngRowReader&) = delete;
    PngRowReader& operator=(const PngRowReader&) = delete;

    /// Opens the file and reads its header. May be called again, to start over.
    [[nodiscard]] std::string begin();
    /// The next `count` rows, without padding, in the machine's byte order.
    [[nodiscard]] std::string read(void* rows, std::int64_t count);

    [[nodiscard]] std::int64_t width() const;
    [[nodiscard]] std::int64_t height() const;
    [[nodiscard]] int bits() const;
    /// How the rows are to be shown, by a chunk eXIf ahead of the pixels: 1 to 8, as `orient` takes it.
    [[nodiscard]] int orientation() const;
    /// The ICC profile; empty when there is none.
    [[nodiscard]] std::string profile() const;
    /// The text of chunk `key` ahead of the pixels; empty when there is none.
    [[nodiscard]] std::string text(const char* key) const;

private:
    struct State;
    std::filesystem::path path_;
    std::unique_ptr<State> state_;
};

}  // namespace vitrine::render
