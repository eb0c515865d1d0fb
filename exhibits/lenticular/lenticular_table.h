#pragma once

#include "exhibits/framework/parameters.h"

namespace vitrine {

enum class CardFace : int { front, back };
enum class CardSheet : int { twenty3d = 4, custom = 23 };
enum class CardAxis : int { vertical, horizontal };
enum class CardStrips : int { flat, squeezed };
enum class CardModel : int { linear, paraxial, exact };
enum class CardEyes : int { off, left, right, anaglyph };

/// All parameters of the lenticular card. Lengths are in meters.
struct LenticularTable final : Parameters {
    Group prints = group("Prints");
    File frontPrint = file(
        "frontPrint",
        "Views of the first print: a folder of pictures, or a print that vitrine print wrote. Empty: the turning mug.",
        endings("tif tiff png jpg jpeg exr hdr webp bmp gif"));
    File backPrint = file("backPrint", "Views of the second print, in the same ways. Empty: the melting torus.",
                          endings("tif tiff png jpg jpeg exr hdr webp bmp gif"));
    Choice<CardFace> face =
        choice("face", CardFace::front, {"front", "back"}, "Which print rests in the card before it scrolls.");
    Count views =
        count("views", 16, Range{1, 256}.soft(1, 32),
              "Strips under each lens: views chosen evenly from those that the print has, no more than it has.");
    Toggle scroll = toggle("scroll", true, "Roll from one print to the other and on, like a billboard.");
    Real period = real("period", 12, second, Range{0.1, 3600}.soft(2, 30), "From one print to the next.", when(scroll));
    Real hold = real("hold", 0.85, none, {0, 1},
                     "Share of that time in which the print rests; the rest of it is the roll.", when(scroll));
    Real margin = real("margin", 0.012, meter, Range{0, 0.15}.soft(0, 0.05), "White paper around the pictures.");

    Group sheet = group("Sheet");
    Choice<CardSheet> sheetKind =
        choice("sheetKind", CardSheet::twenty3d,
               {"10-3d", "10-flip", "15-3d",  "15-flip",  "20-3d",  "20-flip",  "30-3d",       "30-flip",
                "40-3d", "40-flip", "50-3d",  "50-flip",  "60-3d",  "60-flip",  "62-3d",       "62-flip",
                "75-3d", "75-flip", "100-3d", "100-flip", "161-3d", "161-flip", "75-measured", "custom"},
               "Lenses per inch and the zone they are made for: 30 degrees (3d) or 50 (flip). Custom takes the numbers "
               "below.");
    Count slices =
        count("slices", 0, Range{0, 8000}.soft(0, 1000),
              "Lenses across the card; the sheet's shape is scaled. 0 takes as many as the sheet's LPI gives.",
              reads(0, "auto"));
    Choice<CardAxis> axis = choice("axis", CardAxis::vertical, {"vertical", "horizontal"},
                                   "Of the lenses: vertical ones change as one walks by, horizontal ones as one bows.");
    Real customLpi = real("customLpi", 40, none, Range{1, 400}.soft(5, 160), "Lenses per inch of the custom sheet.",
                          when(sheetKind, CardSheet::custom));
    Real radius = real("radius", 0.000381, millimeter, Range{1e-5, 0.1}.soft(0.0001, 0.003),
                       "Of the custom lens at its top; one that cannot reach over its pitch is made just large enough.",
                       when(sheetKind, CardSheet::custom));
    Real thickness = real("thickness", 0.001062, millimeter, Range{1e-5, 0.3}.soft(0.0002, 0.008),
                          "Of the custom sheet, from lens top to print: too thin or too thick blurs.",
                          when(sheetKind, CardSheet::custom));
    Real refractiveIndex =
        real("refractiveIndex", 1.56, none, Range{1.01, 3}.soft(1.3, 1.8),
             "Of the custom sheet's plastic: 1.49 to 1.6 are usual.", when(sheetKind, CardSheet::custom));
    Real conic = real("conic", 0, none, Range{-5, 2}.soft(-1, 0.5),
                      "Of the custom lens: 0 is a circle, -0.41 the ellipse that is sharp straight ahead.",
                      when(sheetKind, CardSheet::custom));

