#include "render/image/piece_deflater.h"

#include <isa-l/igzip_lib.h>

#include <cassert>
#include <stdexcept>

namespace vitrine::render {

struct PieceDeflater::Stream {
    isal_zstream isal{};
    std::vector<std::uint8_t> work = std::vector<std::uint8_t>(ISAL_DEF_LVL1_DEFAULT);
};

PieceDeflater::PieceDeflater() : stream_(std::make_unique<Stream>()) {}
PieceDeflater::~PieceDeflater() = default;

void PieceDeflater::append(std::span<const std::uint8_t> data, std::vector<std::uint8_t>& out)
{
    assert(data.size() <= std::size_t{1} << 30U);
    isal_zstream& z = stream_->isal;
    isal_deflate_init(&z);
    z.level = 1;
    z.level_buf = stream_->work.data();
    z.level_buf_size = static_cast<std::uint32_t>(stream_->work.size());
    z.gzip_flag = IGZIP_DEFLATE;
    z.flush = FULL_FLUSH;
    z.end_of_stream = 0;
    z.next_in = const_cast<std::uint8_t*>(data.data());  // It is only read.
    z.avail_in = static_cast<std::uint32_t>(data.size());
    const std::size_t before = out.size();
    do {
        const std::size_t filled = before + z.total_out;
        // Noise grows by a few bytes for each stored block.
        out.resize(filled + z.avail_in + z.avail_in / 64 + 1024);
        z.next_out = out.data() + filled;
        z.avail_out = static_cast<std::uint32_t>(out.size() - filled);
        if (isal_deflate(&z) != COMP_OK) throw std::runtime_error("ISA-L does not deflate");
    } while (z.avail_in > 0 || z.avail_out == 0);
    out.resize(before + z.total_out);
}

}  // namespace vitrine::render
