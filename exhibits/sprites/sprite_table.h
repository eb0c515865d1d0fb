#pragma once

#include "exhibits/framework/parameters.h"

#include <string>

namespace vitrine {

/// The others are those of the look's own row, by name.
enum class SpritePalette : int { own };
enum class SpriteDither : int { none, ordered, errorDiffusion, blueNoise };
enum class SpritePivot : int { origin, center, bottom };
enum class SpriteMotion : int { automatic, kept, inPlace };

/// Everything that can be set about a sheet of sprites, but the animation's name, which a file gives.
struct SpriteTable final : Parameters {
    Group objectGroup = group("Object");
    File model =
        file("model", "A glTF 2.0 file, .glb or .gltf; without one, the torus over its pillar.", endings("glb gltf"));

    Group frameGroup = group("Frames");
    Count directions = count("directions", 8, Range{1, 64}.soft(1, 16), "From how many sides it is drawn, evenly.");
    Count frames = count("frames", 12, Range{1, 256}.soft(1, 24), "Of each direction, evenly over the animation.");
    Choice<SpriteMotion> motion =
        choice("motion", SpriteMotion::automatic, {"automatic", "kept", "in place"},
               "Way that the animation carries the object from its first to its last moment: kept, so that the frames "
               "hold all of it, or taken out of the frames, so that it walks in place and the pivot moves. Automatic "
               "takes out what is longer than the object.");
    Real framesPerSecond = real("framesPerSecond", 12, none, Range{0, 1000}.soft(0, 30),
                                "What the description tells; 0: as long as the animation.", reads(0, "auto"));
    Count width = count("width", 64, Range{1, 16384, logarithmic}.soft(8, 256), "Of a frame, pixels.");
    Count height = count("height", 64, Range{1, 16384, logarithmic}.soft(8, 256), "Of a frame, pixels.");

    Group colorGroup = group("Colors");
    Choice<SpritePalette> palette =
        choice("palette", SpritePalette::own,
               {"own", "isle", "Game Boy", "NES", "C64", "EGA", "ZX Spectrum", "MSX", "PICO-8", "one bit"},
               "One for all frames: made of them, or a shipped one.");
    Count colors = count("colors", 32, Range{1, 256}.soft(2, 64), "How many the palette made of the frames has.",
                         when(palette, SpritePalette::own));
    Choice<SpriteDither> dither =
        choice("dither", SpriteDither::none, {"none", "ordered", "error diffusion", "blue noise"},
               "How colors between those of the palette are hinted at. Ordered and blue "
               "noise stay where they are from frame to frame.");

    Group sheetGroup = group("Sheet");
    Toggle trimmed = toggle("trimmed", false, "Cut off the empty rows and columns around each frame.");
    Choice<SpritePivot> pivot = choice("pivot", SpritePivot::origin, {"origin", "center", "bottom"},
                                       "The point that the description gives: the object's origin, the middle of the "
                                       "frame, or the middle of its lower edge.");
    Toggle normals = toggle("normals", true, "A second sheet with normals, view space, aligned to the pixel.");
    Toggle depth = toggle("depth", true, "A third sheet with depth: near is white.");
    Toggle description = toggle("description", true, "Where every frame lies, in the JSON that Aseprite exports.");
};

[[nodiscard]] const SpriteTable& spriteTable();

/// Why there can be no such sheet, a sentence; empty where there can.
[[nodiscard]] std::string whyNoSheet(const ParameterValues&);

}  // namespace vitrine
