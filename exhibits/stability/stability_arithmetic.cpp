#include "exhibits/stability/stability_cases.h"

#include "render/glsl/cpu.h"
#include "render/glsl/std140.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
namespace vitrine::glsl {
namespace {
#define float double
#include "shaders/lib/hard_cases.glsl"
#undef float
}  // namespace
}  // namespace vitrine::glsl
#pragma GCC diagnostic pop

namespace vitrine::stability {
namespace {

constexpr int inputCount = 6;
constexpr int pointCount = 512;
constexpr int fieldCount = 24;

/// Input of `hardCase(index)` in shaders/lib/hard_cases.glsl.
struct Arithmetic {
    const char* number;
    const char* what;
    double limit;  ///< Absolute; drivers compute arc tangents and powers to about 4e-6.
    std::array<glm::vec4, inputCount> inputs;
};

using V = glm::vec4;
const std::array<Arithmetic, 17> arithmetic{{
    {"H43",
     "Fresnel reflectance with a cosine beyond one",
     1e-6,
     {V(1.0000001F, 0.04F, 0, 0), V(-0.5F, 0.04F, 0, 0), V(0, 0.04F, 0, 0), V(0.25F, 0.5F, 0, 0), V(1, 0, 0, 0),
      V(0.75F, 1, 0, 0)}},
    {"H44",
     "Angle of a cosine beyond one",
     1e-5,
     {V(1.0000001F, 0, 0, 0), V(-1.0000001F, 0, 0, 0), V(0.5F, 0, 0, 0), V(0.99999F, 0, 0, 0), V(-0.25F, 0, 0, 0),
      V(2, 0, 0, 0)}},
    {"H45",
     "Angle of the origin",
     1e-5,
     {V(0), V(1, 0, 0, 0), V(0, -1, 0, 0), V(0.5F, 0.25F, 0, 0), V(-0.5F, -0.25F, 0, 0), V(0, 1, 0, 0)}},
    {"H99",
     "Fraction of a number just below zero",
     1e-6,
     {V(-1e-9F, 0, 0, 0), V(-1e-7F, 0, 0, 0), V(-0.25F, 0, 0, 0), V(3.75F, 0, 0, 0), V(0), V(-1e-30F, 0, 0, 0)}},
    {"H101",
     "Powers of zero and of negative numbers",
     1e-5,
     {V(0), V(0, 2.2F, 0, 0), V(-1, 2, 0, 0), V(0.5F, 2.2F, 0, 0), V(2, 0.5F, 0, 0), V(-0.5F, 0, 0, 0)}},
    {"H103",
     "Step between equal edges",
     1e-6,
     {V(0.5F, 0.5F, 0.49F, 0), V(0.5F, 0.5F, 0.5F, 0), V(0, 1, 0.3F, 0), V(0, 0, 0, 0), V(1, 0, 0.5F, 0),
      V(0, 1e-38F, 0.5F, 0)}},
    {"H32",
     "Direction of a vector without length",
     1e-5,
     {V(0), V(1e-25F, 1e-25F, 0, 0), V(1e-10F, 2e-10F, 0, 0), V(3, 4, 0, 0), V(0, -5, 0, 0), V(1e15F, 1e15F, 0, 0)}},
    {"H92",
     "Reflectance of glass at and beyond total reflection",
     1e-4,
     {V(0.2F, 0.66666667F, 0, 0), V(0, 1.5F, 0, 0), V(0.5F, 1, 0, 0), V(0.9F, 1.5F, 0, 0), V(0, 1, 0, 0),
      V(1, 2.4F, 0, 0)}},
    {"H22",
     "Smooth union of width zero, nothing and everything",
     1e-5,
     {V(1, 1, 0, 0), V(0.5F, -0.5F, 0, 0), V(0.1F, 0.2F, 1e-30F, 0), V(0.25F, 0.25F, 0.5F, 0), V(1, 2, -1, 0),
      V(0.5F, 0.6F, 1, 0)}},
    {"H25",
     "Exponential union far away",
     2e-2,
     {V(1e5F, 1e5F, 0.125F, 0), V(-1e5F, -1e5F, 0.125F, 0), V(-1e5F, 1e5F, 0.125F, 0), V(0.5F, 0.5F, 0.25F, 0),
      V(1, 1, 0, 0), V(0, 100, 0.1F, 0)}},
    {"H18",
     "Ellipsoid at its center and flat",
     1e-4,
     {V(0, 0, 3, 0), V(0, 0, 1, 0), V(1, 0.5F, 3, 0), V(2, 2, 0, 0), V(0.25F, 1, 0.5F, 0), V(-3, 0, 1, 0)}},
    {"H21",
     "Capsule between equal points",
     1e-6,
     {V(0), V(1e-30F, 0, 0, 0), V(1e-12F, 0, 0, 0), V(0.5F, 0, 0, 0), V(2, 0, 0, 0), V(-1, 0, 0, 0)}},
    {"H20",
     "Cone without height and without end",
     1e-5,
     {V(0), V(0, 1, 0, 0), V(1e-30F, 0.5F, 0, 0), V(0.5F, 0.25F, 0, 0), V(1, -3, 0, 0), V(3e14F, 0, 0, 0)}},
    {"H31",
     "Both ends of a mixture, one of them huge",
     1e-6,
     {V(1e9F, 0.125F, 1, 0), V(0.125F, 1e9F, 0, 0), V(0.25F, 0.75F, 0.5F, 0), V(1, 3, 1.25F, 0), V(1, 3, -0.5F, 0),
      V(-1e9F, 0.5F, 1, 0)}},
    {"H89",
     "Hashes of cells, near and far: the same bits on every driver",
     0,
     {V(0, 0, 0, 0), V(-1, 0, 0, 0), V(1000000, 1000001, 0, 0), V(16777216, -16777216, 0, 0), V(12345, 678, 0, 0),
      V(-5, -7, 0, 0)}},
    {"",
     "Square root of what rounding made negative",
     1e-6,
     {V(-1e-7F, 0, 0, 0), V(0), V(0.25F, 0, 0, 0), V(1, 0, 0, 0), V(-1, 0, 0, 0), V(2, 0, 0, 0)}},
    {"H48",
     "Infinity and NaN replaced",
     0,
     {V(1, 0, 0, 0), V(0, 0, 0, 0), V(-1, 0, 0, 0), V(1, 2, 0, 0), V(-3, 4, 0, 0), V(0, 5, 0, 0)}},
}};

/// Returns the output of a fragment shader without geometry, `size` pixels of numbers.
render::Image computed(render::RenderBackend& backend, const char* fragment, std::vector<std::string> defines,
                       render::Bytes block, glm::ivec2 size)
{
    render::FramePlan plan;
    plan.view = render::makeView({}, {.size = size});
    plan.image({.name = "found", .format = render::Format::rgba32f, .size = size});
    render::Pass pass;
    pass.name = "stability";
    pass.reason = "the library's numbers are asked for";
    pass.shader = {.vertex = "lib/fullscreen.vert", .fragment = fragment, .defines = std::move(defines)};
    pass.colors = {render::Attachment::cleared("found")};
    pass.draws = {render::Draw{}};
    pass.draws[0].object = std::move(block);
    plan.add(std::move(pass));
    (void)backend.draw(plan);
    return backend.read("found");
}

/// Returns a number of row `row` of a picture whose row 0 is at the bottom.
float numberAt(const render::Image& image, int x, int row, int channel)
{
    return image.at(x, image.height - 1 - row, channel);
}

/// Returns the difference of `found` from `truth`; infinite if `found` is not finite.
double errorOf(double found, double truth)
{
    return std::isfinite(found) ? std::abs(found - truth) : std::numeric_limits<double>::infinity();
}

std::string text(double x)
{
    if (std::isnan(x)) return "NaN";
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.6g", x);
    return buffer.data();
}

StabilityResult judged(const Arithmetic& a, int row, const render::Image& image)
{
    StabilityResult result{a.number, a.what, false, 0, a.limit, {}};
    int worstInput = 0;
    std::string naive;
    for (int i = 0; i < inputCount; ++i) {
        const glm::vec4& input = a.inputs[static_cast<std::size_t>(i)];
        const double truth = glsl::hardCase(row, glm::dvec4(input));
        double error = errorOf(numberAt(image, i, row, 0), truth);
        // A fraction just below 1 is close to one at 0.
        if (std::string_view(a.number) == "H99" && numberAt(image, i, row, 0) < 1)
            error = std::min(error, std::abs(1 - error));
        // The limit is relative for numbers above 1.
        error /= std::max(1.0, std::abs(truth));
        if (!(error <= result.value)) {
            result.value = error;
            worstInput = i;
        }
        const double plain = numberAt(image, i, row, 1);
        if (naive.empty() && !(errorOf(plain, truth) <= std::max(a.limit, 1e-5) * std::max(1.0, std::abs(truth))))
            naive = text(plain) + " in place of " + text(truth);
    }
    result.passed = result.value <= result.limit;
    if (!result.passed) {
        const glm::vec4& input = a.inputs[static_cast<std::size_t>(worstInput)];
        result.detail = "of (" + text(input.x) + ", " + text(input.y) + ", " + text(input.z) +
                        "): " + text(numberAt(image, worstInput, row, 0)) + " in place of " +
                        text(glsl::hardCase(row, glm::dvec4(input)));
    } else if (!naive.empty()) {
        result.detail = "plain code gives " + naive + " here";
    }
    return result;
}

StabilityResult fieldsAgainstFloat64(render::RenderBackend& backend)
{
    const render::Image image = computed(backend, "lib/hard_fields.frag", {}, {}, {pointCount, fieldCount});
    StabilityResult result{"H16", "Solids and operators all over space, against float64", false, 0, 4e-6, {}};
    int worst = 0;
    for (int field = 0; field < fieldCount; ++field) {
        for (int i = 0; i < pointCount; ++i) {
            const double error =
                errorOf(numberAt(image, i, field, 0), glsl::libraryField(field, glsl::libraryPoint(i)));
            if (!(error <= result.value)) {
                result.value = error;
                worst = field;
            }
        }
    }
    result.passed = result.value <= result.limit;
    result.detail = result.passed ? std::to_string(fieldCount) + " fields at " + std::to_string(pointCount) + " points"
                                  : "field " + std::to_string(worst) + " of hard_cases.glsl";
    return result;
}

}  // namespace

std::vector<StabilityResult> arithmeticCases(render::RenderBackend& backend)
{
    std::array<glm::vec4, arithmetic.size() * inputCount> inputs{};
    for (std::size_t row = 0; row < arithmetic.size(); ++row)
        std::copy(arithmetic[row].inputs.begin(), arithmetic[row].inputs.end(),
                  inputs.begin() + static_cast<std::ptrdiff_t>(row) * inputCount);
    const int rows = static_cast<int>(arithmetic.size());
    render::Std140Writer inputBlock;
    inputBlock.put(inputs);
    const render::Image image = computed(backend, "lib/hard_cases.frag",
                                         {"INPUTS " + std::to_string(inputCount), "CASES " + std::to_string(rows)},
                                         inputBlock.take(), {inputCount, rows});
    std::vector<StabilityResult> results;
    for (int row = 0; row < rows; ++row)
        results.push_back(judged(arithmetic[static_cast<std::size_t>(row)], row, image));
    results.push_back(fieldsAgainstFloat64(backend));
    return results;
}

}  // namespace vitrine::stability
