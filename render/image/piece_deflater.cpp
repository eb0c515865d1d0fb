#include "render/image/piece_deflater.h"

#include <isa-l.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <vector>

namespace vitrine::render {
namespace {

/// Measured on prints of 4800 × 3200 pixels: level 2 takes as long but makes 16-bit files larger; level 3 takes twice
/// as long and makes them hardly smaller.
constexpr std::uint32_t isalLevel = 1;

/// The first bytes are compressed as a block of their own. Otherwise, ISA-L (2.30, igzip_icf_body_h1_gr_bt.asm,
/// .write_first_byte) hashes the third byte of a stream together with a register that holds the stream's address.
constexpr std::size_t firstBytes = 16;

}  // namespace

struct PieceDeflater::State {
    isal_zstream stream{};
    std::vector<std::uint8_t> buffer = std::vector<std::uint8_t>(ISAL_DEF_LVL1_DEFAULT);

    void deflate(std::span<const std::uint8_t> data, RawBytes& out);
};

void PieceDeflater::State::deflate(std::span<const std::uint8_t> data, RawBytes& out)
{
    stream.flush = SYNC_FLUSH;
    stream.next_in = const_cast<std::uint8_t*>(data.data());  // ISA-L only reads it.
    stream.avail_in = static_cast<std::uint32_t>(data.size());
    // Room for incompressible data and a little more, so that a second round is rare.
    const std::size_t room = data.size() + data.size() / 64 + 1024;
    do {
        const std::size_t before = out.size();
        out.resize(before + room);
        stream.next_out = out.data() + before;
        stream.avail_out = static_cast<std::uint32_t>(room);
        if (isal_deflate(&stream) != COMP_OK) throw std::logic_error("ISA-L refused to deflate a piece");
        out.resize(out.size() - stream.avail_out);
    } while (stream.avail_out == 0);
}

PieceDeflater::PieceDeflater() : state_(std::make_unique<State>())
{
    isal_zstream& stream = state_->stream;
    isal_deflate_init(&stream);
    stream.level = isalLevel;
    stream.level_buf = state_->buffer.data();
    stream.level_buf_size = static_cast<std::uint32_t>(state_->buffer.size());
}

PieceDeflater::~PieceDeflater() = default;

void PieceDeflater::append(std::span<const std::uint8_t> data, RawBytes& out)
{
    assert(data.size() <= std::size_t{1} << 30U);
    isal_deflate_reset(&state_->stream);
    const std::size_t first = std::min(firstBytes, data.size());
    state_->deflate(data.first(first), out);
    if (first < data.size()) state_->deflate(data.subspan(first), out);
}

}  // namespace vitrine::render
