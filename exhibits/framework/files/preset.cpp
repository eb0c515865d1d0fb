#include "exhibits/framework/files/preset.h"

#include "exhibits/framework/table/preset_values.h"
#include "exhibits/framework/time/motion_json.h"
#include "render/version.h"

#include <algorithm>
#include <array>
#include <map>

namespace vitrine {
namespace {

using render::Json;
using render::JsonDocument;

constexpr std::string_view presetFormat = "vitrine-preset";
constexpr std::string_view exhibitionFormat = "vitrine-exhibition";
constexpr std::array<std::string_view, 9> keysOfAll = {"format", "version", "app",     "exhibit", "name",
                                                       "tags",   "values",  "motions", "camera"};

bool isKnownKey(std::string_view key, bool inExhibition)
{
    return std::find(keysOfAll.begin(), keysOfAll.end(), key) != keysOfAll.end() || (inExhibition && key == "picture");
}

std::string textAt(const JsonDocument& document, const Json& root, const char* key, bool required)
{
    if (!root.contains(key)) {
        if (!required) return {};
        throw document.failure({}, message("the key \"{1}\" is missing; add it.", key));
    }
    if (!root[key].is_string()) throw document.failure(key, message("this must be text; correct it there."));
    return root[key].get<std::string>();
}

/// Throws Failure where the file is not a preset, or of another version.
void checkVersion(const JsonDocument& document)
{
    const Json& root = document.root();
    if (!root.is_object()) throw document.failure({}, message("this is not a preset: it must be a JSON object."));
    if (!root.contains("version"))
        throw document.failure({}, message("this is not a preset of Vitrine: it says neither format nor version."));
    const Json& version = root["version"];
    if (!version.is_number_unsigned())
        throw document.failure("version", message("this must be a whole number; correct it there."));
    const auto number = version.get<std::uint64_t>();
    if (number > presetVersion)
        throw document.failure(
            "version",
            message("a newer Vitrine wrote this (version {1}; this one reads version {2}); open it with that one.",
                    number, presetVersion));
    if (number < presetVersion)
        throw document.failure("version", message("there is no version {1}; correct it there.", number));
}

/// A preset or exhibition file, its kind and name checked.
struct Opened {
    const JsonDocument& document;
    PresetHeader header;
    Json root;
    Json values = Json::object(), motions = Json::object();
    std::vector<std::string> notes;

    [[nodiscard]] JsonPlace place(const std::string& path) const { return {document, path}; }
};

Opened open(const JsonDocument& document)
{
    Opened file{document, {}, {}, Json::object(), Json::object(), {}};
    file.header = presetHeader(document);
    file.root = document.root();
    for (const auto& [key, into] : {std::pair("values", &file.values), std::pair("motions", &file.motions)}) {
        if (!file.root.contains(key)) continue;
        *into = file.root[key];
        if (!into->is_object()) throw file.place(key).failure(message("this must be an object; correct it there."));
    }
    for (const auto& [key, value] : file.root.items()) {
        if (!isKnownKey(key, file.header.isExhibition)) file.notes.push_back(key + " is not known here; it is kept");
    }
    return file;
}

/// Moves the entries that may be parameters added to the table by a file from `left`, and from the object `key` of the
/// file, into the result (for values or for motions).
ParameterValues::PendingParameters pendingParameters(Opened& file, const char* key, const ParameterValues& values,
                                                     const std::string& prefix,
                                                     std::map<std::string, const Json*>& left)
{
    ParameterValues::PendingParameters pending;
    const std::vector<std::string> files = values.tableFiles();
    if (std::all_of(files.begin(), files.end(), [](const std::string& path) { return path.empty(); })) return pending;
    for (auto at = left.lower_bound(prefix); at != left.end() && at->first.starts_with(prefix);) {
        const std::string name = at->first.substr(prefix.size());
        if (!isParameterName(name)) {
            ++at;
            continue;
        }
        pending[name] = render::writeJson(*at->second);
        file.root[key].erase(at->first);
        at = left.erase(at);
    }
    return pending;
}

/// Reads the parameters of one table; `prefix` is "" or "sdf_morph.". Removes what it read from `left`.
ParameterValues readParameters(Opened& file, const Parameters& table, const std::string& prefix,
                               std::map<std::string, const Json*>& left)
{
    ParameterValues values = table.initial();
    for (std::size_t i = 0; i < table.rows().size(); ++i) {
        const ParameterInfo& row = table.rows()[i];
        const auto at = left.find(prefix + std::string(row.name));
        if (at == left.end()) continue;
        const std::string key = at->first;
        values.setParameter(i, valueFromJson(row, *at->second, file.place("values." + key), key, file.notes));
        left.erase(at);
    }
    values.setPending(pendingParameters(file, "values", values, prefix, left));
    return values;
}

/// Reads the motions of the parameters of one table, like `readParameters`.
void readMotions(Opened& file, ParameterValues& values, const std::string& prefix,
                 std::map<std::string, const Json*>& left)
{
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const ParameterInfo& row = values.rows()[i];
        const auto at = left.find(prefix + std::string(row.name));
        if (at == left.end()) continue;
        const std::string key = "motions." + at->first;
        values.setMotion(i, motionFromJson(row, *at->second, file.place(key), key, file.notes));
        file.root["motions"].erase(at->first);
        left.erase(at);
    }
    values.setPendingMotions(pendingParameters(file, "motions", values, prefix, left));
}

std::map<std::string, const Json*> entries(const Json& object)
{
    std::map<std::string, const Json*> map;
    for (const auto& [key, value] : object.items()) map[key] = &value;
    return map;
}

void noteUnknown(Opened& file, const std::string& of, const std::map<std::string, const Json*>& left)
{
    for (const auto& [key, value] : left) file.notes.push_back(of + key + " is not known here; it is kept");
}

void writeParameters(const ParameterValues& values, const std::string& prefix, std::map<std::string, Json>& out)
{
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const ParameterInfo& row = values.rows()[i];
        std::string key = prefix;
        key += row.name;
        if (values.isInitial(i))
            out.erase(key);
        else
            out[key] = jsonFromValue(row, values.row(i));
    }
    for (const auto& [name, json] : values.pending()) out[prefix + name] = render::parseJson(json, name).root();
}

