#include "render/image/piece_deflater.h"

#include <isa-l.h>

#include <cassert>
#include <stdexcept>
#include <vector>

namespace vitrine::render {
namespace {

/// Measured on prints (tests/bench/print_png): level 2 takes as long and 16 bits become larger, 3 twice as long and
/// hardly smaller.
constexpr std::uint32_t isalLevel = 1;

}  // namespace

struct PieceDeflater::State {
    isal_zstream stream{};
    std::vector<std::uint8_t> buffer = std::vector<std::uint8_t>(ISAL_DEF_LVL1_DEFAULT);
};

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
    isal_zstream& stream = state_->stream;
    isal_deflate_reset(&stream);
    stream.flush = SYNC_FLUSH;
    stream.next_in = const_cast<std::uint8_t*>(data.data());  // It is only read.
    stream.avail_in = static_cast<std::uint32_t>(data.size());
    // Room for what nothing could be saved of, and a little: a second round is rare.
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

}  // namespace vitrine::render
