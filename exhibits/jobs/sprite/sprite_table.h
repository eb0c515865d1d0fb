#pragma once

#include "exhibits/framework/table/parameters.h"

#include <string>

namespace vitrine {

/// Palette of the sheet. The further choices are the palettes of the exhibit Pixel Art, by name.
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
    Text animation = text("animation", "Name of the model's animation to play. Empty: the first one in its file.",
                          whenGiven(model), ofFile(model));

    Group frameGroup = group("Frames");
    Count directions =
        count("directions", 8, Range{1, 64}.soft(1, 16), "Number of view directions, evenly spaced around the object.");
    Count frames = count(
        "frames", 0, Range{1, 256}.soft(1, 24),
        "Number of frames per direction, evenly spaced over the animation. Auto: 12 if the model is animated, else 1.",
        reads(0, "auto"));
    Choice<SpriteMotion> motion = choice(
        "motion", SpriteMotion::automatic, {"automatic", "kept", "in place"},
        "Distance that the object travels in the animation: kept in the frames, or removed from them (in place), so "
        "that it walks on the spot and the pivot moves. Automatic: removed if longer than the object.");
    Real framesPerSecond =
        real("framesPerSecond", 12, none, Range{0, 1000}.soft(0, 30),
             "Frames per second that the description file gives. Auto: the frames last as long as the animation.",
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
               "Dithering method for colors between those of the palette. Ordered and blue noise keep their pattern "
               "from frame to frame.");

    Group sheetGroup = group("Sheet");
    Toggle trimmed = toggle("trimmed", false, "Cut off the empty rows and columns around each frame.", option("trim"));
    Choice<SpritePivot> pivot = choice("pivot", SpritePivot::origin, {"origin", "center", "bottom"},
                                       "Pivot of the frames in the description file: the object's origin, the middle "
                                       "of the frame, or the middle of its lower edge.");
    Toggle normals = toggle("normals", true,
                            "Write a second sheet with normals in view space, aligned with the first to the pixel.");
    Toggle depth = toggle("depth", true, "Write a third sheet with depth: near is white.");
    Toggle description = toggle(
        "description", true, "Write a description file with the place of every frame, as JSON in Aseprite's format.");
};

[[nodiscard]] const SpriteTable& spriteTable();

}  // namespace vitrine
