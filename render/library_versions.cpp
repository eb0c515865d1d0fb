#include "render/library_versions.h"

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <png.h>

namespace vitrine::render {
namespace {

std::string dotted(int major, int minor)
{
    return std::to_string(major) + '.' + std::to_string(minor);
}

std::string dotted(int major, int minor, int patch)
{
    return dotted(major, minor) + '.' + std::to_string(patch);
}

}  // namespace

std::map<std::string, std::string> libraryVersions()
{
    return {{"Bullet", VITRINE_BULLET_VERSION},
            {"GLM", dotted(GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH)},
            {"libepoxy", VITRINE_EPOXY_VERSION},
            {"libpng", png_get_libpng_ver(nullptr)},
            {"nlohmann-json",
             dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
            {"tinygltf", VITRINE_TINYGLTF_VERSION}};
}

}  // namespace vitrine::render
