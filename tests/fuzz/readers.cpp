#include "tests/fuzz/readers.h"

#include <array>

namespace vitrine::fuzz {

std::span<const Reader> readers()
{
    constexpr bool isText = true;
    static constexpr std::array<Reader, 13> all{{
        {"description", readDescription, isText},
        {"exhibition", readExhibition, isText},
        {"exr", readImage},
        {"gltf", readGltf},
        {"image", readImage},
        {"lesson", readLesson, isText},
        {"preset", readPreset, isText},
        {"print", readPrintFile},
        {"request", readRequest, isText},
        {"scene", readScene, isText},
        {"study", readStudy, isText},
        {"tour", readTour, isText},
        {"typed", readTyped},
    }};
    return all;
}

}  // namespace vitrine::fuzz
