#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/framework/studied_rows.h"

namespace vitrine {

enum class PixelWorld : int { isle, testScene, thinBars };
enum class PixelProjection : int { orthographic, perspective };
enum class PixelResolution : int { r240, r320, r480, r640, r960, r1920 };
enum class PixelUpscale : int { integer, sharp };
enum class NormalsBy : int { trueNormals, tap3, tap4, tap5, tap9, tap9Plus, parabola, vote };
enum class PixelView : int { finished, normals, error, depth, edges };
enum class DepthBits : int { float32, unorm24, unorm16 };
enum class DepthOrder : int { reversed, standard };
enum class EdgeLook : int { ours, source };
enum class PaletteName : int { none, isle, gameBoy, nes, c64, ega, spectrum, msx, pico8, oneBit, goldenHour };
enum class Dither : int { none, ordered, blueNoise, errorDiffusion };

/// All parameters of the pixel art. Lengths are in meters of the small world.
struct PixelArtTable final : Parameters {
    Group show = group("On show");
    Choice<PixelWorld> world = choice("world", PixelWorld::isle, {"isle", "test scene", "thin bars"},
                                      "A small isle, the bare scene that the source tests with, or bars of one and "
                                      "two pixels.");
    File model = file("model", "A glTF 2.0 file, .glb or .gltf, in place of the small world.", endings("glb gltf"));
    Toggle turn = toggle("turn", true, "Let the model turn about the vertical, once a round.", whenGiven(model));
    Count animation =
        count("animation", 1, Range{0, 1000}.soft(0, 8),
              "Which of the model's animations is played, by its number in the file, beyond which there is "
              "the last; 0: none.",
              whenGiven(model));
    Real animationSpeed =
        real("animationSpeed", 1, none, Range{0, 100}.soft(0, 4), "How fast it is played: 1 as the file has it.",
             whenGiven(model) and whenAbove(animation, 0));
    Toggle animate =
        toggle("animate", false, "Let time run: the torus tumbles, cubes bob, water breathes; a round takes 4 s.");
    Real moment = real("moment", 0.55, second, Range{0, 4}, "The moment of the round that is shown, or begun with.");
    Real frameRate =
        real("frameRate", 12, none, Range{1, 60}.soft(4, 30),
             "Pictures a second: few look drawn by hand, many run smoothly.", when(animate) or whenNot(moment, 0));

    Group camera = group("Camera");
    Choice<PixelProjection> projection =
        choice("projection", PixelProjection::orthographic, {"orthographic", "perspective"},
               "Whether distance makes things smaller. Pixel art is mostly orthographic.");
    Real azimuth = real("azimuth", degrees(225), degree, Range{degrees(-360), degrees(360)}.soft(0, degrees(360)),
                        "Where the camera stands around the middle.");
    Real elevation =
        real("elevation", degrees(32), degree, Range{degrees(-85), degrees(85)}.soft(degrees(5), degrees(80)),
             "How far above the horizon it stands.");
    Real distance = real("distance", 20, meter, Range{0.5, 90, logarithmic}.soft(8, 60),
                         "From the middle; of the orthographic camera, where its view begins.");
    Real tall = real("tall", 9.8, meter, Range{0.1, 80, logarithmic}.soft(3, 16),
                     "Height of the picture at the middle: low is near.");
    Real panX = real("panX", 0, meter, Range{-20, 20}.soft(-3, 3), "Slides the camera to the right.");
    Real panY = real("panY", 1.0, meter, Range{-20, 20}.soft(-3, 3), "Slides the camera up.");
    Toggle snap =
        toggle("snap", true,
               "Move the camera by whole texels and turn it by whole steps, so that nothing crawls; the screen "
               "slides the rest.");
    Real turnStep = real("turnStep", degrees(1.5), degree, Range{degrees(0.1), degrees(45), logarithmic},
                         "The step by which it turns.", when(snap));
    Real parallax = real("parallax", 0.45, none, {0, 2},
                         "How much the camera follows a visitor who steps aside: 1 as a window would.");

