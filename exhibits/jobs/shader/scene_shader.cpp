#include "exhibits/jobs/shader/scene_shader.h"

#include "exhibits/framework/files/table_change.h"
#include "exhibits/your_shader/export/stand_alone.h"
#include "exhibits/your_shader/guest_work.h"
#include "exhibits/your_shader/your_shader.h"
#include "render/failure.h"
#include "render/files/assets.h"

namespace vitrine::jobs {
namespace {

/// Returns the visitor's shader with the values of its inputs. The first shader is translated here, because its table
/// is made without.
guest::ExportedShader visitorsShader(const ParameterValues& values)
{
    const auto& table = static_cast<const YourShaderTable&>(values.table());
    if (table.work) return exportedShader(*table.work, table, values);
    render::AssetStore assets;
    const auto reading = guest::readWork(render::asset("shaders") / YourShaderTable::firstShader, assets);
    if (!reading->table) throw Failure(ErrorKind::check, reading->why);
    std::vector<std::string> notes;
    const ParameterValues known = underTable(values, reading->table, notes);
    return exportedShader(*reading->table->work, *reading->table, known);
}

}  // namespace

guest::ExportedShader sceneShader(const JobScene& scene)
{
    const Museum& museum = *scene.museum;
    TabledSceneState tabled = museum.readTables(scene.state);
    for (const Message& why : tabled.unreadable) throw Failure(ErrorKind::file, why);
    const SceneState state = museum.atMoment(tabled.sceneState, scene.frame);
    if (dynamic_cast<const YourShader*>(&museum.subject(scene.subject)))
        return visitorsShader(state.values[scene.subject]);
    return guest::standAloneShader(museum, state, scene.subject);
}

}  // namespace vitrine::jobs