void writeMotions(const ParameterValues& values, const std::string& prefix, std::map<std::string, Json>& out)
{
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (const Motion* motion = values.motion(i))
            out[prefix + std::string(values.rows()[i].name)] = jsonFromMotion(values.rows()[i], *motion);
    for (const auto& [name, json] : values.pendingMotions()) out[prefix + name] = render::parseJson(json, name).root();
}

/// Returns the entries below `key` in the file that was read; the caller overwrites them.
std::map<std::string, Json> keptOf(const Json& kept, const char* key)
{
    std::map<std::string, Json> values;
    if (!kept.contains(key)) return values;
    for (const auto& [name, value] : kept[key].items()) values[name] = value;
    return values;
}

Json objectOf(const std::map<std::string, Json>& entries)
{
    Json object = Json::object();
    for (const auto& [key, value] : entries) object[key] = value;
    return object;
}

/// Entries of a preset or an exhibition.
struct FileEntries {
    const std::string& exhibit;
    const std::string& name;
    const PresetTags& tags;
    std::map<std::string, Json> values, motions;
    std::optional<Json> camera;
    std::optional<PictureRecord> picture;
    const Json& kept;  ///< Entries of a later version, which are written again.
};

Json fileJson(std::string_view format, const FileEntries& entries)
{
    const auto& [exhibit, name, tags, values, motions, camera, picture, kept] = entries;
    Json root = Json::object();
    root["format"] = format;
    root["version"] = presetVersion;
    root["app"] = render::programVersion();
    if (!exhibit.empty()) root["exhibit"] = exhibit;
    root["name"] = name;
    if (!tags.empty()) root["tags"] = tags;
    root["values"] = objectOf(values);
    if (!motions.empty()) root["motions"] = objectOf(motions);
    if (camera) root["camera"] = *camera;
    if (picture) root["picture"] = jsonFromPictureRecord(*picture);
    for (const auto& [key, value] : kept.items()) {
        if (!isKnownKey(key, format == exhibitionFormat)) root[key] = value;
    }
    return root;
}

Json keptCamera(const Json& kept)
{
    return kept.contains("camera") ? kept["camera"] : Json::object();
}

}  // namespace

PresetHeader presetHeader(const JsonDocument& document)
{
    PresetHeader header;
    checkVersion(document);
    const Json& root = document.root();
    const std::string format = textAt(document, root, "format", true);
    if (format != presetFormat && format != exhibitionFormat) {
        throw document.failure("format", message("\"{1}\" is not a format of Vitrine; choose a preset.", format));
    }
    header.isExhibition = format == exhibitionFormat;
    header.exhibit = textAt(document, root, "exhibit", !header.isExhibition);
    header.name = textAt(document, root, "name", false);
    header.tags = tagsIn(document, root);
    return header;
}

Preset parsePreset(std::string text, std::string fileName, std::string_view exhibit, const Parameters& table)
{
    const JsonDocument document = render::parseJson(std::move(text), std::move(fileName), presetLimits);
    Opened file = open(document);
    if (file.header.isExhibition)
        throw document.failure("format",
                               message("this holds settings of the whole exhibition; open the file as an exhibition."));
    if (file.header.exhibit != exhibit) {
        throw document.failure(
            "exhibit", message("this preset is for {1}, not for {2}; choose another.", file.header.exhibit, exhibit));
    }
    std::map<std::string, const Json*> left = entries(file.values), leftMotions = entries(file.motions);
    Preset preset{file.header.exhibit, file.header.name, readParameters(file, table, {}, left), std::nullopt, {}, {},
                  file.header.tags};
    readMotions(file, preset.values, {}, leftMotions);
    noteUnknown(file, "values.", left);
    noteUnknown(file, "motions.", leftMotions);
    if (file.root.contains("camera"))
        preset.camera = cameraFromJson(file.root["camera"], file.place("camera"), file.notes);
    preset.kept = std::move(file.root);
    preset.notes = std::move(file.notes);
    return preset;
}