    Group lens = group("Simulation");
    Choice<CardModel> model = choice("model", CardModel::exact, {"linear", "paraxial", "exact"},
                                     "From an eye's angle to the strip: in proportion to its tangent as in the source, "
                                     "first-order optics, or Snell's law on the lens.",
                                     exactAt(CardModel::exact));
    Real magnification = real("magnification", 1, none, {0, 2},
                              "Size of the spot that a lens shows against what the model gives: 0 is one point of a "
                              "strip, above 1 the neighbors bleed in.");
    Real intendedMaxAngle =
        real("intendedMaxAngle", degrees(45), degree, Range{degrees(1), degrees(85)}.soft(degrees(5), degrees(60)),
             "Of the linear model: the angle to either side at which all views have been seen.",
             when(model, CardModel::linear));
    Count apertureSamples = count("apertureSamples", 8, {1, 64, logarithmic},
                                  "Parts of a lens, or of the piece of it under a pixel, that are traced.", quality(64),
                                  whenLater("prefilter", 1));
    Toggle prefilter =
        toggle("prefilter", true,
               "Integrate over the lens and the pixel; without it one ray a pixel gives moire from afar.", quality(1));
    Toggle dispersion = toggle("dispersion", false, "Trace red, green and blue apart, by Cauchy's formula.");
    Real abbeNumber =
        real("abbeNumber", 30, none, Range{5, 100}.soft(15, 80),
             "How little the plastic spreads colors: acrylic has 57, polycarbonate 30.", when(dispersion));
    Choice<CardEyes> eyes =
        choice("eyes", CardEyes::off, {"off", "left", "right", "anaglyph"},
               "Whose view is drawn: the camera's, one eye's, or both, the left one in red and the right one in cyan.");
    Real eyeDistance = real("eyeDistance", 0.063, meter, Range{0, 0.5}.soft(0.04, 0.1), "Between the eyes.",
                            whenNot(eyes, CardEyes::off));

    Group printing = group("Printing");
    Real distance =
        real("distance", 1.6, meter, Range{0.05, 1e6, logarithmic}.soft(0.2, 20),
             "Of the eye for which the strips' pitch is made: there the whole card shows one view. Large is parallel.");
    Choice<CardStrips> strips =
        choice("strips", CardStrips::flat, {"flat", "squeezed"},
               "A strip holds the one color that its lens shows, or its slice of the view squeezed, as in the source.",
               quality(CardStrips::flat));
    Toggle reverse = toggle("reverse", false, "The views in the wrong order: the picture turns inside out.");
    Real inkSpread = real("inkSpread", 0.000012, micrometer, Range{0, 0.005}.soft(0, 0.0001),
                          "Standard deviation of the ink's blur: cross-talk between views.");
    Real pitchError = real("pitchError", 0, none, Range{-0.2, 0.2}.soft(-0.01, 0.01),
                           "Of the strips' pitch against what it should be: 0.01 is one percent too wide.");
    Real phase = real("phase", 0, none, {-1, 1}, "Of the strips under the lenses, in lenses.");
    Real rotation = real("rotation", 0.0, degree, Range{degrees(-6), degrees(6)}.soft(degrees(-0.6), degrees(0.6)),
                         "Of the print against the sheet: fringes lean across the card.");

    Group gloss = group("Light and gloss");
    Real lamp = real("lamp", 0.35, none, Range{0, 20}.soft(0, 3),
                     "Of the lamp in the vault that is aimed at the card: 0 leaves it to the hall's light.");
    Real roughness = real("roughness", 0.14, none, {0, 1}, "Of the plastic: low is wet, high is matte.");
    Real specular =
        real("specular", 0.5, none, {0, 1}, "Reflectance of the plastic: 0.5 is what its index gives, 0 none.");
    Real normalScale = real("normalScale", 1, none, Range{-16, 16}.soft(0, 4),
                            "How much the ribs, noise stretched along the lenses, bend the highlight.");
    Real ribWidth = real("ribWidth", 0.006, meter, Range{0.0002, 0.2, logarithmic}.soft(0.001, 0.03), "Of the ribs.",
                         whenNot(normalScale, 0));
    Real ribStretch = real("ribStretch", 24, none, Range{1, 400, logarithmic}.soft(2, 100),
                           "How much longer ribs are than wide.", whenNot(normalScale, 0));
    Real lensGloss = real("lensGloss", 0.35, none, {0, 1},
                          "How much of the lenses' own slope the highlight follows: 0 is a flat sheet, 1 spreads it "
                          "over all directions across.");
    Count glossSamples =
        count("glossSamples", 4, {1, 32, logarithmic}, "Normals of a lens whose mirror images are mixed.", quality(32));
};

}  // namespace vitrine
