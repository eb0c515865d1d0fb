#include "exhibits/framework/preset_migration.h"

#include "exhibits/framework/preset.h"

#include <array>
#include <limits>

namespace vitrine {
namespace {

using render::Json;

/// Version 0: {"schema": "vitrine", "exhibit": ..., "params": {...}}, with the camera's "fov" already in radians.
Json from0(const Json& old)
{
    Json json = Json::object();
    json["format"] = old.contains("exhibit") ? "vitrine-preset" : "vitrine-exhibition";
    json["version"] = 1;
    for (const auto& [key, value] : old.items()) {
        if (key == "schema") continue;
        json[key == "params" ? "values" : key] = value;
    }
    return json;
}

/// Version 1 has no "motions", and nothing else is another way.
Json from1(const Json& old)
{
    return old;
}

constexpr std::array<Json (*)(const Json&), presetVersion> steps = {from0, from1};

}  // namespace

int declaredVersion(const render::JsonDocument& document)
{
    const Json& root = document.root();
    if (!root.is_object()) throw document.failure({}, "this is no preset: it must be a JSON object.");
    if (!root.contains("version")) {
        if (root.contains("schema") && root["schema"] == "vitrine") return 0;
        throw document.failure({}, "this is no preset of Vitrine: it says neither format nor version.");
    }
    const Json& version = root["version"];
    if (!version.is_number_unsigned() || version.get<std::uint64_t>() > std::numeric_limits<int>::max()) {
        throw document.failure("version", "this must be a whole number; correct it there.");
    }
    const int number = version.get<int>();
    if (number > presetVersion) {
        throw document.failure("version", "a newer Vitrine wrote this (version " + std::to_string(number) +
                                              "; this one reads up to " + std::to_string(presetVersion) +
                                              "); open it with that one.");
    }
    return number;
}

Json migrated(const Json& json, int fromVersion)
{
    Json now = json;
    for (int version = fromVersion; version < presetVersion; ++version)
        now = steps.at(static_cast<std::size_t>(version))(now);
    return now;
}

std::string originalPath(const std::string& path, int fromVersion)
{
    if (fromVersion > 0 || (path != "values" && !path.starts_with("values."))) return {};
    return "params" + path.substr(std::string("values").size());
}

}  // namespace vitrine