std::string presetText(const Preset& preset)
{
    std::map<std::string, Json> values = keptOf(preset.kept, "values"), motions = keptOf(preset.kept, "motions");
    writeParameters(preset.values, {}, values);
    writeMotions(preset.values, {}, motions);
    std::optional<Json> camera;
    if (preset.camera) camera = jsonFromCamera(*preset.camera, keptCamera(preset.kept));
    return render::writeJson(fileJson(presetFormat, {preset.exhibit, preset.name, preset.tags, std::move(values),
                                                     std::move(motions), camera, std::nullopt, preset.kept}));
}

Exhibition parseExhibition(std::string text, std::string fileName, const NamedValues& initial)
{
    const JsonDocument document = render::parseJson(std::move(text), std::move(fileName), presetLimits);
    Opened file = open(document);
    if (!file.header.isExhibition)
        throw document.failure("format", message("this is a preset of one exhibit; open it there."));
    std::map<std::string, const Json*> left = entries(file.values), leftMotions = entries(file.motions);
    Exhibition exhibition;
    exhibition.name = file.header.name;
    exhibition.chosen = file.header.exhibit;
    exhibition.tags = file.header.tags;
    for (const auto& [name, values] : initial) {
        exhibition.values.emplace_back(name, readParameters(file, values.table(), name + ".", left));
        readMotions(file, exhibition.values.back().second, name + ".", leftMotions);
    }
    noteUnknown(file, "values.", left);
    noteUnknown(file, "motions.", leftMotions);
    if (file.root.contains("camera"))
        exhibition.camera = cameraFromJson(file.root["camera"], file.place("camera"), file.notes);
    if (file.root.contains("picture"))
        exhibition.picture = pictureRecordFromJson(file.root["picture"], file.place("picture"), file.notes);
    exhibition.kept = std::move(file.root);
    exhibition.notes = std::move(file.notes);
    return exhibition;
}

Json exhibitionJson(const Exhibition& exhibition)
{
    std::map<std::string, Json> values = keptOf(exhibition.kept, "values"),
                                motions = keptOf(exhibition.kept, "motions");
    for (const auto& [name, ofExhibit] : exhibition.values) {
        writeParameters(ofExhibit, name + ".", values);
        writeMotions(ofExhibit, name + ".", motions);
    }
    return fileJson(exhibitionFormat,
                    {exhibition.chosen, exhibition.name, exhibition.tags, std::move(values), std::move(motions),
                     jsonFromCamera(exhibition.camera, keptCamera(exhibition.kept)), exhibition.picture,
                     exhibition.kept});
}

std::string exhibitionText(const Exhibition& exhibition)
{
    return render::writeJson(exhibitionJson(exhibition));
}

Preset presetInExhibition(std::string text, std::string fileName, std::string_view exhibit, const Parameters& table)
{
    const JsonDocument document = render::parseJson(std::move(text), std::move(fileName), presetLimits);
    Opened file = open(document);
    if (!file.header.isExhibition)
        throw document.failure("format", message("this is a preset of one exhibit; open it there."));
    std::map<std::string, const Json*> left = entries(file.values), leftMotions = entries(file.motions);
    const std::string name(exhibit);
    Preset preset{name, file.header.name, readParameters(file, table, name + '.', left), std::nullopt};
    readMotions(file, preset.values, name + '.', leftMotions);
    if (file.header.exhibit != exhibit && preset.values == table.initial())
        throw document.failure("exhibit", message("this holds settings of {1} and none of {2}; choose another.",
                                                  file.header.exhibit, name));
    if (file.root.contains("camera"))
        preset.camera = cameraFromJson(file.root["camera"], file.place("camera"), file.notes);
    preset.notes = std::move(file.notes);
    preset.tags = file.header.tags;
    return preset;
}

std::string renamedPreset(const JsonDocument& document, std::string_view name)
{
    const PresetHeader header = presetHeader(document);
    Json root = document.root();
    if (!root.contains("name")) {
        // The name is inserted before the values, where other presets have it.
        Json ordered = Json::object();
        for (const auto& [key, value] : root.items()) {
            if (key == "values") ordered["name"] = name;
            ordered[key] = value;
        }
        root = std::move(ordered);
    }
    root["name"] = name;
    return render::writeJson(root);
}

NamedValues namedValues(Subjects subjects, std::span<const ParameterValues> values)
{
    NamedValues named;
    for (std::size_t i = 0; i < subjects.size(); ++i) named.emplace_back(std::string(subjects[i]->name()), values[i]);
    return named;
}

}  // namespace vitrine