    Group pixels = group("Pixels");
    Choice<PixelResolution> resolution = choice(
        "resolution", PixelResolution::r240,
        {"240 x 135", "320 x 180", "480 x 270", "640 x 360", "960 x 540", "1920 x 1080"}, "Of the small picture.");
    Choice<PixelUpscale> upscale =
        choice("upscale", PixelUpscale::sharp, {"integer", "sharp"},
               "Every texel by a whole number of pixels, or any, with borders smoothed over one pixel.");

    Group normals = group("Normals");
    Toggle split =
        toggle("split", false, "Divide the picture in two halves, each with a method and a view of its own.");
    Real divider = real("divider", 0.5, none, {0, 1}, "Where the right half begins.", when(split));
    Choice<NormalsBy> method = choice(
        "method", NormalsBy::parabola, {"true", "3 tap", "4 tap", "5 tap", "9 tap", "9 plus tap", "parabola", "vote"},
        "Normals as drawn, or from depth alone: by fixed neighbors (3, 4), the nearer ones (5), those on whose "
        "line a texel lies (9; 9 plus looks at fewer), with the slope of a parabola, or by a vote of the texels "
        "around, which thin things need.",
        exactAt(NormalsBy::trueNormals));
    Choice<NormalsBy> rightMethod =
        choice("rightMethod", NormalsBy::trueNormals,
               {"true", "3 tap", "4 tap", "5 tap", "9 tap", "9 plus tap", "parabola", "vote"},
               "The same of the right half.", when(split));
    Choice<PixelView> view = choice("view", PixelView::finished, {"finished", "normals", "error", "depth", "edges"},
                                    "What is shown: the finished picture, or a step on the way there.");
    Choice<PixelView> rightView =
        choice("rightView", PixelView::finished, {"finished", "normals", "error", "depth", "edges"},
               "The same of the right half.", when(split));
    Real errorScale =
        real("errorScale", 20, none, Range{0.1, 180, logarithmic}.soft(1, 90), "Degrees off that are shown hottest.",
             when(view, PixelView::error) or (when(split) and when(rightView, PixelView::error)));
    Count smoothing = count("smoothing", 0, {0, 4},
                            "Texels around that faceted normals are averaged over, not across edges.", exactAt(0));
    const Condition finished =
        when(view, PixelView::finished) or (when(split) and when(rightView, PixelView::finished));
    const Condition edged =
        finished or when(view, PixelView::edges) or (when(split) and when(rightView, PixelView::edges));
    Toggle fixVoid = toggle("fixVoid", true, "Let what is nothing face the camera, so that no edge is seen against it.",
                            (edged and whenLater("edges", 1)) or when(view, PixelView::normals) or
                                (when(split) and when(rightView, PixelView::normals)));
    Choice<DepthBits> depthBits = choice("depthBits", DepthBits::float32, {"32 bit", "24 bit", "16 bit"},
                                         "What the depth buffer stores.", exactAt(DepthBits::float32));
    Choice<DepthOrder> depthOrder =
        choice("depthOrder", DepthOrder::reversed, {"reversed", "standard"},
               "Whether near is 1 and far 0, or the other way round.", exactAt(DepthOrder::reversed));
    StudiedRows studied{
        *this,
        {{.name = "smoothing", .exactInReference = {"method"}},
         {.name = "depthOrder", .same = "Either order holds the same depths, so that the picture is the same."}}};

