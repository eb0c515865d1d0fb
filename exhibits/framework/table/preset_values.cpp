#include "exhibits/framework/table/preset_values.h"

#include "render/files/number_text.h"
#include "render/text/joined.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine {
namespace {

using render::Json;
using render::shortestNumber;

std::string nameOf(const Json& json)
{
    switch (json.type()) {
    case Json::value_t::object: return "an object";
    case Json::value_t::array: return "an array";
    case Json::value_t::string: return "text";
    case Json::value_t::boolean: return "true or false";
    case Json::value_t::null: return "null";
    default: return "a number";
    }
}

[[noreturn]] void wrongType(const JsonPlace& place, std::string_view wanted, const Json& got)
{
    std::string problem = "this must be ";
    ((problem += wanted) += ", not ") += nameOf(got);
    throw place.failure(problem += "; correct it there.");
}

double numberAt(const Json& json, const JsonPlace& place)
{
    if (!json.is_number()) wrongType(place, "a number", json);
    return json.get<double>();
}

glm::dvec3 threeAt(const Json& json, const JsonPlace& place)
{
    const bool good = json.is_array() && json.size() == 3 &&
                      std::all_of(json.begin(), json.end(), [](const Json& x) { return x.is_number(); });
    if (!good) wrongType(place, "an array of three numbers", json);
    return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

Json three(const glm::dvec3& v)
{
    return Json::array({v.x, v.y, v.z});
}

/// Returns the texts of an array, one per line.
std::string linesAt(const Json& json, const JsonPlace& place)
{
    if (!json.is_array()) wrongType(place, "an array of texts", json);
    std::string lines;
    for (const Json& each : json) {
        if (!each.is_string()) wrongType(place, "an array of texts", each);
        const auto& text = each.get_ref<const std::string&>();
        if (text.empty() || text.find('\n') != std::string::npos)
            throw place.failure("each text here must be a single line that is not empty; correct it there.");
        lines += (lines.empty() ? "" : "\n") + text;
    }
    return lines;
}

Value readValue(const ParameterInfo& parameter, const Json& json, const JsonPlace& place)
{
    switch (parameter.kind) {
    case Kind::real:
    case Kind::count:
        if (json.is_string())
            for (const Word& word : parameter.words)
                if (json.get_ref<const std::string&>() == word.text) return word.value;
        return numberAt(json, place);
    case Kind::toggle:
        if (!json.is_boolean()) wrongType(place, "true or false", json);
        return json.get<bool>() ? 1.0 : 0.0;
    case Kind::choice: {
        if (!json.is_string()) wrongType(place, "the name of a choice", json);
        const auto& name = json.get_ref<const std::string&>();
        const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), name);
        if (found == parameter.choices.end())
            throw place.failure("unknown choice \"" + name + "\"; choose one of " + joined(parameter.choices) + ".");
        return static_cast<double>(found - parameter.choices.begin());
    }
    case Kind::color:
    case Kind::direction: return threeAt(json, place);
    case Kind::file:
    case Kind::text:
        if (parameter.several) return linesAt(json, place);
        if (!json.is_string()) wrongType(place, parameter.kind == Kind::file ? "a file name" : "text", json);
        return json.get<std::string>();
    }
    return 0.0;
}

std::string textOf(const Value& value)
{
    if (const auto* x = std::get_if<double>(&value)) return shortestNumber(*x);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    const glm::dvec3& v = std::get<glm::dvec3>(value);
    std::string text = "(";
    ((text += shortestNumber(v.x)) += ", ") += shortestNumber(v.y);
    return ((text += ", ") += shortestNumber(v.z)) += ")";
}

std::string changeNote(const ParameterInfo& parameter, std::string_view shownName, const Value& from, const Value& to)
{
    std::string note(shownName);
    ((note += ' ') += textOf(from)) += " -> ";
    (note += textOf(to)) += " (";
    if (parameter.kind == Kind::direction) return note += "made unit length)";
    const auto* number = std::get_if<double>(&from);
    const bool inRange = number && *number >= parameter.range.low && *number <= parameter.range.high;
    if (inRange) return note += "whole numbers only)";
    ((note += "allowed ") += shortestNumber(parameter.range.low)) += " to ";
    return (note += shortestNumber(parameter.range.high)) += ")";
}

/// Returns whether a number equals a limit of its parameter up to rounding, as 3.141593 for half a turn. No note is
/// added then.
bool isRoundedLimit(const ParameterInfo& parameter, const Value& value)
{
    const auto* x = std::get_if<double>(&value);
    if (!x || parameter.kind != Kind::real) return false;
    const auto near = [&](double limit) { return std::abs(*x - limit) <= 1e-6 * std::abs(limit); };
    return near(parameter.range.low) || near(parameter.range.high);
}

}  // namespace

