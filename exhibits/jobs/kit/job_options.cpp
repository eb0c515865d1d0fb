#include "exhibits/jobs/kit/job_options.h"

#include "exhibits/framework/table/expression.h"
#include "exhibits/framework/table/typed_number.h"
#include "exhibits/framework/table/value_text.h"
#include "render/failure.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>

namespace vitrine::jobs {
namespace {

/// Returns "frame-rate" for "frameRate".
std::string kebab(std::string_view name)
{
    std::string text;
    for (const char c : name) {
        if (std::isupper(static_cast<unsigned char>(c)) != 0) text += '-';
        text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return text;
}

/// Returns the parameter with the unit in which the command line reads a plain number.
ParameterInfo asTyped(const ParameterInfo& parameter)
{
    ParameterInfo typed = parameter;
    typed.unit = parameter.given.unit;
    return typed;
}

std::string wordsText(const ParameterInfo& parameter)
{
    std::string text;
    for (const Word& word : parameter.words) text += ", or " + std::string(word.text);
    return text;
}

/// Returns what may be typed for the parameter. Messages show it after "give ".
std::string wanted(const ParameterInfo& parameter)
{
    switch (parameter.kind) {
    case Kind::choice: return "one of " + joined(parameter.choices);
    case Kind::color: return "#rrggbb or r,g,b";
    case Kind::direction: return "x,y,z";
    case Kind::toggle: return "on or off";
    case Kind::real:
    case Kind::count: {
        const Unit unit = parameter.given.unit;
        NumberRange range = rangeOf(parameter, unit);
        range.whole = parameter.kind == Kind::count;
        const std::string si(info(parameter.unit).storedSymbol);
        return rangeText(range) + (unit == Unit::none ? behindNumber(si) : "") + wordsText(parameter);
    }
    case Kind::file: return "a file";
    case Kind::text: return "a text";
    }
    return {};
}

std::string typeOf(const ParameterInfo& parameter)
{
    switch (parameter.kind) {
    case Kind::real:
    case Kind::count: {
        std::string type = typeName(rangeOf(parameter, parameter.given.unit));
        for (const Word& word : parameter.words) (type += '|') += word.text;
        return type;
    }
    case Kind::choice: return joined(parameter.choices, "|");
    case Kind::color: return "COLOR";
    case Kind::direction: return "X,Y,Z";
    case Kind::file: return "FILE";
    case Kind::text: return "TEXT";
    case Kind::toggle: break;
    }
    return {};
}

}  // namespace

std::vector<JobOption> optionsOf(const Parameters& table)
{
    std::vector<JobOption> options;
    std::string_view tuple;
    for (std::size_t i = 0; i < table.rows().size(); ++i) {
        const ParameterInfo& parameter = table.rows()[i];
        const GivenAs& given = parameter.given;
        if (!given.tuple.empty() && given.tuple == tuple) {
            options.back().parameters.push_back(i);
            if (parameter.isWritten()) options.back().words = 2;
            continue;
        }
        tuple = given.tuple;
        JobOption option;
        const std::string name = !given.option.empty() ? std::string(given.option)
                                 : tuple.empty()       ? kebab(parameter.name)
                                                       : kebab(tuple);
        option.name = given.positional ? std::string(parameter.name) : "--" + name;
        option.parameters = {i};
        option.positional = given.positional;
        option.mustBeGiven = given.mustBeGiven;
        option.several = parameter.several;
        option.isFlag = parameter.kind == Kind::toggle;
        option.key = tuple.empty() ? parameter.name : tuple;
        options.push_back(std::move(option));
    }
    return options;
}

const JobOption& optionOf(const std::vector<JobOption>& options, std::size_t parameter)
{
    const auto gives = [&](const JobOption& option) {
        return std::find(option.parameters.begin(), option.parameters.end(), parameter) != option.parameters.end();
    };
    const auto found = std::find_if(options.begin(), options.end(), gives);
    assert(found != options.end());
    return *found;
}

std::string withoutFlag(const JobOption& option)
{
    return "--no-" + option.name.substr(2);
}

std::string typeText(const Parameters& table, const JobOption& option)
{
    std::string text;
    for (const std::size_t i : option.parameters) {
        const ParameterInfo& parameter = table.rows()[i];
        if (option.parameters.size() == 1) return typeOf(parameter);
        if (!text.empty()) text += parameter.isWritten() ? ' ' : parameter.given.separator;
        std::string name = kebab(parameter.name);
        // "COLUMNSxROWS FILE" for the members quiltColumns, quiltRows and quiltFile of the tuple quilt.
        if (option.words > 1) name = name.substr(kebab(option.key).size() + 1);
        std::transform(name.begin(), name.end(), std::back_inserter(text),
                       [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    }
    return text;
}

std::string initialText(const Parameters& table, const JobOption& option)
{
    if (option.mustBeGiven || option.isFlag) return {};
    const std::vector<std::string> words = typedWords(option, table.initial());
    return words.empty() || option.words > 1 ? std::string() : words.front();
}

std::string exampleText(const Parameters& table, const JobOption& option)
{
    const std::string word = typedWords(option, table.initial()).front();
    if (option.words == 1) return word;
    const std::string_view endings = table.rows()[option.parameters.back()].extensions;
    return option.name + ' ' + word + ' ' + option.key + '.' + std::string(endings.substr(0, endings.find(' ')));
}

std::string helpText(const Parameters& table, const JobOption& option)
{
    const ParameterInfo& first = table.rows()[option.parameters.front()];
    std::string text(first.help);
    const Unit typed = first.given.unit;
    const std::string_view unit = typed == Unit::none ? info(first.unit).storedSymbol : info(typed).symbol;
    if (first.isNumeric() && !unit.empty()) text += " Unit: " + std::string(unit) + '.';
    return text;
}

std::string typedText(const ParameterInfo& parameter, const Value& value)
{
    if (const auto* x = std::get_if<double>(&value))
        if (const Word* word = parameter.wordFor(*x)) return std::string(word->text);
    return formatValue(asTyped(parameter), value);
}

std::vector<std::string> typedWords(const JobOption& option, const ParameterValues& values)
{
    const std::size_t first = option.parameters.front();
    if (option.several) return linesOf(std::get<std::string>(values.row(first)));
    std::string text;
    std::vector<std::string> written;
    for (const std::size_t i : option.parameters) {
        const ParameterInfo& parameter = values.rows()[i];
        if (option.words > 1 && parameter.isWritten()) {
            written.push_back(typedText(parameter, values.row(i)));
            continue;
        }
        if (i != first) text += parameter.given.separator;
        text += typedText(parameter, values.row(i));
    }
    if (text.empty()) return {};
    written.insert(written.begin(), text);
    return written;
}

Value readWord(const std::string& option, const ParameterInfo& parameter, const std::string& word)
{
    const auto refuse = [&]() -> Failure {
        if (parameter.isNumeric())
            return {ErrorKind::usage, option + " \"" + word + "\": give " + wanted(parameter) + '.'};
        if (parameter.kind == Kind::choice)
            return {ErrorKind::usage, noSuchChoice(option, word, {parameter.choices.begin(), parameter.choices.end()})};
        return {ErrorKind::usage, option + ' ' + word + ": give " + wanted(parameter) + '.'};
    };
    std::optional<Value> value;
    if (parameter.isNumeric()) {
        const bool isWord =
            std::any_of(parameter.words.begin(), parameter.words.end(), [&](const Word& w) { return w.text == word; });
        if (const auto plain = evaluate(word, parameter.given.unit); plain && !isWord) {
            // A value outside of the range that has a word is typed as that word: "auto", not 0.
            if (parameter.wordFor(*plain) && !(*plain >= parameter.range.low && *plain <= parameter.range.high))
                throw refuse();
            value = *plain;
        } else
            value = parseValue(parameter, word);
        if (!value) refuseDecimalComma(option, word);
    } else {
        if (word.find('\n') != std::string::npos) throw refuse();
        value = parseValue(parameter, word);
    }
    if (!value) throw refuse();
    if (const auto* x = std::get_if<double>(&*value)) {
        // A limit that was typed in another unit may be a rounding error away from the one in the table.
        const auto near = [&](double limit) { return std::abs(*x - limit) <= 1e-12 * std::abs(limit); };
        const Range& range = parameter.range;
        const bool legal = (*x >= range.low && *x <= range.high) || near(range.low) || near(range.high);
        const bool whole = parameter.kind == Kind::real || *x == std::round(*x);
        if (!parameter.wordFor(*x) && !(legal && whole)) throw refuse();
    }
    return nearestLegal(parameter, *value).value();
}

}  // namespace vitrine::jobs