    Group light = group("Light");
    Real sunAzimuth = real("sunAzimuth", degrees(-62), degree, Range{degrees(-180), degrees(180)},
                           "Where the sun stands, from the camera's side: negative is to the left.", finished);
    Real sunElevation = real("sunElevation", degrees(44), degree, Range{degrees(5), degrees(90)},
                             "Its height above the horizon.", finished);
    Toggle shadows = toggle("shadows", true, "Let things throw shadows.", finished);
    Count bands =
        count("bands", 4, {1, 8}, "Tones from shade to light, as an artist lays them; 1 is without steps.", finished);
    Color sunLight = color("sunLight", {1.0, 0.86, 0.60}, "Of the sun.", finished);
    Color shadeLight = color("shadeLight", {0.30, 0.36, 0.55}, "Of the sky, which fills shadows from above.", finished);
    Color bounceLight = color("bounceLight", {0.20, 0.19, 0.34}, "Of what fills them from below.", finished);
    Color zenith = color("zenith", {0.10, 0.26, 0.44}, "The background, high up.", finished);
    Color horizon = color("horizon", {0.36, 0.52, 0.58}, "The background, below.", finished);

    Group lines = group("Lines");
    Choice<EdgeLook> edges =
        choice("edges", EdgeLook::ours, {"ours", "as in the source"},
               "Lines of one texel by thresholds that follow distance and slope, or the formulas of "
               "the source, in meters.",
               edged);
    Real highlightStrength =
        real("highlightStrength", 0.22, none, {0, 1}, "Of light on edges that face the camera.", finished);
    Color highlightColor =
        color("highlightColor", {1, 0.95, 0.8}, "Of that light.", finished and whenAbove(highlightStrength, 0));
    Real outlineStrength =
        real("outlineStrength", 0.75, none, {0, 1}, "Of dark lines on the borders of near objects.", finished);
    Color outlineColor =
        color("outlineColor", {0.012, 0.010, 0.03}, "Of these lines.", finished and whenAbove(outlineStrength, 0));
    const Condition ourEdges = when(edges, EdgeLook::ours);
    Real coloredOutline = real("coloredOutline", 0.75, none, {0, 1},
                               "How much a line takes a dark tone of what it borders, in place of its own color.",
                               finished and ourEdges and whenAbove(outlineStrength, 0));
    Real outlineGap =
        real("outlineGap", 4.5, none, Range{0.5, 100, logarithmic}.soft(1, 20),
             "Texels of depth between two surfaces that make a line; slopes are taken off first.", edged and ourEdges);
    Real edgeAngle = real("edgeAngle", degrees(32), degree, Range{degrees(5), degrees(120)},
                          "How far a surface turns at an edge.", edged and ourEdges);
    Toggle objectOutlines =
        toggle("objectOutlines", true, "Lines between objects that touch, by their numbers.", edged and ourEdges);

    Group colors = group("Palette");
    Choice<PaletteName> palette = choice(
        "palette", PaletteName::isle,
        {"none", "isle", "Game Boy", "NES", "C64", "EGA", "ZX Spectrum", "MSX", "PICO-8", "one bit", "golden hour"},
        "The only colors there are: made for the isle, those of old machines, or the main ones of a picture of the "
        "hall.",
        finished);
    File palettePicture =
        file("palettePicture", "A picture whose main colors become the palette, in place of the other.",
             endings("png jpg jpeg tif tiff exr hdr webp bmp gif"));
    const Condition ofPicture = when(palette, PaletteName::goldenHour) or whenGiven(palettePicture);
    const Condition limited = finished and (whenNot(palette, PaletteName::none) or whenGiven(palettePicture));
    Count paletteColors =
        count("paletteColors", 24, {2, 64}, "How many colors are taken from a picture.", finished and ofPicture);
    Choice<Dither> dither = choice("dither", Dither::none, {"none", "ordered", "blue noise", "error diffusion"},
                                   "How colors between those of the palette are hinted at.", limited);
    Real ditherStrength =
        real("ditherStrength", 0.6, none, {0, 1}, "How far: at 1 means are kept, less leaves calm areas.",
             limited and (when(dither, {Dither::ordered, Dither::blueNoise, Dither::errorDiffusion})));
};

}  // namespace vitrine
