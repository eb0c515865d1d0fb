#include "exhibits/framework/time/motion_json.h"

#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace vitrine {
namespace {

using render::Json;
using render::shortestNumber;

constexpr double farthestTime = 1e9;      // Seconds.
constexpr double farthestDistance = 1e4;  // Meters.

/// A number of a motion: its key in files, the motion kinds that use it, and its range.
struct NumberOfMotion {
    const char* name;
    double low, high;
    bool whole;
    bool (*usedBy)(MotionKind);
    double (*get)(const Motion&);
    void (*set)(Motion&, double);
};

constexpr std::array<NumberOfMotion, 7> numbersOfMotion{{
    {"period", shortestPeriod, longestPeriod, false, [](MotionKind kind) { return kind != MotionKind::distance; },
     [](const Motion& m) { return m.period; }, [](Motion& m, double x) { m.period = x; }},
    {"phase", -farthestTime, farthestTime, false, isPeriodic, [](const Motion& m) { return m.phase; },
     [](Motion& m, double x) { m.phase = x; }},
    {"start", -farthestTime, farthestTime, false, [](MotionKind kind) { return kind == MotionKind::ease; },
     [](const Motion& m) { return m.start; }, [](Motion& m, double x) { m.start = x; }},
    {"steps", 2, mostMotionSteps, true, [](MotionKind kind) { return kind == MotionKind::steps; },
     [](const Motion& m) { return static_cast<double>(m.steps); },
     [](Motion& m, double x) { m.steps = static_cast<int>(x); }},
    {"seed", 0, std::numeric_limits<std::uint32_t>::max(), true,
     [](MotionKind kind) { return kind == MotionKind::noise; },
     [](const Motion& m) { return static_cast<double>(m.seed); },
     [](Motion& m, double x) { m.seed = static_cast<std::uint32_t>(x); }},
    {"nearest", 0, farthestDistance, false, [](MotionKind kind) { return kind == MotionKind::distance; },
     [](const Motion& m) { return m.nearest; }, [](Motion& m, double x) { m.nearest = x; }},
    {"farthest", 0, farthestDistance, false, [](MotionKind kind) { return kind == MotionKind::distance; },
     [](const Motion& m) { return m.farthest; }, [](Motion& m, double x) { m.farthest = x; }},
}};

/// Returns the smallest legal value of a number, given the other numbers of the motion: `farthest` is at least
/// `nearest`.
double leastOf(const NumberOfMotion& number, const Motion& motion)
{
    return std::string_view(number.name) == "farthest" ? std::max(number.low, motion.nearest) : number.low;
}

template <std::size_t Count>
std::size_t namedAt(const Json& json, const JsonPlace& place, const std::array<std::string_view, Count>& names,
                    const char* what)
{
    if (!json.is_string()) throw place.failure("this must be text; correct it there.");
    const auto& name = json.get_ref<const std::string&>();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        throw place.failure("unknown " + std::string(what) + " \"" + name + "\"; choose one of " + joined(names) + ".");
    return static_cast<std::size_t>(found - names.begin());
}

/// Numbers that an entry may have.
struct AllowedNumbers {
    double low = 0, high = 0;
    bool whole = false;
};

double numberWithin(const Json& json, const JsonPlace& place, const std::string& shownName,
                    const AllowedNumbers& allowed, std::vector<std::string>& notes)
{
    const auto& [low, high, whole] = allowed;
    if (!json.is_number()) throw place.failure("this must be a number; correct it there.");
    const double written = json.get<double>();
    double x = std::clamp(written, low, high);
    if (whole) x = std::round(x);
    if (x != written)
        notes.push_back(shownName + ' ' + shortestNumber(written) + " -> " + shortestNumber(x) + " (allowed " +
                        shortestNumber(low) + " to " + shortestNumber(high) + (whole ? ", whole numbers only)" : ")"));
    return x;
}

void noteUnknownKeys(const Json& json, const std::string& shownName, std::vector<std::string>& notes)
{
    constexpr std::array<std::string_view, 5> others{"kind", "from", "to", "ease", "heldAt"};
    for (const auto& [key, value] : json.items()) {
        const std::string& name = key;
        const bool known = std::find(others.begin(), others.end(), name) != others.end() ||
                           std::any_of(numbersOfMotion.begin(), numbersOfMotion.end(),
                                       [&](const NumberOfMotion& number) { return name == number.name; });
        if (!known) notes.push_back(shownName + '.' + name + " is not known here; it is left out");
    }
}

}  // namespace

