#include "render/files/assets.h"

#include "render/failure.h"

#include <cstdlib>
#include <vector>

namespace vitrine::render {
namespace {

namespace fs = std::filesystem;

fs::path findAssets()
{
    std::vector<fs::path> candidates;
    if (const char* chosen = std::getenv("VITRINE_ASSETS"); chosen && *chosen) candidates.emplace_back(chosen);
    std::error_code error;
    if (const fs::path program = fs::read_symlink("/proc/self/exe", error); !error) {
        for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
            candidates.push_back(folder / "share" / "vitrine");
            candidates.push_back(folder / "assets");
        }
    }
    candidates.emplace_back(VITRINE_ASSET_DIR);
    for (const fs::path& candidate : candidates)
        if (fs::exists(candidate / "models" / "materials.json", error)) return candidate;
    throw Failure(ErrorKind::file,
                  message("The program's assets were not found beside it (looked last in {1}); reinstall "
                          "it, or set VITRINE_ASSETS to the folder that holds models/materials.json.",
                          candidates.back()));
}

}  // namespace

const fs::path& assetFolder()
{
    static const fs::path folder = findAssets();
    return folder;
}

fs::path asset(std::string_view relative)
{
    return assetFolder() / relative;
}

}  // namespace vitrine::render
