#include "exhibits/museum/assignment.h"

#include "exhibits/framework/table/expression.h"
#include "exhibits/framework/table/typed_number.h"
#include "exhibits/framework/table/value_text.h"
#include "exhibits/framework/time/motion_json.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/text/nearest_word.h"

namespace vitrine {

std::vector<std::string> namesOf(const Museum& museum)
{
    std::vector<std::string> names;
    for (const SceneObject* subject : museum.subjects()) names.emplace_back(subject->name());
    return names;
}

namespace assignments {
namespace {

/// Assignment "exhibit.name=value".
struct Assignment {
    std::size_t owner = 0;
    std::string name, text;
};
/// Parses an assignment. `option` is the option that takes it, `such` an example for the message.
Assignment assignmentOf(const Museum& museum, std::size_t subject, const std::string& assignment,
                        const std::string& option = "--set", const char* such = "morph=0.3")
{
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0)
        throw Failure(ErrorKind::usage,
                      option + " \"" + assignment + "\": give name=value, such as " + option + ' ' + such + '.');
    const std::string name = assignment.substr(0, equals), text = assignment.substr(equals + 1);
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos) return {subject, name, text};
    const auto owner = museum.find(name.substr(0, dot));
    if (!owner)
        throw Failure(ErrorKind::usage, option + ' ' + name + ": there is no exhibit \"" + name.substr(0, dot) + '"' +
                                            didYouMean(name.substr(0, dot), namesOf(museum)) +
                                            " `vitrine list` names them.");
    return {*owner, name.substr(dot + 1), text};
}

/// Reads the files that values name, which may add parameters, and updates the tables. Throws Failure (ErrorKind::file)
/// if one cannot be read.
void readTables(const Museum& museum, SceneState& sceneState, std::vector<std::string>& notes)
{
    TabledSceneState read = museum.readTables(sceneState);
    if (!read.unreadable.empty()) throw Failure(ErrorKind::file, read.unreadable.front());
    sceneState = std::move(read.sceneState);
    notes.insert(notes.end(), read.notes.begin(), read.notes.end());
}

/// Returns the index of the named parameter in its table.
std::size_t parameterNamed(const Museum& museum, const SceneState& sceneState, const Assignment& assignment,
                           const std::string& option)
{
    const Parameters& table = sceneState.values[assignment.owner].table();
    const auto row = table.find(assignment.name);
    if (!row) {
        std::vector<std::string> names;
        for (const ParameterInfo& info : sceneState.values[assignment.owner].rows()) names.emplace_back(info.name);
        throw Failure(ErrorKind::usage, option + ' ' + assignment.name + ": " +
                                            std::string(museum.subject(assignment.owner).name()) +
                                            " has no parameter of that name" + didYouMean(assignment.name, names) +
                                            " `vitrine list --json` names them.");
    }
    return *row;
}

/// Formats a value like `typed`: plain numbers in SI units, others in the parameter's displayed unit.
std::string valueAsTyped(const ParameterInfo& parameter, const Value& value, const std::string& typed)
{
    const auto* number = std::get_if<double>(&value);
    if (!number || !parameter.isNumeric()) return formatValue(parameter, value);
    const bool isPlain = evaluate(typed, Unit::none).has_value();
    return render::shortestNumber(isPlain ? *number : shown(*number, parameter.unit)) +
           behindNumber(isPlain ? info(parameter.unit).storedSymbol : info(parameter.unit).symbol);
}

/// Makes the assignment, as described for `applySet`.
void assign(const Museum& museum, SceneState& sceneState, const Assignment& assignment, std::vector<std::string>& notes)
{
    const auto& [owner, name, text] = assignment;
    ParameterValues& values = sceneState.values[owner];
    const std::size_t row = parameterNamed(museum, sceneState, assignment, "--set");
    const ParameterInfo& info = values.rows()[row];
    const std::optional<Value> value = optionValue(info, text);
    if (!value && info.isNumeric()) refuseDecimalComma("--set " + name, text);
    if (!value || !nearestLegal(info, *value))
        throw Failure(ErrorKind::usage, "--set " + name + ": \"" + text + "\" is not a value for it" +
                                            didYouMean(text, {info.choices.begin(), info.choices.end()}) + " give " +
                                            whatItTakes(info, text) + '.');
    values.setMotion(row, std::nullopt);  // An explicit value ends an animation of the preset.
    if (!values.chooseFile(row, *value) && info.kind != Kind::direction)
        notes.push_back(
            "--set " + name + ": " + text + " was changed to " + valueAsTyped(info, values.row(row), text) +
            ", the nearest allowed value (" + whatItTakes(info, text) +
            (info.unit == Unit::degree && evaluate(text, Unit::none) ? "; degrees are written " + text + "deg" : "") +
            ").");
}

}  // namespace
}  // namespace assignments

void applySets(const Museum& museum, SceneState& sceneState, std::size_t subject,
               const std::vector<std::string>& assignments, std::vector<std::string>& notes)
{
    std::vector<assignments::Assignment> rest;
    for (const std::string& text : assignments) {
        assignments::Assignment a = assignments::assignmentOf(museum, subject, text);
        const auto row = sceneState.values[a.owner].table().find(a.name);
        if (row && sceneState.values[a.owner].rows()[*row].addsParameters)
            assignments::assign(museum, sceneState, a, notes);
        else
            rest.push_back(std::move(a));
    }
    assignments::readTables(museum, sceneState, notes);
    for (const assignments::Assignment& a : rest) assignments::assign(museum, sceneState, a, notes);
}

void applySet(const Museum& museum, SceneState& sceneState, std::size_t subject, const std::string& assignment,
              std::vector<std::string>& notes)
{
    assignments::assign(museum, sceneState, assignments::assignmentOf(museum, subject, assignment), notes);
}

NamedParameter namedParameter(const Museum& museum, const SceneState& sceneState, std::size_t subject,
                              const std::string& name, const std::string& option)
{
    const assignments::Assignment a = assignments::assignmentOf(museum, subject, name + '=', option);
    return {a.owner, assignments::parameterNamed(museum, sceneState, a, option)};
}

void applyMotion(const Museum& museum, SceneState& sceneState, std::size_t subject, const std::string& assignment)
{
    const assignments::Assignment a =
        assignments::assignmentOf(museum, subject, assignment, "--animate", "morph=sine:0.1:0.9:period=4");
    const std::size_t row = assignments::parameterNamed(museum, sceneState, a, "--animate");
    ParameterValues& values = sceneState.values[a.owner];
    const ParameterInfo& info = values.rows()[row];
    values.setMotion(row, typedMotion(info, "--animate " + a.name, a.text,
                                      [&info](const std::string& text) { return optionValue(info, text); }));
}

}  // namespace vitrine
