#include "exhibits/framework/files/file_path.h"

#include "render/failure.h"
#include "render/files/assets.h"

#include <filesystem>

namespace vitrine {

std::string filePath(const ParameterInfo& row, const std::string& value)
{
    if (row.assetFolder.empty() || value.empty() || std::filesystem::path(value).has_parent_path()) return value;
    try {
        const std::filesystem::path own = render::asset(row.assetFolder) / value;
        std::error_code error;
        return std::filesystem::exists(own, error) ? own.string() : value;
    } catch (const Failure&) {
        return value;  // The program's assets are not installed.
    }
}

}  // namespace vitrine
