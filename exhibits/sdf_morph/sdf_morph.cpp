#include "exhibits/sdf_morph/sdf_morph.h"

#include "exhibits/framework/table/derive.h"
#include "exhibits/sdf_morph/torus_mug_cpu.h"
#include "render/glsl/std140.h"

#include <cmath>
#include <limits>

namespace vitrine::sdf_morph {
namespace {

#include "shaders/sdf_morph/torus_mug_shape_block.glsl"

glsl::TorusMug torusMug(const SdfMorphTable& table, const ParameterValues& values)
{
    glsl::TorusMug mug;
#define TAKE_PARAMETER(type, name) mug.name = values[table.name];
    TORUS_MUG_FIELDS(TAKE_PARAMETER, )
#undef TAKE_PARAMETER
    return mug;
}

/// Returns the shape as the shaders read it.
TorusMugShape blockOf(const glsl::TorusMugShape& shape)
{
    TorusMugShape block;
#define COPY_FIELD(type, name) block.name = static_cast<decltype(block.name)>(shape.name);
    TORUS_MUG_SHAPE_FIELDS(COPY_FIELD, )
#undef COPY_FIELD
    return block;
}

render::Box boxOf(const glsl::TorusMugBox& box)
{
    return {box.center - box.halfSize, box.center + box.halfSize};
}

}  // namespace

double morphAt(double morph, double speed, double time)
{
    if (time == 0 || !std::isfinite(time)) return morph;
    // The phase is on a triangle wave of period 2 that starts at `morph`; the remainder is exact at any time.
    const double phase = std::fmod(morph + std::fmod(2 * speed * time, 2.0), 2.0);
    const double positive = phase < 0 ? phase + 2 : phase;
    return positive <= 1 ? positive : 2 - positive;
}

SdfBody SdfMorph::body(const ParameterValues& values, double time) const
{
    const Table& t = table_;
    ParameterValues now = values;
    if (values[t.animate]) now.set(t.morph, morphAt(values[t.morph], values[t.speed], time));
    const glsl::TorusMugShape shape = glsl::torusMugShape(torusMug(t, now));
    std::string key = derive::keyOf(now, t.shape);
    return {.values = std::move(now),
            .box = boxOf(glsl::torusMugBox(shape)),
            .distance = [shape](const glm::dvec3& p) { return glsl::sdfTorusMug(p, shape); },
            .shape = std::move(key),
            .block = render::std140Bytes(blockOf(shape))};
}

render::Box SdfMorph::boxOverTime(const ParameterValues& values) const
{
    const glsl::TorusMug mug = torusMug(table_, values);
    return boxOf(values[table_.animate] ? glsl::torusMugBoxOverMorph(mug)
                                        : glsl::torusMugBox(glsl::torusMugShape(mug)));
}

std::vector<StandingShape> SdfMorph::standingShapes(const ParameterValues& values) const
{
    return {standingCylinder(boxOverTime(values), values[table_.baseColor].value)};
}

render::Camera SdfMorph::bestView(const ParameterValues& values) const
{
    const double reach = glm::length(boxOf(glsl::torusMugBoxOverMorph(torusMug(table_, values))).halfSize());
    return {glm::dvec3(0.70, 0.19, 1.22) * (reach / 0.75), {0.04, -0.02, 0}, 0.698132};
}

double SdfMorph::nextChange(const ParameterValues& values, double) const
{
    return values[table_.animate] && values[table_.speed] > 0 ? 0 : std::numeric_limits<double>::infinity();
}

bool SdfMorph::press(ParameterValues& values) const
{
    values.set(table_.animate, !values[table_.animate]);
    return true;
}

std::vector<StudyView> SdfMorph::studyViews(const ParameterValues& values) const
{
    ParameterValues still = values;
    still.set(table_.animate, false);
    ParameterValues mug = still;
    mug.set(table_.morph, 1.0);
    ParameterValues torus = still;
    torus.set(table_.morph, 0.0);
    const render::Camera best = bestView(values);
    const double size = glm::length(best.eye);
    const auto from = [&](glm::dvec3 direction, double distance) {
        return render::Camera{best.target + glm::normalize(direction) * (size * distance), best.target, best.fovY};
    };
    // Rays that graze the lip and the inside of the wall take the most steps. A torus seen edge-on hides its hole.
    return {{"best view", best, 0, still},
            {"into the mug, along its wall", from({0.25, 0.62, 0.45}, 0.75), 0, mug},
            {"the torus, nearly edge-on", from({1.0, 0.06, 0.10}, 0.8), 0, torus},
            {"the handle, from near", from({0.9, 0.1, 0.35}, 0.5), 0, mug},
            {"melting, from behind", from({-0.6, 0.3, -1.0}, 0.9), 0, still}};
}

}  // namespace vitrine::sdf_morph
