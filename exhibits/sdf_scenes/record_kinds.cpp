#include "exhibits/sdf_scenes/record_kinds.h"

#include <numbers>

namespace vitrine::scenes {
namespace {

constexpr double radiansInDegree = std::numbers::pi / 180;
constexpr double farthest = 1e4;

Field share(std::string_view name, double initial, std::string_view help)
{
    return {name, FieldType::real, Unit::none, 0, 1, 0, 1, {initial, 0, 0}, help};
}
Field number(std::string_view name, double initial, double low, double high, std::string_view help)
{
    return {name, FieldType::real, Unit::none, low, high, low, high, {initial, 0, 0}, help};
}
Field place(std::string_view name, const std::array<double, 3>& initial, std::string_view help)
{
    return {name, FieldType::vector, Unit::meter, -farthest, farthest, -10, 10, initial, help};
}
Field towards(std::string_view name, const std::array<double, 3>& initial, std::string_view help)
{
    return {name, FieldType::direction, Unit::none, -1e6, 1e6, -1, 1, initial, help};
}
Field color(std::string_view name, const std::array<double, 3>& initial, std::string_view help)
{
    return {name, FieldType::vector, Unit::none, 0, 1, 0, 1, initial, help};
}
Field radiance(std::string_view name, const std::array<double, 3>& initial, std::string_view help)
{
    return {name, FieldType::vector, Unit::none, 0, 1e6, 0, 10, initial, help};
}
Field turn(std::string_view name, double initial, double low, double high, std::string_view help)
{
    return {name,
            FieldType::real,
            Unit::degree,
            low * radiansInDegree,
            high * radiansInDegree,
            low * radiansInDegree,
            high * radiansInDegree,
            {initial * radiansInDegree, 0, 0},
            help};
}
Field length(std::string_view name, double initial, std::string_view help)
{
    return {name, FieldType::real, Unit::meter, 1e-4, farthest, 0.01, 4, {initial, 0, 0}, help};
}

}  // namespace

const RecordTable& materialTable()
{
    static const RecordTable table{
        "model",
        {{"phong",
          "Phong's highlight and a mirror, as the source of these scenes has them.",
          {color("color", {0.8, 0.8, 0.8}, "In linear light."), share("ambient", 0.2, "Of the color, from everywhere."),
           share("diffuse", 0.9, "Of the color, from lights."), share("specular", 0.3, "Of the highlight, white."),
           number("shininess", 20, 1, 1e4, "How narrow the highlight is."), share("mirror", 0, "What is reflected.")}},
         {"pbr",
          "Metal, glaze or stone.",
          {color("color", {0.8, 0.8, 0.8}, "In linear light."),
           share("metalness", 0, "0 is no metal, 1 is bare metal."),
           share("roughness", 0.4, "0 is a mirror, 1 is chalk."),
           share("reflectance", 0.5, "Of what is no metal: 0.5 is 4 %."),
           number("refractiveIndex", 1.5, 1, 3, "Of glass."),
           share("transmission", 0, "0 is opaque, 1 is clear glass, which has its color per 10 cm of depth."),
           number("emission", 0, 0, 1e4, "Light of its own: so many times its color.")}}}};
    return table;
}

const RecordTable& lightTable()
{
    static const RecordTable table{
        "kind",
        {{"point",
          "A point that shines everywhere.",
          {place("position", {0, 4, 0}, "Where it is."),
           radiance("color", {1, 1, 1},
                    "What white reflects where the camera looks, linear; as in the source, at any distance.")}},
         {"sun",
          "Light from one direction.",
          {towards("direction", {0.4, 1, 0.3}, "Towards it."),
           radiance("color", {1, 1, 1}, "What white reflects that faces it, linear."),
           turn("width", 0.5, 0.01, 60, "How wide it looks.")}},
         {"area",
          "A rectangle that shines to one side.",
          {place("position", {0, 4, 0}, "Its center."), towards("direction", {0, -1, 0}, "Where it shines."),
           length("width", 1, "One edge."), length("height", 1, "The other edge."),
           radiance("color", {1, 1, 1}, "How bright it looks, linear.")}}}};
    return table;
}

const RecordTable& environmentTable()
{
    static const RecordTable table{
        "kind",
        {{"sky",
          "Three colors from the ground up.",
          {radiance("zenith", {0.25, 0.45, 0.8}, "Above, linear."),
           radiance("horizon", {0.8, 0.85, 0.9}, "Around, linear."),
           radiance("ground", {0.25, 0.22, 0.2}, "Below, linear.")}},
         {"panorama",
          "A picture of all directions, twice as wide as high.",
          {turn("rotation", 0, -360, 360, "About the y axis."), number("brightness", 1, 0, 1000, "Factor.")},
          {"file"}},
         {"faces",
          "Six square pictures.",
          {turn("rotation", 0, -360, 360, "About the y axis."), number("brightness", 1, 0, 1000, "Factor.")},
          {"right", "left", "top", "bottom", "front", "back"}}}};
    return table;
}

const RecordTable& cameraTable()
{
    static const RecordTable table{"",
                                   {{"camera",
                                     "From where the scene is seen.",
                                     {place("position", {0, 1.5, 5}, "Of the eye."),
                                      place("target", {0, 0, 0}, "What is in the middle of the picture."),
                                      towards("up", {0, 1, 0}, "What is up in the picture."),
                                      turn("fieldOfView", 45, 1, 150, "From the lower to the upper edge.")}}}};
    return table;
}

const RecordTable& lookTable()
{
    static const RecordTable table{
        "",
        {{"look",
          "How the scene is lit.",
          {{"asInTheSource",
            FieldType::toggle,
            Unit::none,
            0,
            1,
            0,
            1,
            {0, 0, 0},
            "Phong, its formulas, and no tone curve."},
           {"bounces", FieldType::count, Unit::none, 0, 4, 0, 4, {2, 0, 0}, "How often a ray is reflected."},
           number("softShadows", 0, 0, 1000, "The source's factor of its soft shadows; 0 is a hard edge."),
           share("ambientOcclusion", 1, "How much of it."),
           radiance("ambient", {1, 1, 1}, "Light from everywhere, linear; only as in the source."),
           number("exposure", 1, 0, 1e4, "Of the picture: a factor of all light; not as in the source.")}}}};
    return table;
}

const std::vector<Field>& placeFields()
{
    constexpr double turns = 3600 * radiansInDegree;
    static const std::vector<Field> fields{
        {"translate", FieldType::vector, Unit::meter, -farthest, farthest, -4, 4, {0, 0, 0}, "Moves it."},
        {"rotate",
         FieldType::vector,
         Unit::degree,
         -1e6 * radiansInDegree,
         1e6 * radiansInDegree,
         -turns / 10,
         turns / 10,
         {0, 0, 0},
         "About z, then y, then x."},
        {"scale",
         FieldType::sizes,
         Unit::none,
         1e-3,
         1e3,
         0.1,
         4,
         {1, 1, 1},
         "One factor, or one along each axis; first of all."}};
    return fields;
}

}  // namespace vitrine::scenes
