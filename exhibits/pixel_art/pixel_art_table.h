#pragma once

#include "exhibits/framework/table/parameters.h"
#include "exhibits/framework/table/studied_parameters.h"
#include "render/image/picture_formats.h"

namespace vitrine::pixel_art {

enum class PixelWorld : int { isle, testScene, thinBars };
enum class PixelProjection : int { orthographic, perspective };
enum class PixelResolution : int { r240, r320, r480, r640, r960, r1920 };
enum class PixelUpscale : int { integer, sharp };
enum class NormalsBy : int { trueNormals, tap3, tap4, tap5, tap9, tap9Plus, parabola, vote };
enum class PixelView : int { finished, normals, error, depth, edges };
enum class DepthBits : int { float32, unorm24, unorm16 };
enum class DepthOrder : int { reversed, standard };
enum class EdgeLook : int { adaptive, reference };
enum class PaletteName : int { none, isle, gameBoy, nes, c64, ega, spectrum, msx, pico8, oneBit, goldenHour };
enum class Dither : int { none, ordered, blueNoise, errorDiffusion };

/// All parameters of the pixel art. Lengths are in meters of the small world.
struct PixelArtTable final : Parameters {
    Group show = group("Display");
    Choice<PixelWorld> world =
        choice("world", PixelWorld::isle, {"isle", "test scene", "thin bars"},
               "World to show: a small isle, the test scene of the reference, or bars of one and two pixels.");
    File model =
        file("model", "Path of a glTF 2.0 file (.glb or .gltf) that replaces the small world.", extensions("glb gltf"));
    Toggle turn = toggle("turn", true, "Whether the model turns about the vertical axis, once per round of 4 s.",
                         whenGiven(model));
    Count animation = count("animation", 1, Range{0, 1000}.soft(0, 8),
                            "Number of the model's animation to play, in the order of its file; 0 is none. Numbers "
                            "above the last one play the last one.",
                            whenGiven(model));
    Real animationSpeed = real("animationSpeed", 1, none, Range{0, 100}.soft(0, 4),
                               "Speed of the model's animation: 1 is as in its file, 0 stops it.",
                               whenGiven(model) and whenAbove(animation, 0));
    Toggle animate =
        toggle("animate", false, "Whether time runs: the torus tumbles, cubes bob, water moves; a round takes 4 s.");
    Real moment = real("moment", 0.55, second, Range{0, 4},
                       "Time within the loop that is shown, or at which the animation starts.");
    Real frameRate = real("frameRate", 12, none, Range{1, 60}.soft(4, 30),
                          "Frames per second of the animation: few look drawn by hand, many run smoothly.",
                          when(animate) or whenNot(moment, 0));

    Group camera = group("Camera");
    Choice<PixelProjection> projection =
        choice("projection", PixelProjection::orthographic, {"orthographic", "perspective"},
               "Projection of the camera: orthographic, which is usual for pixel art, or perspective, in which "
               "distance makes things smaller.");
    Real azimuth = real("azimuth", degrees(225), degree, Range{degrees(-360), degrees(360)}.soft(0, degrees(360)),
                        "Horizontal angle of the camera around the middle of the world.");
    Real elevation =
        real("elevation", degrees(32), degree, Range{degrees(-85), degrees(85)}.soft(degrees(5), degrees(80)),
             "Height of the camera above the horizon, as an angle: negative looks up from below.");
    Real distance = real("distance", 20, meter, Range{0.5, 90, logarithmic}.soft(8, 60),
                         "Distance of the camera from the middle of the world; in orthographic projection, the start "
                         "of the visible range.");
    Real tall = real("tall", 9.8, meter, Range{0.1, 80, logarithmic}.soft(3, 16),
                     "Height of the view at the middle of the world: low zooms in, high zooms out.");
    Real panX = real("panX", 0, meter, Range{-20, 20}.soft(-3, 3), "Shift of the camera to the right.");
    Real panY = real("panY", 1.0, meter, Range{-20, 20}.soft(-3, 3), "Shift of the camera upwards.");
    Toggle snap = toggle("snap", true,
                         "Whether the camera moves by whole texels and turns by whole steps, so that pixels do not "
                         "crawl; the remainder shifts the finished picture.");
    Real turnStep =
        real("turnStep", degrees(1.5), degree, Range{degrees(0.1), degrees(45), logarithmic},
             "Angle of a step by which the camera turns: large keeps pixels stable for longer.", when(snap));
    Real parallax =
        real("parallax", 0.45, none, {0, 2},
             "Amount by which the view follows a visitor who steps aside: 0 is a flat picture, 1 a window.");

