#include "exhibits/museum/named_files.h"

#include "exhibits/framework/files/file_path.h"
#include "render/files/asset_store.h"
#include "render/hash.h"

namespace vitrine {
bool namesFiles(const SceneState& sceneState)
{
    for (const ParameterValues& values : sceneState.values)
        for (std::size_t row = 0; row < values.rows().size(); ++row)
            if (values.rows()[row].kind == Kind::file && !values.isInitial(row) &&
                !std::get<std::string>(values.row(row)).empty())
                return true;
    return false;
}

std::uint64_t stateOfFiles(Subjects subjects, const SceneState& sceneState)
{
    render::Hash hash;
    const auto add = [&](const std::string& path) {
        hash.add(path);
        render::addTo(hash, render::fileState(path));
        render::addTo(hash, render::folderState(path));
    };
    for (std::size_t i = 0; i < subjects.size() && i < sceneState.values.size(); ++i)
        if (const auto* made = capability<TableFromFiles>(*subjects[i]))
            for (const std::string& path : made->furtherFiles(sceneState.values[i])) add(path);
    for (const ParameterValues& values : sceneState.values)
        for (std::size_t row = 0; row < values.rows().size(); ++row) {
            if (values.rows()[row].kind != Kind::file) continue;
            if (const std::string path = filePath(values.rows()[row], std::get<std::string>(values.row(row)));
                !path.empty())
                add(path);
        }
    return hash.value();
}

}  // namespace vitrine
