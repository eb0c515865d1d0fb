#pragma once

#include "render/files/file_ops.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace vitrine::render {

/// A PNG that is written a few rows at a time: RGB, 8 or 16 bits, sRGB-encoded.
struct PngRowTarget {
    std::string path;
    std::int64_t width = 0;
    std::int64_t height = 0;
    int bits = 8;
    double dpiX = 0, dpiY = 0;      ///< Rounded to whole dots per meter: the format has no fractions.
    bool likeRowAbove = true;       ///< Which filter is taken first, Up or Sub; every row may have another.
    std::string textKey{}, text{};  ///< An iTXt chunk, when there is text.
    std::string profile{};          ///< ICC profile; an sRGB chunk when empty.
    int threads = 1;                ///< That filter and deflate; the file is the same for any number.
};

class PngRows {
public:
    /// Creates the file. Every function returns a half sentence on what went wrong, empty when nothing did; a
    /// broken file is the caller's to remove.
    PngRows(const PngRowTarget&, FileOps&);
    ~PngRows();
    PngRows(const PngRows&) = delete;
    PngRows& operator=(const PngRows&) = delete;

    [[nodiscard]] std::string begin();
    [[nodiscard]] std::string write(const void* rows, std::int64_t count);
    /// After the last of `height` rows.
    [[nodiscard]] std::string close();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace vitrine::render