    Group pixels = group("Pixels");
    Choice<PixelResolution> resolution =
        choice("resolution", PixelResolution::r240,
               {"240 x 135", "320 x 180", "480 x 270", "640 x 360", "960 x 540", "1920 x 1080"},
               "Resolution of the small picture in pixels.", essential());
    Choice<PixelUpscale> upscale = choice("upscale", PixelUpscale::sharp, {"integer", "sharp"},
                                          "Enlargement of the small picture: each texel by a whole number of pixels, "
                                          "or to any size with borders smoothed over one pixel (sharp).");

    Group normals = group("Normals");
    Toggle split =
        toggle("split", false, "Whether the picture is split into two halves, each with its own method and view.");
    Real divider = real("divider", 0.5, none, {0, 1},
                        "Position of the boundary between the halves: 0 is the left edge, 1 the right.", when(split));
    Choice<NormalsBy> method = choice("method", NormalsBy::parabola,
                                      {"true", "3 tap", "4 tap", "5 tap", "9 tap", "9 plus tap", "parabola", "vote"},
                                      "Method for normals: drawn ones (true), or reconstructed from depth by fixed "
                                      "neighbors (3, 4), nearer ones (5), those in line with a texel (9, 9 plus), a "
                                      "parabola, or a vote of the texels around, which thin objects need.",
                                      exactAt(NormalsBy::trueNormals), essential());
    Choice<NormalsBy> rightMethod =
        choice("rightMethod", NormalsBy::trueNormals,
               {"true", "3 tap", "4 tap", "5 tap", "9 tap", "9 plus tap", "parabola", "vote"},
               "Method for normals in the right half.", when(split));
    Choice<PixelView> view = choice("view", PixelView::finished, {"finished", "normals", "error", "depth", "edges"},
                                    "Picture to show: the finished one, or a step on the way to it.");
    Choice<PixelView> rightView =
        choice("rightView", PixelView::finished, {"finished", "normals", "error", "depth", "edges"},
               "Picture to show in the right half.", when(split));
    Real errorScale = real("errorScale", 20, none, Range{0.1, 180, logarithmic}.soft(1, 90),
                           "Error that is shown hottest, in degrees: low brings out small errors.",
                           when(view, PixelView::error) or (when(split) and when(rightView, PixelView::error)));
    Count smoothing = count(
        "smoothing", 0, {0, 4},
        "Radius over which faceted normals are averaged, in texels, but not across edges: 0 keeps facets.", exactAt(0));
    const Condition finished =
        when(view, PixelView::finished) or (when(split) and when(rightView, PixelView::finished));
    const Condition edged =
        finished or when(view, PixelView::edges) or (when(split) and when(rightView, PixelView::edges));
    Toggle fixVoid = toggle(
        "fixVoid", true,
        "Whether the empty background gets normals towards the camera, so that objects have no edges against it.",
        (edged and whenLater("edges", 1)) or when(view, PixelView::normals) or
            (when(split) and when(rightView, PixelView::normals)));
    Choice<DepthBits> depthBits =
        choice("depthBits", DepthBits::float32, {"32 bit", "24 bit", "16 bit"},
               "Precision of the depth buffer: 16 bits make visible errors in normals.", exactAt(DepthBits::float32));
    Choice<DepthOrder> depthOrder =
        choice("depthOrder", DepthOrder::reversed, {"reversed", "standard"},
               "Order of the depth values: reversed has 1 near and 0 far, standard the opposite.",
               exactAt(DepthOrder::reversed));
    StudiedParameters studied{
        *this,
        {{.name = "smoothing", .exactInReference = {"method"}},
         {.name = "depthOrder", .same = "Either order holds the same depths, so that the picture is the same."}}};

