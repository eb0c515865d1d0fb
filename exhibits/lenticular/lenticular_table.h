#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/image/picture_formats.h"

namespace vitrine::lenticular {

enum class CardFace : int { front, back };
enum class CardSheet : int { twenty3d = 4, custom = 23 };
enum class CardAxis : int { vertical, horizontal };
enum class CardStrips : int { flat, squeezed };
enum class CardModel : int { linear, paraxial, exact };
enum class CardEyes : int { off, left, right, anaglyph };

/// All parameters of the lenticular card. Lengths are in meters.
struct LenticularTable final : Parameters {
    Group prints = group("Prints");
    File frontPrint = file("frontPrint",
                           "Path of the views of the first print: a folder of pictures, or a file written by “vitrine "
                           "print”. Empty: the turning mug.",
                           extensions(render::readEndings()));
    File backPrint = file("backPrint",
                          "Path of the views of the second print: a folder of pictures, or a file written by “vitrine "
                          "print”. Empty: the melting torus.",
                          extensions(render::readEndings()));
    Choice<CardFace> face =
        choice("face", CardFace::front, {"front", "back"}, "Print that the card shows while it does not scroll.");
    Count views = count(
        "views", 16, Range{1, 256}.soft(1, 32),
        "Number of views under each lens, chosen evenly from those of the print; never more than it has.", essential());
    Toggle scroll =
        toggle("scroll", true, "Whether the card scrolls from one print to the other and back, like a billboard.");
    Real period =
        real("period", 12, second, Range{0.1, 3600}.soft(2, 30), "Time from one print to the next.", when(scroll));
    Real hold = real("hold", 0.85, none, {0, 1},
                     "Share of the period in which a print stays in place: low scrolls slowly, high scrolls quickly.",
                     when(scroll));
    Real margin =
        real("margin", 0.012, meter, Range{0, 0.15}.soft(0, 0.05), "Width of the white paper around the pictures.");

    Group sheet = group("Sheet");
    Choice<CardSheet> sheetKind =
        choice("sheetKind", CardSheet::twenty3d,
               {"10-3d", "10-flip", "15-3d",  "15-flip",  "20-3d",  "20-flip",  "30-3d",       "30-flip",
                "40-3d", "40-flip", "50-3d",  "50-flip",  "60-3d",  "60-flip",  "62-3d",       "62-flip",
                "75-3d", "75-flip", "100-3d", "100-flip", "161-3d", "161-flip", "75-measured", "custom"},
               "Lenticular sheet: lenses per inch and viewing zone, 30 degrees (3d) or 50 (flip). Custom uses the "
               "parameters below.",
               essential());
    Count slices = count("slices", 0, Range{0, 8000}.soft(0, 1000),
                         "Number of lenses across the card; the shape of the sheet is scaled to fit. 0 follows from "
                         "the LPI of the sheet.",
                         reads(0, "auto"), essential());
    Choice<CardAxis> axis = choice("axis", CardAxis::vertical, {"vertical", "horizontal"},
                                   "Direction of the lenses: vertical lenses change when you move sideways, horizontal "
                                   "ones when you move up or down.");
    Real customLpi = real("customLpi", 40, none, Range{1, 400}.soft(5, 160),
                          "Number of lenses per inch of the custom sheet.", when(sheetKind, CardSheet::custom));
    Real radius = real(
        "radius", 0.000381, millimeter, Range{1e-5, 0.1}.soft(0.0001, 0.003),
        "Radius of curvature at the top of a custom lens; a radius too small for the lens pitch is enlarged to fit.",
        when(sheetKind, CardSheet::custom));
    Real thickness =
        real("thickness", 0.001062, millimeter, Range{1e-5, 0.3}.soft(0.0002, 0.008),
             "Thickness of the custom sheet from the top of a lens to the print: too thin or too thick blurs.",
             when(sheetKind, CardSheet::custom));
    Real refractiveIndex = real("refractiveIndex", 1.56, none, Range{1.01, 3}.soft(1.3, 1.8),
                                "Refractive index of the custom sheet's plastic: 1.49 to 1.6 are usual.",
                                when(sheetKind, CardSheet::custom));
    Real conic = real("conic", 0, none, Range{-5, 2}.soft(-1, 0.5),
                      "Conic constant of a custom lens: 0 is a circle, -0.41 the ellipse that is sharp straight ahead.",
                      when(sheetKind, CardSheet::custom));

