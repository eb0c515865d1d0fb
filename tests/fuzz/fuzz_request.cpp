#include "tests/fuzz/readers.h"

#include <cstddef>
#include <cstdint>

/// libFuzzer's entry.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    vitrine::fuzz::readRequest({reinterpret_cast<const char*>(data), size});
    return 0;
}
