#pragma once

#include <cstdint>

namespace vitrine::render {

/// Upper limits for a glTF file.
struct GltfLimits {
    std::uint64_t fileBytes = 512ULL << 20U;  ///< For the file, and for each file it references.
    std::uint64_t jsonBytes = 32ULL << 20U;
    std::uint64_t bufferBytes = 1ULL << 30U;  ///< For all buffers together; the same again for compressed images.
    std::uint64_t zeroBytes = 64ULL << 20U;   ///< For buffers and accessors without data, which are filled with zeros.
    std::uint64_t nodes = 100'000;
    std::uint64_t nodeDepth = 256;
    std::uint64_t primitives = 100'000;
    std::uint64_t vertices = 20'000'000;
    std::uint64_t indices = 60'000'000;
    std::uint64_t images = 256;
    std::uint64_t textureBytes = 2ULL << 30U;  ///< Size when decoded; checked before each picture is decoded.
    std::uint64_t stringBytes = 4096;          ///< For one name or reference; data: URIs count as JSON.
};

}  // namespace vitrine::render
