#include "render/image/jpeg_end.h"

#include <cstddef>

namespace vitrine::render {

bool jpegIsWhole(std::string_view bytes)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    std::size_t at = 2;  // Position after the start-of-image marker.
    while (at + 1 < bytes.size()) {
        // Within a scan, a data byte 0xFF is followed by 0. D0 to D7 and fill bytes do not end the scan either.
        const unsigned char code = byte(at + 1);
        if (byte(at) != 0xFF || code == 0xFF) {
            ++at;
        } else if (code == 0xD9) {
            return true;
        } else if (code == 0 || code == 1 || (code >= 0xD0 && code <= 0xD8)) {
            at += 2;
        } else {
            // A segment gives its length. Its content is skipped, because it may be a thumbnail with markers of its
            // own.
            if (at + 3 >= bytes.size()) return false;
            at += 2 + static_cast<std::size_t>(byte(at + 2) * 256 + byte(at + 3));
        }
    }
    return false;
}

}  // namespace vitrine::render
