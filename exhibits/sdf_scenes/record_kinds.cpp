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
          "Phong shading with a mirror, as in the reference of these scenes.",
          {color("color", {0.8, 0.8, 0.8}, "Color, as linear values."),
           share("ambient", 0.2, "Share of the color that is lit from everywhere."),
           share("diffuse", 0.9, "Share of the color that is lit by the lights."),
           share("specular", 0.3, "Strength of the white highlight."),
           number("shininess", 20, 1, 1e4, "Exponent of the highlight: high makes it narrow."),
           share("mirror", 0, "Share of the light that is mirrored.")}},
         {"pbr",
          "Physically based material: metal, glaze, stone or glass.",
          {color("color", {0.8, 0.8, 0.8}, "Color, as linear values."),
           share("metalness", 0, "Share of metal: 0 is none, 1 is bare metal."),
           share("roughness", 0.4, "Roughness of the surface: 0 is a mirror, 1 is chalk."),
           share("reflectance", 0.5, "Reflectance of nonmetals: 0.5 is 4 %."),
           number("refractiveIndex", 1.5, 1, 3, "Refractive index of the glass."),
           share("transmission", 0, "Transmission: 0 is opaque, 1 is clear glass with the color of 10 cm of it."),
           number("emission", 0, 0, 1e4, "Emitted light, as a multiple of the color.")}}}};
    return table;
}

const RecordTable& lightTable()
{
    static const RecordTable table{
        "kind",
        {{"point",
          "A point light that shines in all directions.",
          {place("position", {0, 4, 0}, "Position of the light."),
           radiance("color", {1, 1, 1},
                    "Light reflected by white at the camera's target, as linear values; with Phong shading, at any "
                    "distance.")}},
         {"sun",
          "Light from one direction.",
          {towards("direction", {0.4, 1, 0.3}, "Direction to the sun."),
           radiance("color", {1, 1, 1}, "Light reflected by white that faces the sun, as linear values."),
           turn("width", 0.5, 0.01, 60, "Angular diameter of the sun.")}},
         {"area",
          "A rectangular light that shines to one side.",
          {place("position", {0, 4, 0}, "Position of the center of the light."),
           towards("direction", {0, -1, 0}, "Direction in which the light shines."),
           length("width", 1, "Length of the first edge."), length("height", 1, "Length of the second edge."),
           radiance("color", {1, 1, 1}, "Radiance of the light, as linear values.")}}}};
    return table;
}

const RecordTable& environmentTable()
{
    static const RecordTable table{"kind",
                                   {{"sky",
                                     "Gradient of three colors from the ground up.",
                                     {radiance("zenith", {0.25, 0.45, 0.8}, "Color above, as linear values."),
                                      radiance("horizon", {0.8, 0.85, 0.9}, "Color at the horizon, as linear values."),
                                      radiance("ground", {0.25, 0.22, 0.2}, "Color below, as linear values.")}},
                                    {"panorama",
                                     "Panorama picture, twice as wide as high.",
                                     {turn("rotation", 0, -360, 360, "Rotation about the y axis."),
                                      number("brightness", 1, 0, 1000, "Factor of the brightness.")},
                                     {"file"}},
                                    {"faces",
                                     "Cube map of six square pictures.",
                                     {turn("rotation", 0, -360, 360, "Rotation about the y axis."),
                                      number("brightness", 1, 0, 1000, "Factor of the brightness.")},
                                     {"right", "left", "top", "bottom", "front", "back"}}}};
    return table;
}

const RecordTable& cameraTable()
{
    static const RecordTable table{
        "",
        {{"camera",
          "Camera from which the scene is seen.",
          {place("position", {0, 1.5, 5}, "Position of the eye."),
           place("target", {0, 0, 0}, "Point in the middle of the picture."),
           towards("up", {0, 1, 0}, "Direction that points up in the picture."),
           turn("fieldOfView", 45, 1, 150,
                "Vertical field of view, from the lower to the upper edge of the picture.")}}}};
    return table;
}

const RecordTable& lookTable()
{
    static const RecordTable table{
        "",
        {{"look",
          "Shading of the scene.",
          {{"asInTheReference",
            FieldType::toggle,
            Unit::none,
            0,
            1,
            0,
            1,
            {0, 0, 0},
            "Whether to shade by Phong's formulas without tone mapping, as in the reference."},
           {"bounces",
            FieldType::count,
            Unit::none,
            0,
            4,
            0,
            4,
            {2, 0, 0},
            "Largest number of reflections along a ray."},
           number("softShadows", 0, 0, 1000,
                  "Factor k of the reference's soft shadows: low is soft, high is sharp, 0 is hard."),
           share("ambientOcclusion", 1, "Strength of the ambient occlusion: 0 is off."),
           radiance("ambient", {1, 1, 1}, "Ambient light, as linear values; only with Phong shading."),
           number("exposure", 1, 0, 1e4, "Exposure, as a factor of all light; not with Phong shading.")}}}};
    return table;
}

const std::vector<Field>& placeFields()
{
    constexpr double turns = 3600 * radiansInDegree;
    static const std::vector<Field> fields{
        {"translate",
         FieldType::vector,
         Unit::meter,
         -farthest,
         farthest,
         -4,
         4,
         {0, 0, 0},
         "Translation of the shape."},
        {"rotate",
         FieldType::vector,
         Unit::degree,
         -1e6 * radiansInDegree,
         1e6 * radiansInDegree,
         -turns / 10,
         turns / 10,
         {0, 0, 0},
         "Rotation of the shape about z, then y, then x."},
        {"scale",
         FieldType::sizes,
         Unit::none,
         1e-3,
         1e3,
         0.1,
         4,
         {1, 1, 1},
         "Scale of the shape, one factor or one per axis; applied before rotation and translation."}};
    return fields;
}

}  // namespace vitrine::scenes