Json jsonFromMotion(const ParameterInfo& parameter, const Motion& motion)
{
    Json json = Json::object();
    json["kind"] = motionKinds[static_cast<std::size_t>(motion.kind)];
    json["from"] = jsonFromValue(parameter, motion.from);
    json["to"] = jsonFromValue(parameter, motion.to);
    if (isEased(motion.kind)) json["ease"] = easeNames[static_cast<std::size_t>(motion.ease)];
    for (const NumberOfMotion& number : numbersOfMotion) {
        if (!number.usedBy(motion.kind)) continue;
        if (number.whole)
            json[number.name] = static_cast<std::int64_t>(number.get(motion));
        else
            json[number.name] = number.get(motion);
    }
    if (motion.heldAt) json["heldAt"] = *motion.heldAt;
    return json;
}

Motion motionFromJson(const ParameterInfo& parameter, const Json& json, const JsonPlace& place,
                      std::string_view shownName, std::vector<std::string>& notes)
{
    const std::string shown(shownName);
    if (!json.is_object()) throw place.failure("this must be an object; correct it there.");
    if (const std::string_view why = whyUnmoved(parameter); !why.empty())
        throw place.failure(std::string(why) + " Take it out.");
    if (!json.contains("kind")) throw place.failure("the key \"kind\" is missing; add it.");
    Motion motion;
    motion.kind = static_cast<MotionKind>(namedAt(json["kind"], place.inside("kind"), motionKinds, "kind of motion"));
    motion.from = motion.to = parameter.initial;
    for (const auto& [key, end] : {std::pair("from", &motion.from), std::pair("to", &motion.to)})
        if (json.contains(key)) *end = valueFromJson(parameter, json[key], place.inside(key), shown + '.' + key, notes);
    if (json.contains("ease"))
        motion.ease = static_cast<Ease>(namedAt(json["ease"], place.inside("ease"), easeNames, "ease"));
    // Numbers that the kind does not use are ignored and would not be written again.
    for (const NumberOfMotion& number : numbersOfMotion)
        if (json.contains(number.name) && number.usedBy(motion.kind))
            number.set(motion, numberWithin(json[number.name], place.inside(number.name), shown + '.' + number.name,
                                            {leastOf(number, motion), number.high, number.whole}, notes));
    if (!isEased(motion.kind)) motion.ease = Motion().ease;
    if (json.contains("heldAt"))
        motion.heldAt = numberWithin(json["heldAt"], place.inside("heldAt"), shown + ".heldAt",
                                     {-farthestTime, farthestTime}, notes);
    noteUnknownKeys(json, shown, notes);
    return motion;
}

std::optional<Motion> motionFromText(const ParameterInfo& parameter, const std::string& json,
                                     std::vector<std::string>& notes)
{
    const std::string name(parameter.name);
    try {
        const render::JsonDocument document = render::parseJson(json, name, {});
        return motionFromJson(parameter, document.root(), {document, {}}, name, notes);
    } catch (const Failure& failure) {
        notes.emplace_back(failure.what());
        return std::nullopt;
    }
}

namespace {

/// Splits the text at its colons.
std::vector<std::string> betweenColons(const std::string& text)
{
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ':')
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

}  // namespace

