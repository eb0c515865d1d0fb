#include "exhibits/printing/print_json.h"

#include "exhibits/framework/preset_values.h"
#include "exhibits/printing/print_raster.h"
#include "render/failure.h"
#include "render/files/extension.h"
#include "render/files/read_file.h"
#include "render/version.h"

#include <cmath>
#include <limits>
#include <tuple>

namespace vitrine::printing {
namespace {

using render::Json;

constexpr int version = 1;
constexpr std::size_t mostJsonBytes = 4U << 20U;

/// Reader of the keys of an object; its failures name the key.
class Reader {
public:
    explicit Reader(const render::JsonDocument& document) : document_(document) {}

    [[nodiscard]] const Json& at(const std::string& group, const std::string& key) const
    {
        const Json& root = document_.root();
        const auto outer = root.is_object() ? root.find(group) : root.end();
        if (!root.is_object() || outer == root.end() || !outer->is_object() || !outer->contains(key)) {
            throw document_.failure(
                group,
                "\"" + key +
                    "\" is missing: this does not describe a lenticular print; give a print, or the JSON beside it.");
        }
        return (*outer)[key];
    }
    [[nodiscard]] double number(const std::string& group, const std::string& key) const
    {
        const Json& value = at(group, key);
        if (!value.is_number()) throw document_.failure(group + "." + key, "this must be a number; correct it there.");
        return value.get<double>();
    }
    [[nodiscard]] bool flag(const std::string& group, const std::string& key) const
    {
        const Json& value = at(group, key);
        if (!value.is_boolean())
            throw document_.failure(group + "." + key, "this must be true or false; correct it there.");
        return value.get<bool>();
    }

private:
    const render::JsonDocument& document_;
};

/// Returns whether two prints are the same except for the sheet.
bool samePrint(const PrintSettings& a, const PrintSettings& b)
{
    const auto all = [](const PrintSettings& s) {
        return std::tuple(s.dpiX, s.dpiY, s.width, s.height, s.bleed, s.distance, s.visualLpi, s.phase, s.direction,
                          s.reverse, s.mirror, s.views, s.method, s.guard, s.border, s.dither, s.compensate,
                          s.inkSpread);
    };
    return all(a) == all(b);
}

/// Reads the values under "desk". Throws Failure naming file, line and key.
void addValues(const render::JsonDocument& document, SavedSettings& settings)
{
    const PrintTable& table = printTable();
    const render::Json& root = document.root();
    if (!root.is_object() || !root.contains("desk")) return;
    const render::Json& desk = root["desk"];
    if (!desk.is_object() || !desk.contains("values") || !desk["values"].is_object())
        throw document.failure("desk", "this must be an object with \"values\"; correct it there.");
    for (const auto& [key, json] : desk["values"].items()) {
        const auto row = table.find(key);
        if (!row) {
            settings.notes.push_back("\"" + key + "\" is not known and was left out.");
            continue;
        }
        const JsonPlace place{document, "desk.values." + key};
        settings.values.setRow(*row, valueFromJson(table.rows()[*row], json, place, key, settings.notes));
    }
    if (!desk.contains("files")) return;
    if (!desk["files"].is_array())
        throw document.failure("desk.files", "this must be a list of file names; correct it there.");
    for (const render::Json& file : desk["files"]) {
        if (!file.is_string())
            throw document.failure("desk.files", "this must be a list of file names; correct it there.");
        settings.sources.push_back(file.get<std::string>());
    }
}

}  // namespace

Json printJson(const PrintLayout& layout, double storedDpiX, const std::vector<std::string>& sources)
{
    const PrintSettings& s = layout.settings();
    const PrintNumbers numbers = numbersOf(layout, storedDpiX);
    Json json;
    json["vitrinePrint"] = version;
    json["app"] = render::programVersion();
    json["sheet"] = {
        {"name", s.sheet.name},     {"nominalLpi", s.sheet.nominalLpi}, {"effectiveLpi", s.sheet.effectiveLpi},
        {"radius", s.sheet.radius}, {"thickness", s.sheet.thickness},   {"index", s.sheet.index},
        {"conic", s.sheet.conic}};
    json["print"] = {{"dpiX", s.dpiX},
                     {"dpiY", s.dpiY},
                     {"width", s.width},
                     {"height", s.height},
                     {"bleed", s.bleed},
                     {"distance", std::isinf(s.distance) ? Json(nullptr) : Json(s.distance)},
                     {"visualLpi", s.visualLpi},
                     {"phase", s.phase},
                     {"direction", s.direction},
                     {"reverse", s.reverse},
                     {"mirror", s.mirror},
                     {"views", s.views},
                     {"method", toString(s.method)},
                     {"guard", s.guard},
                     {"border", s.border},
                     {"dither", s.dither},
                     {"compensate", s.compensate},
                     {"inkSpread", s.inkSpread}};
    json["numbers"] = {{"pixelsX", layout.width()},
                       {"pixelsY", layout.height()},
                       {"printLpi", layout.printLpi()},
                       {"storedLpi", numbers.effectiveLpi},
                       {"pixelsPerLens", numbers.pixelsPerLens},
                       {"effectiveViews", numbers.effectiveViews},
                       {"zoneDegrees", numbers.zoneDegrees},
                       {"depthBudget", numbers.depthBudget},
                       {"ownShare", numbers.ownShare}};
    json["warnings"] = warningsOf(layout);
    json["sources"] = sources;
    return json;
}

std::string withCrossTalk(const std::string& json, const CrossTalk& talk)
{
    Json changed = render::parseJson(json, "the print's description").root();
    changed["crossTalk"] = {{"before", talk.before}, {"after", talk.after}, {"clipped", talk.clipped}};
    return render::writeJson(changed);
}

PrintSettings settingsFromJson(const render::JsonDocument& document)
{
    const Reader read(document);
    PrintSettings s;
    const Json& name = read.at("sheet", "name");
    s.sheet = {name.is_string() ? name.get<std::string>() : "",
               read.number("sheet", "nominalLpi"),
               read.number("sheet", "effectiveLpi"),
               read.number("sheet", "radius"),
               read.number("sheet", "thickness"),
               read.number("sheet", "index"),
               read.number("sheet", "conic")};
    s.dpiX = read.number("print", "dpiX");
    s.dpiY = read.number("print", "dpiY");
    s.width = read.number("print", "width");
    s.height = read.number("print", "height");
    s.bleed = read.number("print", "bleed");
    s.distance = read.at("print", "distance").is_null() ? std::numeric_limits<double>::infinity()
                                                        : read.number("print", "distance");
    s.visualLpi = read.number("print", "visualLpi");
    s.phase = read.number("print", "phase");
    s.direction = read.number("print", "direction");
    s.reverse = read.flag("print", "reverse");
    s.mirror = read.flag("print", "mirror");
    const double views = read.number("print", "views");
    if (!(views >= 1 && views <= mostViews))
        throw document.failure("print.views", "this must be 1 to 256; correct it there.");
    s.views = static_cast<int>(views);
    const Json& method = read.at("print", "method");
    for (const Method known : {Method::nearest, Method::area, Method::guard})
        if (method == toString(known)) s.method = known;
    s.guard = read.number("print", "guard");
    s.border = read.number("print", "border");
    s.dither = read.flag("print", "dither");
    s.compensate = read.flag("print", "compensate");
    s.inkSpread = read.number("print", "inkSpread");
    return s;
}

Json valuesJson(const ParameterValues& values, const std::vector<std::string>& sources)
{
    Json changed = Json::object();
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (!values.isInitial(i))
            changed[std::string(values.rows()[i].name)] = jsonFromValue(values.rows()[i], values.row(i));
    return {{"values", changed}, {"files", sources}};
}

std::string settingsText(const ParameterValues& values, const std::vector<std::string>& sources)
{
    Json json;
    try {
        const PrintLayout layout(printSettings(values, values[printTable().views]));
        json = printJson(layout, layout.settings().dpiX, sources);
    } catch (const Failure&) {
        json["vitrinePrint"] = version;  // Impossible settings are kept, too, since the user may still be editing them.
    }
    json["desk"] = valuesJson(values, sources);
    return render::writeJson(json);
}

SavedSettings savedSettings(const std::string& text, const std::string& fileName)
{
    const render::JsonDocument document = render::parseJson(text, fileName, {.bytes = mostJsonBytes});
    if (!document.root().is_object() || document.root().value("vitrinePrint", Json()) != version) {
        throw document.failure(
            "vitrinePrint",
            "this does not describe a lenticular print of version 1; give a print, or the JSON beside it.");
    }
    SavedSettings settings{printTable().initial(), {}, {}};
    addValues(document, settings);
    if (!document.root().contains("print")) return settings;
    const PrintSettings read = settingsFromJson(document);
    try {
        const PrintSettings here = printSettings(settings.values, read.views);
        if (samePrint(here, read) && sameLens(here.sheet, read.sheet)) return settings;
    } catch (const Failure&) {  // The values describe no possible print, so the print's own part counts.
    }
    settings.values = withSettings(settings.values, read);
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
