#pragma once

#include "render/image/png_filter.h"
#include "render/image/raw_bytes.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace vitrine::render {

/// Compressor of a PNG's pixels: several threads filter and deflate pieces of about half a megabyte, while the next
/// rows are made. The result is one zlib stream, split into IDAT chunks, which does not depend on the number of
/// threads. Memory: two megabytes for each thread and two more, or five rows for each if those are larger.
class PngPieces {
public:
    struct Shape {
        std::size_t rowBytes = 0;    ///< At least 1.
        std::size_t pixelBytes = 3;  ///< 3 or 6.
        bool swapped = false;  ///< The 16-bit samples of the rows are little-endian; the file stores them big-endian.
        PngFilter filter = PngFilter::above;  ///< Filter of the first row.
    };
    /// Receives whole chunks in order, on the thread that calls `write` and `finish`. Returns a half sentence that says
    /// what went wrong; empty: success.
    using Put = std::function<std::string(const std::uint8_t* bytes, std::size_t size)>;

    /// If fewer than `threads` can be started, those are used; the file is the same.
    PngPieces(const Shape&, int threads, Put);
    ~PngPieces();
    PngPieces(const PngPieces&) = delete;
    PngPieces& operator=(const PngPieces&) = delete;

    /// Takes the next rows, without padding. Returns an error of `Put` or of the compression; the rest is then not
    /// written.
    [[nodiscard]] std::string write(const std::uint8_t* rows, std::int64_t count);
    /// Ends the stream; call it after the last row.
    [[nodiscard]] std::string finish();

private:
    struct Piece {
        std::vector<std::uint8_t> rows{};  ///< The row above, then those of the piece.
        std::size_t count = 0;             ///< Number of rows, without the one above.
        RawBytes chunks{};
        std::uint32_t adler = 1;  ///< Checksum of the filtered rows.
        std::uint64_t filteredBytes = 0;
        std::string problem{};
        bool first = false;
        bool done = false;
    };
    struct Workplace;

    void start(int threads);
    void work();
    void make(Piece&, Workplace&) const;
    void submit();
    std::string takeOldest();
    [[nodiscard]] Piece& pieceAt(std::size_t number) { return *ring_[number % ring_.size()]; }

    Shape shape_;
    Put put_;
    std::size_t rowsPerPiece_;
    std::vector<std::unique_ptr<Piece>> ring_;
    // Counts of pieces that were written, taken by a thread, and submitted; guarded by the mutex while threads run.
    std::size_t written_ = 0, taken_ = 0, submitted_ = 0;
    std::uint32_t adler_ = 1;
    bool stop_ = false;
    std::mutex mutex_;
    std::condition_variable wanted_, made_;
    std::vector<std::thread> threads_;
};

}  // namespace vitrine::render