Failure JsonPlace::failure(const Message& problem) const
{
    return document.failure(path, problem);
}

JsonPlace JsonPlace::inside(std::string_view key) const
{
    return {document, path.empty() ? std::string(key) : path + '.' + std::string(key)};
}

Json jsonFromValue(const ParameterInfo& parameter, const Value& value)
{
    if (const auto* text = std::get_if<std::string>(&value)) {
        if (!parameter.several) return *text;
        Json lines = Json::array();
        for (const std::string& line : linesOf(*text)) lines.push_back(line);
        return lines;
    }
    if (const auto* v = std::get_if<glm::dvec3>(&value)) return three(*v);
    const double x = std::get<double>(value);
    if (x < parameter.range.low || x > parameter.range.high)
        if (const Word* word = parameter.wordFor(x)) return std::string(word->text);
    switch (parameter.kind) {
    case Kind::toggle: return x != 0;
    case Kind::choice: return std::string(parameter.choices[static_cast<std::size_t>(x)]);
    case Kind::count: return static_cast<std::int64_t>(x);
    default: return x;
    }
}

Value valueFromJson(const ParameterInfo& parameter, const Json& json, const JsonPlace& place,
                    std::string_view shownName, std::vector<std::string>& notes)
{
    const Value written = readValue(parameter, json, place);
    const std::optional<Value> legal = nearestLegal(parameter, written);
    if (!legal) throw place.failure("this direction has no length; give it one.");
    if (*legal != written && !isRoundedLimit(parameter, written))
        notes.push_back(changeNote(parameter, shownName, written, *legal));
    return *legal;
}

std::optional<Value> valueFromText(const ParameterInfo& parameter, const std::string& json,
                                   std::vector<std::string>& notes)
{
    const std::string name(parameter.name);
    try {
        const render::JsonDocument document = render::parseJson(json, name, {});
        return valueFromJson(parameter, document.root(), {document, {}}, name, notes);
    } catch (const Failure& failure) {
        notes.emplace_back(failure.what());
        return std::nullopt;
    }
}

Json jsonFromCamera(const render::Camera& camera, const Json& kept)
{
    Json json = Json::object();
    json["eye"] = three(camera.eye);
    json["target"] = three(camera.target);
    json["fov"] = camera.fovY;
    if (camera.lensShift != glm::dvec2(0)) json["lensShift"] = Json::array({camera.lensShift.x, camera.lensShift.y});
    if (kept.is_object()) {
        for (const auto& [key, value] : kept.items()) {
            if (key != "lensShift" && !json.contains(key)) json[key] = value;
        }
    }
    return json;
}

render::Camera cameraFromJson(const Json& json, const JsonPlace& place, std::vector<std::string>& notes)
{
    if (!json.is_object()) wrongType(place, "an object", json);
    render::Camera camera;
    const auto position = [&](const char* key, glm::dvec3& into) {
        if (!json.contains(key)) return;
        const glm::dvec3 written = threeAt(json[key], place.inside(key));
        into = glm::clamp(written, -render::farthestPlace, render::farthestPlace);
        if (into == written) return;
        notes.push_back(std::string("camera.") + key + ' ' + textOf(written) + " -> " + textOf(into) + " (allowed -" +
                        shortestNumber(render::farthestPlace) + " to " + shortestNumber(render::farthestPlace) + " m)");
    };
    position("eye", camera.eye);
    position("target", camera.target);
    if (json.contains("fov")) {
        const double written = numberAt(json["fov"], place.inside("fov"));
        // These are the limits of render::makeView, 1° and 175°.
        const double low = std::numbers::pi / 180;
        camera.fovY = std::clamp(written, low, 175 * low);
        if (camera.fovY != written) {
            std::string note = "camera.fov " + shortestNumber(written);
            ((note += " -> ") += shortestNumber(camera.fovY)) += " (allowed 1 to 175 degrees, in radians)";
            notes.push_back(note);
        }
    }
    if (json.contains("lensShift")) {
        const Json& shift = json["lensShift"];
        if (!shift.is_array() || shift.size() != 2 || !shift[0].is_number() || !shift[1].is_number())
            wrongType(place.inside("lensShift"), "an array of two numbers", shift);
        camera.lensShift = {shift[0].get<double>(), shift[1].get<double>()};
    }
    return camera;
}

}  // namespace vitrine
