#include "tests/fuzz/readers.h"

#include <array>

namespace vitrine::fuzz {

std::span<const Reader> readers()
{
    constexpr bool isText = true;
    static constexpr std::array<Reader, 16> all{{
        {"description", readDescription, isText},
        {"exhibition", readExhibition, isText},
        {"exr", readImage},
        {"gltf", readGltf},
        {"image", readImage},
        {"lesson", readLesson, isText},
        {"names", readNames},
        {"preset", readPreset, isText},
        {"print", readPrintFile},
        {"request", readRequest, isText},
        {"scene", readScene, isText},
        {"shader", readShader, isText},
        {"study", readStudy, isText},
        {"tour", readTour, isText},
        {"typed", readTyped},
        {"video", readVideo},
    }};
    return all;
}

}  // namespace vitrine::fuzz
