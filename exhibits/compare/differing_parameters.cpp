#include "exhibits/compare/differing_parameters.h"

#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/value_text.h"

namespace vitrine::compare {
namespace {

/// Returns the parameter of the same name and kind.
std::optional<std::size_t> twinOf(const ParameterInfo& parameter, const ParameterValues& other)
{
    const std::optional<std::size_t> found = other.table().find(parameter.name);
    return found && other.rows()[*found].kind == parameter.kind ? found : std::nullopt;
}

}  // namespace

std::vector<DifferingParameter> differingParameters(const SceneState& a, const SceneState& b)
{
    std::vector<DifferingParameter> all;
    for (std::size_t s = 0; s < a.values.size(); ++s) {
        const ParameterValues &ofA = a.values[s], &ofB = b.values[s];
        for (std::size_t i = 0; i < ofA.rows().size(); ++i) {
            const ParameterInfo& row = ofA.rows()[i];
            const std::optional<std::size_t> twin = twinOf(row, ofB);
            if (twin && ofB.row(*twin) == ofA.row(i)) continue;
            DifferingParameter differing{s, std::string(row.name), row, ofA.row(i)};
            differing.actsInA = acts(ofA, i);
            if (twin) {
                differing.b = ofB.row(*twin);
                differing.actsInB = acts(ofB, *twin);
            }
            all.push_back(std::move(differing));
        }
        for (std::size_t i = 0; i < ofB.rows().size(); ++i) {
            const ParameterInfo& row = ofB.rows()[i];
            if (!twinOf(row, ofA))
                all.push_back({s, std::string(row.name), row, std::nullopt, ofB.row(i), false, acts(ofB, i)});
        }
    }
    return all;
}

bool copyParameter(const SceneState& from, SceneState& to, std::size_t subject, const std::string& name)
{
    const ParameterValues& source = from.values[subject];
    ParameterValues& target = to.values[subject];
    const std::optional<std::size_t> row = source.table().find(name);
    const std::optional<std::size_t> twin = row ? twinOf(source.rows()[*row], target) : std::nullopt;
    if (!twin) return false;
    target.chooseFile(*twin, source.row(*row));
    return true;
}

std::string valueWithUnit(const ParameterInfo& parameter, const Value& value)
{
    const std::string text = formatValue(parameter, value);
    if (parameter.isWritten()) return text.empty() ? "none" : text;
    const bool isWord = std::holds_alternative<double>(value) && parameter.wordFor(std::get<double>(value));
    if (!parameter.isNumeric() || isWord) return text;
    const std::string unit(info(parameter.unit).symbol);
    return unit.empty() ? text : unit == "°" ? text + unit : text + ' ' + unit;
}

}  // namespace vitrine::compare
