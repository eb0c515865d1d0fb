#include "exhibits/printing/sheet_list.h"

#include "exhibits/framework/files/state_folder.h"
#include "render/failure.h"
#include "render/files/strict_json.h"

#include <algorithm>

namespace vitrine::printing {
namespace {

using render::Json;

constexpr render::JsonLimits limits{.bytes = 1U << 20U, .depth = 8, .nodes = 20'000, .stringBytes = 1000};

Sheet sheetFrom(const render::JsonDocument& document, std::size_t i)
{
    const std::string place = "sheets[" + std::to_string(i) + "]";
    const Json& json = document.root()["sheets"][i];
    if (!json.is_object() || !json.contains("name") || !json["name"].is_string())
        throw document.failure(
            place, "this must be a sheet with a name; correct it there, or move the file away to begin a new list.");
    const auto number = [&](const char* key) {
        if (!json.contains(key) || !json[key].is_number())
            throw document.failure(place, std::string("\"") + key +
                                              "\" must be a number; correct it there, or move the file "
                                              "away to begin a new list.");
        return json[key].get<double>();
    };
    Sheet sheet{json["name"].get<std::string>(),
                number("nominalLpi"),
                number("effectiveLpi"),
                number("radius"),
                number("thickness"),
                number("index"),
                number("conic")};
    try {
        check(sheet);
    } catch (const Failure& failure) {
        throw document.failure(place, failure.what());
    }
    return sheet;
}

}  // namespace

SheetList::SheetList() : SheetList(configFolder() / "sheets.json") {}

std::vector<Sheet> SheetList::all(std::string& problem) const
{
    std::vector<Sheet> sheets = knownSheets();
    try {
        for (Sheet& sheet : own()) sheets.push_back(std::move(sheet));
    } catch (const Failure& failure) {
        problem = failure.what();
    }
    return sheets;
}

Sheet SheetList::named(const std::string& name) const
{
    std::string problem;
    for (const Sheet& sheet : all(problem))
        if (sheet.name == name) return sheet;
    throw Failure(ErrorKind::usage, "There is no sheet \"" + name + "\"; choose one of the list.");
}

std::string SheetList::nameOf(const Sheet& wanted, const std::string& preferred) const
{
    std::string problem;
    std::string first;
    for (const Sheet& sheet : all(problem)) {
        if (!sameLens(wanted, sheet)) continue;
        if (sheet.name == preferred) return preferred;
        if (first.empty()) first = sheet.name;
    }
    return first;
}

std::vector<Sheet> SheetList::own() const
{
    std::error_code error;
    if (!std::filesystem::exists(path_, error)) return {};
    const render::JsonDocument document = render::readJson(path_, limits);
    const Json& root = document.root();
    if (!root.is_object() || root.value("format", Json()) != "vitrine-sheets" || root.value("version", Json()) != 1 ||
        !root.contains("sheets") || !root["sheets"].is_array()) {
        throw document.failure(
            "", "this is not a list of lens sheets of version 1; move the file away to begin a new list.");
    }
    std::vector<Sheet> sheets;
    for (std::size_t i = 0; i < root["sheets"].size(); ++i) sheets.push_back(sheetFrom(document, i));
    return sheets;
}

void SheetList::save(const Sheet& sheet) const
{
    check(sheet);
    if (sheet.name.empty()) throw Failure(ErrorKind::usage, "A sheet needs a name to be saved under.");
    const auto named = [&](const Sheet& other) { return other.name == sheet.name; };
    if (std::any_of(knownSheets().begin(), knownSheets().end(), named)) {
        throw Failure(ErrorKind::usage,
                      "\"" + sheet.name + "\" is one of the sheets that come with the program; choose another name.");
    }
    std::vector<Sheet> sheets = own();
    const auto old = std::find_if(sheets.begin(), sheets.end(), named);
    if (old == sheets.end())
        sheets.push_back(sheet);
    else
        *old = sheet;
    write(sheets);
}

void SheetList::remove(const std::string& name) const
{
    std::vector<Sheet> sheets = own();
    std::erase_if(sheets, [&](const Sheet& sheet) { return sheet.name == name; });
    write(sheets);
}

void SheetList::write(const std::vector<Sheet>& sheets) const
{
    Json list = Json::array();
    for (const Sheet& s : sheets) {
        list.push_back({{"name", s.name},
                        {"nominalLpi", s.nominalLpi},
                        {"effectiveLpi", s.effectiveLpi},
                        {"radius", s.radius},
                        {"thickness", s.thickness},
                        {"index", s.index},
                        {"conic", s.conic}});
    }
    const Json json{{"format", "vitrine-sheets"}, {"version", 1}, {"sheets", list}};
    writeOwnFile(path_, render::writeJson(json));
}

}  // namespace vitrine::printing
