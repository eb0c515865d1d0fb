#include "render/image/png_pieces.h"

#include "render/image/piece_deflater.h"

#include <isa-l.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <optional>
#include <span>
#include <system_error>

namespace vitrine::render {
namespace {

constexpr std::size_t pieceBytes = 1U << 19U;
/// Limit of a piece: a chunk is shorter than 2^31 bytes, and PieceDeflater takes 2^30.
constexpr std::size_t mostAtOnce = 1U << 30U;
constexpr std::size_t chunkHead = 8;
/// zlib header: a window of 32 KB, a fast method (P. Deutsch and J.-L. Gailly, RFC 1950, 1996).
constexpr std::array<std::uint8_t, 2> zlibHead = {0x78, 0x01};
/// An empty stored block with the final flag.
constexpr std::array<std::uint8_t, 5> lastBlock = {0x01, 0x00, 0x00, 0xFF, 0xFF};

void putBigEndian(std::uint32_t value, std::uint8_t* at)
{
    for (unsigned i = 0; i < 4; ++i) at[i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

/// Makes room for a chunk's length and type at the end of `out`; returns its offset.
std::size_t openChunk(RawBytes& out)
{
    const std::size_t begin = out.size();
    out.resize(begin + chunkHead);
    std::memcpy(out.data() + begin + 4, "IDAT", 4);
    return begin;
}

void closeChunk(RawBytes& out, std::size_t begin)
{
    const std::size_t size = out.size() - begin - chunkHead;
    putBigEndian(static_cast<std::uint32_t>(size), out.data() + begin);
    const std::uint32_t crc = crc32_gzip_refl(0, out.data() + begin + 4, size + 4);
    out.resize(out.size() + 4);
    putBigEndian(crc, out.data() + out.size() - 4);
}

}  // namespace

/// Working memory of one thread.
struct PngPieces::Workplace {
    std::optional<PieceDeflater> deflater{};  ///< Created where running out of memory can be reported.
    RawBytes filtered{};
};

PngPieces::PngPieces(const Shape& shape, int threads, Put put)
    : shape_(shape), put_(std::move(put)), rowsPerPiece_(std::max<std::size_t>(1, pieceBytes / (shape.rowBytes + 1)))
{
    const auto count = static_cast<std::size_t>(std::max(threads, 1));
    for (std::size_t i = 0; i < count + 2; ++i) {
        ring_.push_back(std::make_unique<Piece>());
        ring_.back()->rows.resize(shape.rowBytes);
    }
    pieceAt(0).first = true;
    start(static_cast<int>(count));
}

PngPieces::~PngPieces()
{
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wanted_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void PngPieces::start(int threads)
{
    try {
        for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
        // The threads that were started do the work; without any, the caller's thread does.
    }
}

void PngPieces::work()
{
    Workplace place;
    std::unique_lock lock(mutex_);
    for (;;) {
        wanted_.wait(lock, [&] { return stop_ || taken_ < submitted_; });
        if (stop_) return;
        Piece& piece = pieceAt(taken_++);
        lock.unlock();
        make(piece, place);
        lock.lock();
        piece.done = true;
        made_.notify_one();
    }
}

void PngPieces::make(Piece& piece, Workplace& place) const
{
    try {
        if (!place.deflater) place.deflater.emplace();
        if (shape_.swapped)
            for (std::size_t i = 0; i + 1 < piece.rows.size(); i += 2) std::swap(piece.rows[i], piece.rows[i + 1]);
        place.filtered.resize(piece.count * (shape_.rowBytes + 1));
        PngFilter filter = shape_.filter;
        for (std::size_t y = 0; y < piece.count; ++y) {
            const std::uint8_t* above = piece.rows.data() + y * shape_.rowBytes;
            filterPngRow(above + shape_.rowBytes, above, shape_.rowBytes, shape_.pixelBytes, filter,
                         place.filtered.data() + y * (shape_.rowBytes + 1));
        }
        piece.filteredBytes = place.filtered.size();
        piece.adler = isal_adler32(1, place.filtered.data(), place.filtered.size());
        piece.chunks.clear();
        const std::span<const std::uint8_t> all(place.filtered);
        for (std::size_t at = 0; at < all.size(); at += mostAtOnce) {
            const std::size_t begin = openChunk(piece.chunks);
            if (piece.first && at == 0) piece.chunks.insert(piece.chunks.end(), zlibHead.begin(), zlibHead.end());
            place.deflater->append(all.subspan(at, std::min(mostAtOnce, all.size() - at)), piece.chunks);
            closeChunk(piece.chunks, begin);
        }
    } catch (const std::bad_alloc&) {
        piece.problem = "memory is full";
    } catch (const std::exception& failure) {
        piece.problem = failure.what();
    }
}

/// Submits the piece that was being filled.
void PngPieces::submit()
{
    Piece& piece = pieceAt(submitted_);
    if (threads_.empty()) {
        Workplace place;
        make(piece, place);
        piece.done = true;
        ++taken_;
        ++submitted_;
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        ++submitted_;
    }
    wanted_.notify_one();
}

/// Waits for the oldest piece and writes it.
std::string PngPieces::takeOldest()
{
    Piece& piece = pieceAt(written_);
    {
        std::unique_lock lock(mutex_);
        made_.wait(lock, [&] { return piece.done; });
    }
    piece.done = false;
    ++written_;
    if (!piece.problem.empty()) return piece.problem;
    adler_ =
        static_cast<std::uint32_t>(adler32_combine(adler_, piece.adler, static_cast<z_off_t>(piece.filteredBytes)));
    return put_(piece.chunks.data(), piece.chunks.size());
}

std::string PngPieces::write(const std::uint8_t* rows, std::int64_t count)
{
    for (auto left = static_cast<std::size_t>(count); left > 0;) {
        Piece& piece = pieceAt(submitted_);
        const std::size_t more = std::min(left, rowsPerPiece_ - piece.count);
        piece.rows.insert(piece.rows.end(), rows, rows + more * shape_.rowBytes);
        piece.count += more;
        rows += more * shape_.rowBytes;
        left -= more;
        if (piece.count < rowsPerPiece_) break;
        submit();
        if (submitted_ - written_ == ring_.size())
            if (std::string why = takeOldest(); !why.empty()) return why;
        Piece& next = pieceAt(submitted_);
        next.rows.assign(rows - shape_.rowBytes, rows);
        next.count = 0;
        next.first = false;
    }
    return {};
}

std::string PngPieces::finish()
{
    if (pieceAt(submitted_).count > 0) submit();
    while (written_ < submitted_)
        if (std::string why = takeOldest(); !why.empty()) return why;
    RawBytes end;
    const std::size_t begin = openChunk(end);
    end.insert(end.end(), lastBlock.begin(), lastBlock.end());
    end.resize(end.size() + 4);
    putBigEndian(adler_, end.data() + end.size() - 4);
    closeChunk(end, begin);
    return put_(end.data(), end.size());
}

}  // namespace vitrine::render
