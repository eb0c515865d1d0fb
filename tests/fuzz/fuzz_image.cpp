#include "tests/fuzz/readers.h"

#include <cstddef>
#include <cstdint>

/// Opens OpenImageIO's module and all its libraries before the clock of the first input runs.
extern "C" int LLVMFuzzerInitialize(int*, char***)
{
    (void)vitrine::fuzz::readImage("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x80\x80\x81");
    return 0;
}

/// libFuzzer's entry.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    vitrine::fuzz::readImage({reinterpret_cast<const char*>(data), size});
    return 0;
}
