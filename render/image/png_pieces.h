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

/// The pixels of a PNG, filtered and deflated in pieces of about half a megabyte by several threads, while the next
/// rows are made: one zlib stream, cut into IDAT chunks. The same bytes for any number of threads. Memory: two
/// megabytes for each thread and two more, or five rows for each where those are larger.
class PngPieces {
public:
    struct Shape {
        std::size_t rowBytes = 0;             ///< At least 1.
        std::size_t pixelBytes = 3;           ///< 3 or 6.
        bool swapped = false;                 ///< Rows come with the low byte of 16 bits first; the file has it last.
        PngFilter filter = PngFilter::above;  ///< To begin with.
    };
    /// Takes whole chunks in their order, on the thread that calls `write` and `finish`. Returns a half sentence on
    /// what went wrong, empty when nothing did.
    using Put = std::function<std::string(const std::uint8_t* bytes, std::size_t size)>;

    /// `threads` beyond 1 need not all be had; the file is the same.
    PngPieces(const Shape&, int threads, Put);
    ~PngPieces();
    PngPieces(const PngPieces&) = delete;
    PngPieces& operator=(const PngPieces&) = delete;

    /// The next rows, without padding. Returns what `Put` returned or what else went wrong; then the rest is not
    /// written.
    [[nodiscard]] std::string write(const std::uint8_t* rows, std::int64_t count);
    /// After the last row: the stream's end.
    [[nodiscard]] std::string finish();

private:
    struct Piece {
        std::vector<std::uint8_t> rows{};  ///< The row above, then those of the piece.
        std::size_t count = 0;             ///< Of rows, the one above not counted.
        RawBytes chunks{};
        std::uint32_t adler = 1;  ///< Of the filtered rows.
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
    // Numbers of pieces: written, taken by a thread, handed over; guarded while threads run.
    std::size_t written_ = 0, taken_ = 0, submitted_ = 0;
    std::uint32_t adler_ = 1;
    bool stop_ = false;
    std::mutex mutex_;
    std::condition_variable wanted_, made_;
    std::vector<std::thread> threads_;
};

}  // namespace vitrine::render
