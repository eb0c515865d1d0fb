#include "exhibits/shader_export/scene_shader.h"

#include "exhibits/framework/files/table_change.h"
#include "exhibits/shader_export/stand_alone.h"
#include "exhibits/your_shader/guest_work.h"
#include "exhibits/your_shader/your_shader.h"
#include "render/failure.h"
#include "render/files/assets.h"

namespace vitrine::guest {
namespace {

/// Returns the visitor's shader with the values of its inputs. The first shader is translated here, because its table
/// is made without.
ExportedShader visitorsShader(const ParameterValues& values)
{
    const auto& table = static_cast<const YourShaderTable&>(values.table());
    if (table.work) return exportedShader(*table.work, table, values);
    render::AssetStore assets;
    const auto reading = readWork(render::asset("shaders") / YourShaderTable::firstShader, assets);
    if (!reading->table) throw Failure(ErrorKind::check, reading->why);
    std::vector<std::string> notes;
    const ParameterValues known = underTable(values, reading->table, notes);
    return exportedShader(*reading->table->work, *reading->table, known);
}

}  // namespace

ExportedShader sceneShader(const Museum& museum, const SceneState& sceneState, std::size_t subject,
                           const FrameRequest& request)
{
    TabledSceneState tabled = museum.readTables(sceneState);
    for (const Message& why : tabled.unreadable) throw Failure(ErrorKind::file, why);
    const SceneState state = museum.atMoment(tabled.sceneState, request);
    if (dynamic_cast<const YourShader*>(&museum.subject(subject))) return visitorsShader(state.values[subject]);
    return standAloneShader(museum, state, subject);
}

}  // namespace vitrine::guest