    Group lens = group("Simulation");
    Choice<CardModel> model =
        choice("model", CardModel::exact, {"linear", "paraxial", "exact"},
               "Model that finds the strip seen at a view angle: proportional to its tangent as in the reference "
               "(linear), first-order optics (paraxial), or Snell's law at the lens (exact).",
               exactAt(CardModel::exact), essential());
    Real magnification = real("magnification", 1, none, {0, 2},
                              "Size of the spot that a lens shows, relative to the model: 0 is one point of a strip, "
                              "above 1 neighboring strips bleed in.");
    Real intendedMaxAngle = real(
        "intendedMaxAngle", degrees(45), degree, Range{degrees(1), degrees(85)}.soft(degrees(5), degrees(60)),
        "Angle to either side at which the linear model reaches the outermost view.", when(model, CardModel::linear));
    Count apertureSamples = count("apertureSamples", 8, {1, 64, logarithmic},
                                  "Number of rays traced over a lens, or over the part of it under a pixel: few show "
                                  "steps between views, many are smooth.",
                                  quality(64), whenLater("prefilter", 1));
    Toggle prefilter = toggle("prefilter", true,
                              "Whether the color is averaged over the lens and the pixel; without it, one ray per "
                              "pixel gives moiré from afar.",
                              quality(1));
    Toggle dispersion =
        toggle("dispersion", false, "Whether red, green and blue are refracted separately, by Cauchy's formula.");
    Real abbeNumber =
        real("abbeNumber", 30, none, Range{5, 100}.soft(15, 80),
             "Abbe number of the plastic: low spreads colors widely, high hardly. Acrylic has 57, polycarbonate 30.",
             when(dispersion));
    Choice<CardEyes> eyes = choice("eyes", CardEyes::off, {"off", "left", "right", "anaglyph"},
                                   "Eyes for which the card is drawn: off (the camera), one eye, or both as an "
                                   "anaglyph, the left one in red and the right one in cyan.",
                                   essential());
    Real eyeDistance = real("eyeDistance", 0.063, meter, Range{0, 0.5}.soft(0.04, 0.1), "Distance between the eyes.",
                            whenNot(eyes, CardEyes::off));

    Group printing = group("Printing");
    Real distance = real("distance", 1.6, meter, Range{0.05, 1e6, logarithmic}.soft(0.2, 20),
                         "Viewing distance for which the pitch of the strips is made: from this distance, the whole "
                         "card shows one view. For large values, strips have the pitch of the lenses.");
    Choice<CardStrips> strips = choice("strips", CardStrips::flat, {"flat", "squeezed"},
                                       "Content of a strip: the one color that its lens shows (flat), or its slice of "
                                       "the view, squeezed as in the reference.",
                                       quality(CardStrips::flat));
    Toggle reverse =
        toggle("reverse", false, "Whether the views are printed in reverse order: depth turns inside out.");
    Real inkSpread =
        real("inkSpread", 0.000012, micrometer, Range{0, 0.005}.soft(0, 0.0001),
             "Standard deviation of the ink's blur: high mixes neighboring views (crosstalk).", essential());
    Real pitchError = real("pitchError", 0, none, Range{-0.2, 0.2}.soft(-0.01, 0.01),
                           "Error of the pitch of the strips: 0.01 is one percent too wide.");
    Real phase = real("phase", 0, none, {-1, 1}, "Shift of the strips under the lenses, in lens widths.");
    Real rotation = real("rotation", 0.0, degree, Range{degrees(-6), degrees(6)}.soft(degrees(-0.6), degrees(0.6)),
                         "Rotation of the print against the sheet: even a little makes fringes lean across the card.");

    Group gloss = group("Light and gloss");
    Real lamp = real("lamp", 0.35, none, Range{0, 20}.soft(0, 3),
                     "Strength of the lamp in the vault that is aimed at the card: 0 leaves it to the hall's light.");
    Real roughness = real("roughness", 0.03, none, {0, 1}, "Roughness of the plastic: low looks wet, high is matte.");
    Real specular = real("specular", 0.25, none, {0, 1},
                         "Reflectance of the plastic: 0 is none, 0.5 is what its refractive index gives.");
    Real normalScale =
        real("normalScale", 0.6, none, Range{-16, 16}.soft(0, 4),
             "Strength with which the ribs (noise stretched along the lenses) bend the highlight: 0 leaves it smooth.");
    Real ribWidth = real("ribWidth", 0.006, meter, Range{0.0002, 0.2, logarithmic}.soft(0.001, 0.03),
                         "Width of the ribs.", whenNot(normalScale, 0));
    Real ribStretch = real("ribStretch", 60, none, Range{1, 400, logarithmic}.soft(2, 100),
                           "Length of the ribs relative to their width.", whenNot(normalScale, 0));
    Real lensGloss = real("lensGloss", 0.8, none, {0, 1},
                          "Share of the lenses' own slope that the highlight follows: 0 is a flat sheet, 1 spreads it "
                          "in all directions across the lenses.");
    Count glossSamples =
        count("glossSamples", 4, {1, 32, logarithmic},
              "Number of normals across a lens whose reflections are averaged: few show streaks.", quality(32));
};

}  // namespace vitrine::lenticular
