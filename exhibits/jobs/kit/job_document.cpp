#include "exhibits/jobs/kit/job_document.h"

#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/value_schema.h"
#include "exhibits/jobs/kit/given_values.h"
#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "render/files/extension.h"
#include "render/files/read_file.h"
#include "render/version.h"

#include <cctype>

namespace vitrine::jobs {
namespace {

using render::Json;

constexpr const char* documentFormat = "vitrine-job";

Json sceneJson(const Job& job, const JobScene& scene)
{
    const bool any = job.needs().anyScene || job.needs().twoSettings;
    PictureRequest picture;
    picture.frame = scene.frame;
    picture.samples = scene.usual.samples != 0 ? scene.usual.samples : usualSamples(scene.state.hall());
    Json json = render::parseJson(pictureSettings(*scene.museum, scene.subject, scene.state, picture,
                                                  scene.name.empty() ? "Settings of a job" : scene.name,
                                                  any ? nullptr : &scene.state.camera),
                                  "scene")
                    .root();
    if (any)
        json["picture"].erase("size");  // A parameter of the job.
    else
        json.erase("picture");
    return json;
}

Json otherJson(const JobScene& scene)
{
    const SceneState& other = scene.other->state;
    return exhibitionJson({scene.other->name, namedValues(scene.museum->subjects(), other.values), other.camera});
}

/// Returns the state of an exhibition, with the initial values where it has none.
SceneState stateOf(Exhibition& read, const Museum& museum)
{
    SceneState state = museum.initialSceneState();
    for (auto& [subject, values] : read.values)
        if (const auto i = museum.find(subject)) state.values[*i] = std::move(values);
    state.camera = read.camera;
    return state;
}

Exhibition readExhibition(const Json& json, const std::string& name, const Museum& museum, JobDocument& document)
{
    Exhibition read = parseExhibition(render::writeJson(json), name,
                                      namedValues(museum.subjects(), museum.initialSceneState().values));
    document.notes.insert(document.notes.end(), read.notes.begin(), read.notes.end());
    return read;
}

void readScene(const Json& json, const std::string& name, const Museum& museum, JobDocument& document)
{
    Exhibition read = readExhibition(json, name, museum, document);
    document.scene = stateOf(read, museum);
    document.chosen = read.chosen;
    document.taken = read.picture;
    document.name = read.name;
}

/// Converts a label to a key: "cellsNearTheSurface" for "Cells near the surface".
std::string keyOf(const std::string& label)
{
    std::string key;
    bool upper = false;
    for (const char c : label) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalnum(letter) == 0) {
            upper = true;
            continue;
        }
        key += static_cast<char>(upper ? std::toupper(letter) : key.empty() ? std::tolower(letter) : letter);
        upper = false;
    }
    return key;
}

Json optionSchema(const Parameters& table, const JobOption& option)
{
    const ParameterInfo& first = table.rows()[option.parameters.front()];
    Json json;
    if (option.parameters.size() == 1) {
        json = valueSchema(first);
    } else {
        Json items = Json::array();
        for (const std::size_t i : option.parameters) items.push_back(valueSchema(table.rows()[i]));
        json = {{"type", "array"}, {"prefixItems", items}, {"items", false}, {"minItems", items.size()}};
    }
    describe(json, first);
    const Json initial = jsonOf(table.initial())[option.key];
    if (!option.mustBeGiven) json["default"] = initial;
    const std::string when = actsWhen(table, option.parameters.front());
    if (!when.empty()) json["x-actsWhen"] = when;
    return json;
}

}  // namespace

std::filesystem::path documentFile(const std::filesystem::path& out)
{
    return out.parent_path() / (out.filename().string() + ".vitrine-job.json");
}

std::string documentText(const Job& job, const JobOrder& order, const std::vector<Fact>& facts)
{
    Json json = Json::object();
    json["format"] = documentFormat;
    json["version"] = jobDocumentVersion;
    json["app"] = render::programVersion();
    json["job"] = std::string(job.name());
    json["values"] = jsonOf(order.values);
    if (order.scene.museum) json["scene"] = sceneJson(job, order.scene);
    if (order.scene.museum && order.scene.other) json["other"] = otherJson(order.scene);
    json["out"] = order.out.filename().string();
    json["report"] = Json::object();
    for (const Fact& fact : facts) json["report"][keyOf(fact.label)] = valueText(fact);
    return render::writeJson(json);
}

JobDocument parseDocument(std::string text, const std::string& name, const Job& job, const Museum* museum)
{
    const render::JsonDocument document = render::parseJson(std::move(text), name, presetLimits);
    const Json& root = document.root();
    const auto has = [&](const char* key) { return root.is_object() && root.contains(key); };
    if (!has("format") || root["format"] != documentFormat)
        throw document.failure("", "this is no settings document of a job; give a file that a job of Vitrine wrote.");
    if (!has("version") || !root["version"].is_number_integer() || root["version"].get<int>() < 1)
        throw document.failure("version", "this must be a whole number from 1; correct it there.");
    if (root["version"].get<int>() > jobDocumentVersion)
        throw document.failure("version", "this document is newer than the program; use a newer Vitrine.");
    if (!has("job") || root["job"] != std::string(job.name()))
        throw document.failure("job", "this document is not of the job " + std::string(job.name()) +
                                          "; give one that it wrote.");
    if (!has("values")) throw document.failure("", "\"values\" is missing; give a file that a job of Vitrine wrote.");
    GivenValues given{ParameterValues(job.parameters())};
    std::vector<std::string> notes;
    given.read(root["values"], {document, "values"}, notes);
    JobDocument read{given.settled({})};
    read.notes = std::move(notes);
    if (has("scene") && museum) readScene(root["scene"], name, *museum, read);
    if (has("other") && museum) {
        Exhibition other = readExhibition(root["other"], name, *museum, read);
        read.other = OtherSettings{stateOf(other, *museum), other.name};
    }
    if (has("out")) {
        if (!root["out"].is_string()) throw document.failure("out", "this must be a file name; correct it there.");
        const std::string out = root["out"].get<std::string>();
        if (!out.empty()) read.out = std::filesystem::path(name).parent_path() / out;
    }
    return read;
}

JobDocument readDocument(const std::filesystem::path& file, const Job& job, const Museum* museum)
{
    const bool isDocument = render::lowerExtension(file) == ".json";
    const std::filesystem::path path = isDocument ? file : documentFile(file);
    return parseDocument(render::readFile(path, presetLimits.bytes), path.string(), job, museum);
}

render::Json schemaOf(const Job& job)
{
    Json properties = Json::object(), required = Json::array();
    for (const JobOption& option : optionsOf(job.parameters())) {
        properties[option.key] = optionSchema(job.parameters(), option);
        if (option.mustBeGiven) required.push_back(option.key);
    }
    return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"title", std::string(job.name())},
            {"description", std::string(job.summary())},
            {"type", "object"},
            {"properties", properties},
            {"required", required},
            {"additionalProperties", false}};
}

}  // namespace vitrine::jobs
