#include "exhibits/sdf_scenes/sdf_scenes_table.h"

#include "exhibits/sdf_scenes/shown_scene.h"

#include <cctype>

namespace vitrine::scenes {
namespace {

/// Returns an unused name for a parameter of a scene.
std::string freeName(const SdfScenesTable& table, const std::string& name)
{
    if (!table.find(name)) return name;
    std::string free = "own" + name;
    free[3] = static_cast<char>(std::toupper(static_cast<unsigned char>(free[3])));
    while (table.find(free)) free += "2";
    return free;
}

}  // namespace

SdfScenesTable::SdfScenesTable(std::shared_ptr<const ShownScene> of) : shown(std::move(of))
{
    if (!shown || shown->scene->parameters().empty()) return;
    group(shown->scene->name.empty() ? "Scene parameters" : shown->scene->name);
    for (const SceneParameter& p : shown->scene->parameters()) {
        const std::string help = p.help.empty() ? "Parameter of this scene." : p.help;
        ofScene.push_back(real(freeName(*this, p.name), p.initial, p.unit, Range{p.low, p.high}, help, essential()));
    }
}

ParameterValues rightHalf(const SdfScenesTable& t, ParameterValues values)
{
    values.set(t.shadowMethod, values[t.rightShadowMethod]);
    values.set(t.occlusionMethod, values[t.rightOcclusionMethod]);
    values.set(t.bounces, values[t.rightBounces]);
    values.set(t.evaluation, values[t.rightEvaluation]);
    values.set(t.stepLimit, values[t.rightStepLimit]);
    values.set(t.hitTolerance, values[t.rightHitTolerance]);
    return values;
}

}  // namespace vitrine::scenes
