#include "exhibits/museum/read_tables.h"

#include "exhibits/framework/files/table_change.h"

namespace vitrine {

TabledSceneState readTables(Subjects subjects, render::AssetStore& assets, const SceneState& sceneState)
{
    TabledSceneState read{sceneState, {}, {}};
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        ParameterValues& values = read.sceneState.values[i];
        const auto* made = capability<TableFromFiles>(*subjects[i]);
        if (!made || values.tableFiles().empty()) continue;
        const DynamicParameters called = made->dynamicParameters(values, assets);
        if (!called.why.empty()) read.unreadable.push_back(called.why);
        if (!called.table || called.table == values.sharedTable()) continue;
        values = underTable(values, called.table, read.notes);
        for (const auto& [name, json] : values.pending())
            read.notes.push_back(std::string(subjects[i]->name()) + '.' + name + " is not known here; it is kept");
    }
    return read;
}

}  // namespace vitrine
