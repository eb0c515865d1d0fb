#include "exhibits/framework/preset_migration.h"

#include "exhibits/framework/preset.h"

#include <array>
#include <limits>
#include <string_view>

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

/// Rows that have had another name since version 2.
struct RenamedRow {
    std::string_view exhibit, before, now;
};
constexpr std::array renamedRows{RenamedRow{"hall", "environmentTurn", "environmentRotation"},
                                 RenamedRow{"hall", "modelTurn", "modelRotation"},
                                 RenamedRow{"fur", "handTurn", "handRotation"},
                                 RenamedRow{"crepuscular_rays", "turn", "mobileRotation"},
                                 RenamedRow{"crepuscular_rays", "airThinning", "densityFalloff"},
                                 RenamedRow{"crepuscular_rays", "unevenness", "densityNoise"}};

/// The keys of a preset are names of rows, those of an exhibition "exhibit.row".
Json from1(const Json& old)
{
    Json json = old;
    json["version"] = 2;
    if (!json.contains("values") || !json["values"].is_object()) return json;
    const bool ofOne = json.contains("format") && json["format"] == "vitrine-preset";
    const auto renamed = [&](const std::string& key) {
        for (const RenamedRow& row : renamedRows) {
            const std::string prefix = ofOne ? "" : std::string(row.exhibit) + ".";
            if (ofOne && !(json.contains("exhibit") && json["exhibit"] == std::string(row.exhibit))) continue;
            if (key == prefix + std::string(row.before)) return prefix + std::string(row.now);
        }
        return key;
    };
    Json values = Json::object();
    for (const auto& [key, value] : json["values"].items()) values[renamed(key)] = value;
    json["values"] = std::move(values);
    return json;
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
    if (path != "values" && !path.starts_with("values.")) return {};
    std::string original = path;
    if (fromVersion < 2) {
        const std::size_t name = path.rfind('.') + 1;
        for (const RenamedRow& row : renamedRows)
            if (path.substr(name) == row.now) original = path.substr(0, name) + std::string(row.before);
    }
    if (fromVersion < 1) original.replace(0, std::string("values").size(), "params");
    return original == path ? std::string() : original;
}

}  // namespace vitrine
