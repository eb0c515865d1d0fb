#include "exhibits/pixel_art/palette.h"

#include <vector>

namespace vitrine::pixel_art {
namespace {

std::vector<Rgb8> colorsOf(std::initializer_list<std::uint32_t> codes)
{
    std::vector<Rgb8> colors;
    for (const std::uint32_t c : codes)
        colors.emplace_back(static_cast<std::uint8_t>(c >> 16U), static_cast<std::uint8_t>(c >> 8U),
                            static_cast<std::uint8_t>(c));
    return colors;
}

/// Color ramps with violet shades and yellow lights.
const std::vector<Rgb8>& isleColors()
{
    static const std::vector<Rgb8> colors = colorsOf({0x14101f, 0x231a2f, 0x352845, 0x4a3b5c, 0x655676,
                                                      0x857892, 0xa79dab, 0xc9c3c4,  // Ink to gray.
                                                      0x3b1f2b, 0x5b2f33, 0x7f4639, 0xa4653f, 0xc88a4d,
                                                      0xe3b469, 0xf3d993, 0xfdf3cd,  // Earth, wood, sand, cream.
                                                      0x12303a, 0x17484a, 0x1f6250, 0x2f7d4c, 0x549a45,
                                                      0x86b545, 0xbdd05a, 0xe6e68c,  // Leaves.
                                                      0x10243f, 0x143a5a, 0x1b5674, 0x257789, 0x3b9c9c,
                                                      0x69c0b0, 0x65d1e4, 0xe2f5e4,  // Water.
                                                      0x55182f, 0x8f6f4c, 0xa8503f, 0xcf6a50, 0xf08f4a,
                                                      0xfbbf58, 0xf5dc76, 0xe6cfa4,  // Roofs, gold.
                                                      0xd98090, 0xf0b3ab, 0x908478, 0xb3a191, 0x6b5a7e,
                                                      0x9a8fb5, 0xd8c7b7, 0x486b52});  // Blossom, stone in the sun.
    return colors;
}

/// Colors of the NES picture processing unit 2C02: 54 colors as its composite output is usually decoded.
const std::vector<Rgb8>& nesColors()
{
    static const std::vector<Rgb8> colors = colorsOf(
        {0x7c7c7c, 0x0000fc, 0x0000bc, 0x4428bc, 0x940084, 0xa80020, 0xa81000, 0x881400, 0x503000, 0x007800, 0x006800,
         0x005800, 0x004058, 0xbcbcbc, 0x0078f8, 0x0058f8, 0x6844fc, 0xd800cc, 0xe40058, 0xf83800, 0xe45c10, 0xac7c00,
         0x00b800, 0x00a800, 0x00a844, 0x008888, 0xf8f8f8, 0x3cbcfc, 0x6888fc, 0x9878f8, 0xf878f8, 0xf85898, 0xf87858,
         0xfca044, 0xf8b800, 0xb8f818, 0x58d854, 0x58f898, 0x00e8d8, 0x787878, 0xfcfcfc, 0xa4e4fc, 0xb8b8f8, 0xd8b8f8,
         0xf8b8f8, 0xf8a4c0, 0xf0d0b0, 0xfce0a8, 0xf8d878, 0xd8f878, 0xb8f8b8, 0xb8f8d8, 0x00fcfc, 0x000000});
    return colors;
}

}  // namespace

std::span<const Rgb8> shippedPalette(PaletteName name)
{
    static const std::vector<Rgb8> gameBoy = colorsOf({0x0f380f, 0x306230, 0x8bac0f, 0x9bbc0f});
    // Timmermann 2001, "Calculating the color palette of the VIC II".
    static const std::vector<Rgb8> c64 =
        colorsOf({0x000000, 0xffffff, 0x68372b, 0x70a4b2, 0x6f3d86, 0x588d43, 0x352879, 0xb8c76f, 0x6f4f25, 0x433900,
                  0x9a6759, 0x444444, 0x6c6c6c, 0x9ad284, 0x6c5eb5, 0x959595});
    static const std::vector<Rgb8> ega =
        colorsOf({0x000000, 0x0000aa, 0x00aa00, 0x00aaaa, 0xaa0000, 0xaa00aa, 0xaa5500, 0xaaaaaa, 0x555555, 0x5555ff,
                  0x55ff55, 0x55ffff, 0xff5555, 0xff55ff, 0xffff55, 0xffffff});
    static const std::vector<Rgb8> spectrum =
        colorsOf({0x000000, 0x0000d7, 0xd70000, 0xd700d7, 0x00d700, 0x00d7d7, 0xd7d700, 0xd7d7d7, 0x0000ff, 0xff0000,
                  0xff00ff, 0x00ff00, 0x00ffff, 0xffff00, 0xffffff});
    // Colors of the TMS9918 by the levels in its data sheet.
    static const std::vector<Rgb8> msx =
        colorsOf({0x000000, 0x21c842, 0x5edc78, 0x5455ed, 0x7d76fc, 0xd4524d, 0x42ebf5, 0xfc5554, 0xff7978, 0xd4c154,
                  0xe6ce80, 0x21b03b, 0xc95bba, 0xcccccc, 0xffffff});
    static const std::vector<Rgb8> pico8 =
        colorsOf({0x000000, 0x1d2b53, 0x7e2553, 0x008751, 0xab5236, 0x5f574f, 0xc2c3c7, 0xfff1e8, 0xff004d, 0xffa300,
                  0xffec27, 0x00e436, 0x29adff, 0x83769c, 0xff77a8, 0xffccaa});
    static const std::vector<Rgb8> oneBit = colorsOf({0x000000, 0xffffff});
    switch (name) {
    case PaletteName::isle: return isleColors();
    case PaletteName::gameBoy: return gameBoy;
    case PaletteName::nes: return nesColors();
    case PaletteName::c64: return c64;
    case PaletteName::ega: return ega;
    case PaletteName::spectrum: return spectrum;
    case PaletteName::msx: return msx;
    case PaletteName::pico8: return pico8;
    case PaletteName::oneBit: return oneBit;
    case PaletteName::none:
    case PaletteName::goldenHour: break;
    }
    return {};
}

}  // namespace vitrine::pixel_art
