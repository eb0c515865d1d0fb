#pragma once

#include "render/files/file_ops.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace vitrine::render {

/// Options of a PNG that is written a few rows at a time: RGB, 8 or 16 bits, sRGB-encoded.
struct PngRowTarget {
    std::string path;
    std::int64_t width = 0;
    std::int64_t height = 0;
    int bits = 8;
    double dpiX = 0, dpiY = 0;      ///< Rounded to whole dots per meter: the format has no fractions.
    bool likeRowAbove = true;       ///< The first filter to try: Up if true, else Sub. Every row may use another.
    std::string textKey{}, text{};  ///< An iTXt chunk; empty: none.
    std::string profile{};          ///< ICC profile; empty: an sRGB chunk is written.
    int threads = 1;                ///< Number of threads that filter and deflate; the file does not depend on it.
};

class PngRows {
public:
    /// Creates the file. Every function returns a half sentence that says what went wrong; empty: success. The caller
    /// must remove a broken file.
    PngRows(const PngRowTarget&, FileOps&);
    ~PngRows();
    PngRows(const PngRows&) = delete;
    PngRows& operator=(const PngRows&) = delete;

    [[nodiscard]] std::string begin();
    [[nodiscard]] std::string write(const void* rows, std::int64_t count);
    /// Call it after the last of `height` rows.
    [[nodiscard]] std::string close();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace vitrine::render
