// Entry points of libFuzzer. VITRINE_FUZZ_READER selects the reader, so that only one program has to be linked.

#include "tests/fuzz/readers.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

bool (*chosen)(std::string_view bytes) = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
    const char* wanted = std::getenv("VITRINE_FUZZ_READER");
    for (const vitrine::fuzz::Reader& reader : vitrine::fuzz::readers())
        if (wanted && reader.corpus == wanted) chosen = reader.read;
    if (!chosen) {
        std::fprintf(stderr, "fuzz: set VITRINE_FUZZ_READER to the name of a folder of tests/fuzz/corpus\n");
        std::exit(2);
    }
    // Loads OpenImageIO and its libraries before the first input is timed.
    (void)vitrine::fuzz::readImage("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x80\x80\x81");
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    chosen({reinterpret_cast<const char*>(data), size});
    return 0;
}
