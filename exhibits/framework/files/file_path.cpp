#include "exhibits/framework/files/file_path.h"

#include "render/failure.h"
#include "render/files/assets.h"

#include <filesystem>

namespace vitrine {

std::string filePath(const ParameterInfo& parameter, const std::string& value)
{
    const std::filesystem::path path(value);
    std::error_code error;
    if (parameter.assetFolder.empty() || value.empty() || path.is_absolute()) return value;
    if (path.has_parent_path() && (*path.begin() == ".." || std::filesystem::exists(path, error))) return value;
    try {
        const std::filesystem::path own = render::asset(parameter.assetFolder) / value;
        return std::filesystem::exists(own, error) ? own.string() : value;
    } catch (const Failure&) {
        return value;  // The program's assets are not installed.
    }
}

}  // namespace vitrine