    Group light = group("Light");
    Real sunAzimuth = real("sunAzimuth", degrees(-62), degree, Range{degrees(-180), degrees(180)},
                           "Horizontal direction of the sun, seen from the camera: negative is to the left.", finished);
    Real sunElevation = real("sunElevation", degrees(44), degree, Range{degrees(5), degrees(90)},
                             "Height of the sun above the horizon: low makes long shadows.", finished);
    Toggle shadows = toggle("shadows", true, "Whether objects cast shadows.", finished);
    Count bands =
        count("bands", 4, {1, 8}, "Number of tones from shade to light, as in hand-drawn pixel art; 1 shades smoothly.",
              finished, essential());
    Color sunLight = color("sunLight", {1.0, 0.86, 0.60}, "Color of the sunlight.", finished);
    Color shadeLight =
        color("shadeLight", {0.30, 0.36, 0.55}, "Color of the sky's light, which fills shadows from above.", finished);
    Color bounceLight =
        color("bounceLight", {0.20, 0.19, 0.34}, "Color of the light that fills shadows from below.", finished);
    Color zenith = color("zenith", {0.10, 0.26, 0.44}, "Color of the background at the top.", finished);
    Color horizon = color("horizon", {0.36, 0.52, 0.58}, "Color of the background at the bottom.", finished);

    Group lines = group("Lines");
    Choice<EdgeLook> edges = choice("edges", EdgeLook::adaptive, {"adaptive", "reference"},
                                    "Edge detection: adaptive, one texel wide with thresholds that follow distance and "
                                    "slope, or the formulas of the reference in meters.",
                                    edged);
    Real highlightStrength = real("highlightStrength", 0.22, none, {0, 1},
                                  "Strength of the light lines on edges that face the camera: 0 draws none.", finished);
    Color highlightColor = color("highlightColor", {1, 0.95, 0.8}, "Color of the light lines.",
                                 finished and whenAbove(highlightStrength, 0));
    Real outlineStrength =
        real("outlineStrength", 0.75, none, {0, 1},
             "Strength of the dark lines on the borders of near objects: 0 draws none.", finished, essential());
    Color outlineColor = color("outlineColor", {0.012, 0.010, 0.03}, "Color of the dark lines.",
                               finished and whenAbove(outlineStrength, 0));
    const Condition adaptiveEdges = when(edges, EdgeLook::adaptive);
    Real coloredOutline = real(
        "coloredOutline", 0.75, none, {0, 1},
        "Share of the bordering object's color in a dark line: 0 uses the outline color, 1 a dark tone of the object.",
        finished and adaptiveEdges and whenAbove(outlineStrength, 0));
    Real outlineGap =
        real("outlineGap", 4.5, none, Range{0.5, 100, logarithmic}.soft(1, 20),
             "Depth between two surfaces that makes a line, in texels after removing the slope: low draws more lines.",
             edged and adaptiveEdges);
    Real edgeAngle =
        real("edgeAngle", degrees(32), degree, Range{degrees(5), degrees(120)},
             "Angle by which a surface must turn to make an edge: low draws more lines.", edged and adaptiveEdges);
    Toggle objectOutlines =
        toggle("objectOutlines", true, "Whether lines separate objects that touch.", edged and adaptiveEdges);

    Group colors = group("Palette");
    Choice<PaletteName> palette = choice(
        "palette", PaletteName::isle,
        {"none", "isle", "Game Boy", "NES", "C64", "EGA", "ZX Spectrum", "MSX", "PICO-8", "one bit", "golden hour"},
        "Palette that limits the colors: none, made for the isle, of an old machine, or of a picture of the hall "
        "(golden hour).",
        finished, essential());
    File palettePicture = file("palettePicture", "Path of a picture whose main colors replace the palette.",
                               extensions(render::readEndings()));
    const Condition ofPicture = when(palette, PaletteName::goldenHour) or whenGiven(palettePicture);
    const Condition limited = finished and (whenNot(palette, PaletteName::none) or whenGiven(palettePicture));
    Count paletteColors =
        count("paletteColors", 24, {2, 64}, "Number of colors taken from the picture.", finished and ofPicture);
    Choice<Dither> dither =
        choice("dither", Dither::none, {"none", "ordered", "blue noise", "error diffusion"},
               "Dithering method for colors between those of the palette: ordered, blue noise, or error diffusion.",
               limited, essential());
    Real ditherStrength =
        real("ditherStrength", 0.6, none, {0, 1},
             "Strength of the dithering: at 1 average colors are kept, less leaves calm areas.",
             limited and (when(dither, {Dither::ordered, Dither::blueNoise, Dither::errorDiffusion})));
};

}  // namespace vitrine::pixel_art
