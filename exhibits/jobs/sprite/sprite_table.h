#pragma once

#include "exhibits/framework/table/parameters.h"

#include <string>

namespace vitrine {

/// Palette of the sheet. Further choices are the palettes of the pixel art, by name.
enum class SpritePalette : int { own };
enum class SpriteDither : int { none, ordered, errorDiffusion, blueNoise };
enum class SpritePivot : int { origin, center, bottom };
enum class SpriteMotion : int { automatic, kept, inPlace };

/// Parameters of a sprite sheet.
struct SpriteTable final : Parameters {
    Group objectGroup = group("Object");
    File model =
        file("model",
             "Object that is drawn: a glTF 2.0 file (.glb, .gltf), whose animation is played. Without one, the "
             "torus over its pillar.",
             endings("glb gltf"), positional());
    Text animation = text("animation", "Name of the animation that is played. Empty: the first one of the file.",
                          whenGiven(model), ofFile(model));

    Group frameGroup = group("Frames");
    Count directions =
        count("directions", 8, Range{1, 64}.soft(1, 16), "Number of view directions, evenly spaced around the object.");
    Count frames = count("frames", 0, Range{1, 256}.soft(1, 24),
                         "Number of frames per direction, evenly spaced over the animation. Auto: 12 of what is "
                         "animated, else 1.",
                         reads(0, "auto"));
    Choice<SpriteMotion> motion =
        choice("motion", SpriteMotion::automatic, {"automatic", "kept", "in place"},
               "Way that the animation carries the object from its first to its last moment: kept, so that the frames "
               "hold all of it, or taken out of the frames, so that it walks in place and the pivot moves. Automatic "
               "takes out what is longer than the object.");
    Real framesPerSecond = real("framesPerSecond", 12, none, Range{0, 1000}.soft(0, 30),
                                "Frames per second that the description tells. Auto: as long as the animation.",
                                reads(0, "auto"), option("fps"));
    Count width =
        count("width", 64, Range{1, 16384, logarithmic}.soft(8, 256), "Size of a frame in pixels.", tuple("size", 'x'));
    Count height = count("height", 64, Range{1, 16384, logarithmic}.soft(8, 256), "Size of a frame in pixels.",
                         tuple("size", 'x'));

    Group colorGroup = group("Colors");
    Choice<SpritePalette> palette =
        choice("palette", SpritePalette::own,
               {"own", "isle", "Game Boy", "NES", "C64", "EGA", "ZX Spectrum", "MSX", "PICO-8", "one bit"},
               "Palette of all frames: their own, made of their colors, or a shipped one.");
    Count colors = count("colors", 32, Range{1, 256}.soft(2, 64), "Number of colors of the frames' own palette.",
                         when(palette, SpritePalette::own));
    Choice<SpriteDither> dither =
        choice("dither", SpriteDither::none, {"none", "ordered", "error diffusion", "blue noise"},
               "Pattern that hints at colors between those of the palette. Ordered and blue noise stay where they are "
               "from frame to frame.");

    Group sheetGroup = group("Sheet");
    Toggle trimmed = toggle("trimmed", false, "Cut off the empty rows and columns around each frame.", option("trim"));
    Choice<SpritePivot> pivot = choice("pivot", SpritePivot::origin, {"origin", "center", "bottom"},
                                       "Point that the description gives: the object's origin, the middle of the "
                                       "frame, or the middle of its lower edge.");
    Toggle normals = toggle("normals", true, "Write a second sheet with normals, view space, aligned to the pixel.");
    Toggle depth = toggle("depth", true, "Write a third sheet with depth: near is white.");
    Toggle description =
        toggle("description", true, "Write where every frame lies, in the JSON that Aseprite exports.");
};

[[nodiscard]] const SpriteTable& spriteTable();

}  // namespace vitrine
