#include "exhibits/printing/print_json.h"

#include "exhibits/framework/table/preset_values.h"
#include "exhibits/printing/print_description.h"
#include "exhibits/printing/print_numbers.h"
#include "render/failure.h"
#include "render/files/extension.h"
#include "render/files/read_file.h"
#include "render/version.h"

namespace vitrine::printing {
namespace {

using render::Json;

constexpr int version = 1;
constexpr std::size_t mostJsonBytes = 4U << 20U;

constexpr const char* noPrint = "this does not describe a lenticular print; give a print, or the JSON beside it.";

/// Throws Failure if the document is not of a print.
void requirePrint(const render::JsonDocument& document)
{
    const Json& root = document.root();
    if (!root.is_object() || root.value("format", Json()) != "vitrine-job" || root.value("job", Json()) != "print")
        throw document.failure("", noPrint);
    if (root.value("version", Json()) != version)
        throw document.failure("version", "this must be 1; use the version of Vitrine that wrote the file.");
    if (!root.contains("values") || !root["values"].is_object())
        throw document.failure("values", "this must be an object; correct it there.");
}

/// Reads the values. What is missing keeps its initial value.
ParameterValues valuesOf(const render::JsonDocument& document, std::vector<std::string>& notes)
{
    ParameterValues values = printTable().initial();
    for (const auto& [key, json] : document.root()["values"].items()) {
        if (const auto row = printTable().find(key))
            values.setParameter(
                *row, valueFromJson(values.rows()[*row], json, JsonPlace{document, "values." + key}, key, notes));
        else
            notes.push_back("\"" + key + "\" is not known and was left out.");
    }
    return values;
}

/// Returns the document without what only a print has.
Json documentOf(const ParameterValues& values)
{
    Json json{{"format", "vitrine-job"}, {"version", version}, {"app", render::programVersion()}, {"job", "print"}};
    json["values"] = Json::object();
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        json["values"][std::string(values.rows()[i].name)] = jsonFromValue(values.rows()[i], values.row(i));
    return json;
}

}  // namespace

Json printJson(const ParameterValues& values, const PrintLayout& layout, double storedDpiX, const PrintSources& sources)
{
    const PrintNumbers numbers = numbersOf(layout, storedDpiX);
    Json json = documentOf(values);
    json["views"] = layout.settings().views;
    if (!sources.scene.is_null()) json["scene"] = sources.scene;
    json["report"] = {{"pixelsX", layout.width()},
                      {"pixelsY", layout.height()},
                      {"printLpi", layout.printLpi()},
                      {"storedLpi", numbers.effectiveLpi},
                      {"pixelsPerLens", numbers.pixelsPerLens},
                      {"effectiveViews", numbers.effectiveViews},
                      {"zoneDegrees", numbers.zoneDegrees},
                      {"depthBudget", numbers.depthBudget},
                      {"ownShare", numbers.ownShare},
                      {"warnings", warningsOf(layout)},
                      {"sources", sources.names}};
    if (!sources.rig.is_null()) json["report"]["rig"] = sources.rig;
    return json;
}

std::string withCrossTalk(const std::string& json, const CrossTalk& talk)
{
    Json changed = render::parseJson(json, "the print's description").root();
    changed["report"]["crossTalk"] = {{"before", talk.before}, {"after", talk.after}, {"clipped", talk.clipped}};
    return render::writeJson(changed);
}

PrintSettings settingsFromJson(const render::JsonDocument& document)
{
    requirePrint(document);
    const Json& root = document.root();
    for (const ParameterInfo& parameter : printTable().rows())
        if (parameter.group != "Views" && !parameter.isWritten() && !root["values"].contains(parameter.name))
            throw document.failure("values", "\"" + std::string(parameter.name) +
                                                 "\" is missing: this does not describe a lenticular "
                                                 "print; give a print, or the JSON beside it.");
    std::vector<std::string> notes;
    const ParameterValues values = valuesOf(document, notes);
    if (!notes.empty())
        throw document.failure("values", "no print has these values (" + notes.front() + "); correct it there.");
    const Json views = root.value("views", Json());
    if (!views.is_number_integer() || views.get<std::int64_t>() < 1 || views.get<std::int64_t>() > mostViews)
        throw document.failure("views", "this must be 1 to 256; correct it there.");
    return printSettings(values, views.get<int>());
}

std::string settingsText(const ParameterValues& values)
{
    return render::writeJson(documentOf(values));
}

SavedSettings savedSettings(const std::string& text, const std::string& fileName)
{
    const render::JsonDocument document = render::parseJson(text, fileName, {.bytes = mostJsonBytes});
    requirePrint(document);
    SavedSettings settings{printTable().initial(), {}};
    settings.values = valuesOf(document, settings.notes);
    return settings;
}

std::string settingsIn(const std::filesystem::path& path, std::vector<std::string>* doubts)
{
    if (render::lowerExtension(path) == ".json") return render::readFile(path, mostJsonBytes);
    PrintDescription description = printDescription(path);
    if (doubts && !description.doubt.empty()) doubts->push_back(std::move(description.doubt));
    return description.document.text();
}

}  // namespace vitrine::printing
