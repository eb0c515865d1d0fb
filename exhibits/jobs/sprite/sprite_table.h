#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/jobs/sprite/palette_file.h"

#include <string>

namespace vitrine::jobs {

/// Palette of the sheet. The choices between these are the palettes of the exhibit Pixel Art, by name.
enum class SpritePalette : int { own, file = 10 };
enum class SpritePaletteFile : int { none, gpl, hex, pal };
enum class SpriteDither : int { none, ordered, errorDiffusion, blueNoise };
enum class SpritePivot : int { origin, center, bottom };
enum class SpriteMotion : int { automatic, kept, inPlace };
enum class SpriteDirectionNames : int { numbers, compass };
enum class SpriteNormalY : int { up, down };
enum class SpriteJson : int { array, hash };
enum class SpriteAnimation : int { none, gif, apng };

/// Parameters of a sprite sheet.
struct SpriteTable final : Parameters {
    Group objectGroup = group("Object");
    File model =
        file("model",
             "Object that is drawn: a glTF 2.0 file (.glb, .gltf), whose animation is played. Without one, the "
             "torus over its pillar.",
             extensions("glb gltf"), positional());
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
               {"own", "isle", "Game Boy", "NES", "C64", "EGA", "ZX Spectrum", "MSX", "PICO-8", "one bit", "file"},
               "Palette of all frames: made of their own colors, a shipped one, or that of a file.");
    File paletteFile = file(
        "paletteFile",
        "Path of a palette: of GIMP (.gpl), Lospec (.hex) or Paint Shop Pro (.pal, JASC), or a picture, of which all "
        "colors are taken, or 256 main ones.",
        extensions(paletteEndings()), when(palette, SpritePalette::file), implies(palette, SpritePalette::file));
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
    Choice<SpriteDirectionNames> directionNames =
        choice("directionNames", SpriteDirectionNames::numbers, {"numbers", "compass"},
               "Names of the directions in tags and animations: numbers from 0, or the compass point that the front of "
               "the object (+Z in glTF) faces on the picture: S faces the viewer, E right. The nearest of 8 points, or "
               "of 16 for more than 8 directions.");
    Toggle normals = toggle("normals", true,
                            "Write a second sheet with normals in view space, aligned with the first to the pixel.");
    Choice<SpriteNormalY> normalY =
        choice("normalY", SpriteNormalY::up, {"up", "down"},
               "Direction of +Y in the normal map: up, as OpenGL, Godot and Unity expect it, or down, as DirectX and "
               "Unreal do. The description file says which.",
               when(normals), labeled("+Y of the normals"));
    Toggle depth = toggle("depth", true, "Write a third sheet with depth: near is white.");

    Group engineGroup = group("Files for engines");
    Toggle description = toggle(
        "description", true, "Write a description file with the place of every frame, as JSON in Aseprite's format.");
    Choice<SpriteJson> form =
        choice("form", SpriteJson::array, {"array", "hash"},
               "Form of the description file: an array of frames by number, for Phaser's createFromAseprite, or a hash "
               "of frames by name, with animations and anchors for Pixi.",
               when(description), labeled("Form of the description"));
    Toggle godot = toggle("godot", false,
                          "Write a resource of Godot 4 (.tres): SpriteFrames with an animation for each direction, lit "
                          "by the normal map.",
                          labeled("Resource for Godot"));
    Choice<SpritePaletteFile> savedPalette = choice(
        "savedPalette", SpritePaletteFile::none, {"none", "gpl", "hex", "pal"},
        "File of the palette to write beside the sheet: none, of GIMP (.gpl), of Lospec (.hex), or of Paint Shop "
        "Pro (.pal, JASC).");
    Choice<SpriteAnimation> animated = choice(
        "animated", SpriteAnimation::none, {"none", "gif", "apng"},
        "Animated picture of all directions to write beside the sheet, enlarged to at least 256 pixels. A GIF has "
        "a gray background, an APNG is transparent.",
        labeled("Animated picture"));
};

[[nodiscard]] const SpriteTable& spriteTable();

}  // namespace vitrine::jobs