Motion typedMotion(const ParameterInfo& parameter, const std::string& option, const std::string& text,
                   const std::function<std::optional<Value>(const std::string&)>& parse)
{
    const auto wrong = [&](const std::string& why) { return Failure(ErrorKind::usage, option + ": " + why); };
    if (const std::string_view why = whyUnmoved(parameter); !why.empty()) throw wrong(std::string(why));
    const std::vector<std::string> parts = betweenColons(text);
    const auto kind = std::find(motionKinds.begin(), motionKinds.end(), parts.front());
    if (kind == motionKinds.end())
        throw wrong("unknown kind of motion \"" + parts.front() + '"' +
                    didYouMean(parts.front(), {motionKinds.begin(), motionKinds.end()}) + " give one of " +
                    joined(motionKinds) + '.');
    if (parts.size() < 3)
        throw wrong("give a kind and two values, such as " + parts.front() + ":0.1:0.9, then its options.");
    Motion motion;
    motion.kind = static_cast<MotionKind>(kind - motionKinds.begin());
    for (const auto& [part, end] : {std::pair(1, &motion.from), std::pair(2, &motion.to)}) {
        const std::string& typed = parts[static_cast<std::size_t>(part)];
        const std::optional<Value> value = parse(typed);
        const std::optional<Value> legal = value ? nearestLegal(parameter, *value) : std::nullopt;
        if (!legal) throw wrong("\"" + typed + "\" is not a valid value.");
        *end = *legal;
    }
    std::set<std::string> given;
    for (std::size_t i = 3; i < parts.size(); ++i) {
        const std::size_t equals = parts[i].find('=');
        const std::string name = parts[i].substr(0, equals);
        if (!given.insert(name).second) throw wrong(name + "= is given twice; remove one of them.");
        const std::string typed = equals == std::string::npos ? std::string() : parts[i].substr(equals + 1);
        if (name == "ease" && isEased(motion.kind)) {
            const auto ease = std::find(easeNames.begin(), easeNames.end(), typed);
            if (ease == easeNames.end())
                throw wrong("unknown ease \"" + typed + "\"; give one of " + joined(easeNames) + '.');
            motion.ease = static_cast<Ease>(ease - easeNames.begin());
            continue;
        }
        if (name == "heldAt") {
            const std::optional<double> held = render::parseNumber(typed);
            if (!held || std::abs(*held) > farthestTime) throw wrong("heldAt=" + typed + ": give a number of seconds.");
            motion.heldAt = *held;
            continue;
        }
        const auto number = std::find_if(numbersOfMotion.begin(), numbersOfMotion.end(),
                                         [&](const NumberOfMotion& n) { return name == n.name; });
        if (number == numbersOfMotion.end() || !number->usedBy(motion.kind))
            throw wrong("\"" + name + "\" is not an option of the motion " + parts.front() + ".");
        const std::optional<double> x = render::parseNumber(typed);
        if (!x || !(*x >= number->low && *x <= number->high) || (number->whole && *x != std::round(*x)))
            throw wrong(name + "=" + typed + ": give a " + (number->whole ? "whole " : "") + "number from " +
                        shortestNumber(number->low) + " to " + shortestNumber(number->high) + '.');
        number->set(motion, *x);
    }
    if (motion.kind == MotionKind::distance && motion.farthest < motion.nearest)
        throw wrong("farthest=" + shortestNumber(motion.farthest) +
                    " is before nearest=" + shortestNumber(motion.nearest) + "; give it a number from " +
                    shortestNumber(motion.nearest) + " to " + shortestNumber(farthestDistance) + '.');
    return motion;
}

std::string motionText(const Motion& motion, const std::function<std::string(const Value&)>& format)
{
    std::string text(motionKinds[static_cast<std::size_t>(motion.kind)]);
    for (const Value* end : {&motion.from, &motion.to}) (text += ':') += format(*end);
    if (isEased(motion.kind)) (text += ":ease=") += easeNames[static_cast<std::size_t>(motion.ease)];
    for (const NumberOfMotion& number : numbersOfMotion)
        if (number.usedBy(motion.kind)) (((text += ':') += number.name) += '=') += shortestNumber(number.get(motion));
    if (motion.heldAt) (text += ":heldAt=") += shortestNumber(*motion.heldAt);
    return text;
}

}  // namespace vitrine
