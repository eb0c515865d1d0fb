#include "exhibits/museum/named_files.h"

#include "exhibits/framework/files/file_path.h"
#include "render/files/asset_store.h"
#include "render/hash.h"

#include <utility>

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

std::vector<std::string> watchedFiles(Subjects subjects, const SceneState& sceneState)
{
    std::vector<std::string> paths;
    for (std::size_t i = 0; i < subjects.size() && i < sceneState.values.size(); ++i)
        if (const auto* made = capability<TableFromFiles>(*subjects[i]))
            for (const std::string& path : made->furtherFiles(sceneState.values[i])) paths.push_back(path);
    for (const ParameterValues& values : sceneState.values)
        for (std::size_t row = 0; row < values.rows().size(); ++row) {
            if (values.rows()[row].kind != Kind::file) continue;
            if (std::string path = filePath(values.rows()[row], std::get<std::string>(values.row(row))); !path.empty())
                paths.push_back(std::move(path));
        }
    return paths;
}

std::uint64_t stateOfFiles(Subjects subjects, const SceneState& sceneState, bool withNeighbors)
{
    render::Hash hash;
    for (const std::string& path : watchedFiles(subjects, sceneState)) {
        hash.add(path);
        render::addTo(hash, render::fileState(path));
        if (withNeighbors) render::addTo(hash, render::folderState(path));
    }
    return hash.value();
}

}  // namespace vitrine
