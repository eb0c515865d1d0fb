#include "exhibits/jobs/kit/given_values.h"

#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/condition.h"
#include "exhibits/framework/table/value_text.h"
#include "render/failure.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

namespace vitrine::jobs {
namespace {

using render::Json;

/// Splits the text at each separator. Other signs for "times" separate as "x" does.
std::vector<std::string> splitAt(char separator, std::string text)
{
    if (separator == 'x') {
        constexpr std::string_view times = "×";
        std::replace(text.begin(), text.end(), 'X', 'x');
        for (std::size_t at = text.find(times); at != std::string::npos; at = text.find(times, at))
            text.replace(at, times.size(), "x");
    }
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

/// Returns the options that must be given for the condition to hold: "--palette own", "--border".
std::string typedCondition(const Condition& condition, const ParameterValues& values,
                           const std::vector<JobOption>& options)
{
    if (!condition.parts.empty()) {
        std::string text;
        for (const Condition& part : condition.parts) {
            const std::string one = typedCondition(part, values, options);
            if (condition.test == Condition::Test::all && !one.empty() && !holds(part, values)) return one;
            if (condition.test == Condition::Test::any) text += (text.empty() ? "" : " or ") + one;
        }
        return text;
    }
    const std::size_t i = values.table().find(condition.row).value();
    const ParameterInfo& parameter = values.rows()[i];
    const JobOption& option = optionOf(options, i);
    if (parameter.actsWhen && !acts(values, i)) return typedCondition(*parameter.actsWhen, values, options);
    if (option.isFlag) {
        const bool on = (condition.values.front() != 0) == (condition.test == Condition::Test::among);
        return on ? option.name : withoutFlag(option);
    }
    if (condition.test == Condition::Test::given) return option.name;
    const std::string value = typedText(parameter, condition.values.front());
    if (condition.test == Condition::Test::above) return option.name + " above " + value;
    if (condition.test == Condition::Test::differs) return option.name + " other than " + value;
    return option.name + ' ' + value;
}

}  // namespace

GivenValues::GivenValues(const Parameters& table) : values_(table), options_(optionsOf(table)) {}

GivenValues::GivenValues(ParameterValues document)
    : values_(std::move(document)), options_(optionsOf(values_.table())), onDocument_(true)
{
}

void GivenValues::give(std::size_t parameter, const Value& value, const std::string& as)
{
    values_.setParameter(parameter, value);
    given_[parameter] = as;
}

void GivenValues::type(const JobOption& option, const std::vector<std::string>& words)
{
    typed_ = true;
    const std::size_t first = option.parameters.front();
    const ParameterInfo& parameter = values_.rows()[first];
    if (option.several) {
        for (const std::string& word : words) static_cast<void>(readWord(option.name, parameter, word));
        give(first, joined(words, "\n"), option.name);
        return;
    }
    assert(!words.empty());
    if (option.parameters.size() == 1) {
        give(first, readWord(option.name, parameter, words.front()), option.name);
        return;
    }
    std::vector<std::string> parts = splitAt(parameter.given.separator, words.front());
    parts.insert(parts.end(), words.begin() + 1, words.end());
    if (parts.size() != option.parameters.size())
        throw Failure(ErrorKind::usage, option.name + " \"" + words.front() + "\": give " +
                                            typeText(values_.table(), option) + ", such as " +
                                            exampleText(values_.table(), option) + '.');
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const ParameterInfo& part = values_.rows()[option.parameters[i]];
        give(option.parameters[i], readWord(option.name + ' ' + words.front(), part, parts[i]), option.name);
    }
}

void GivenValues::turn(const JobOption& option, bool on)
{
    typed_ = true;
    give(option.parameters.front(), on ? 1.0 : 0.0, on ? option.name : withoutFlag(option));
}

void GivenValues::read(const Json& object, const JsonPlace& place, std::vector<std::string>& notes)
{
    if (!object.is_object()) throw place.failure("the values of a job must be an object; correct it there.");
    for (const auto& [key, json] : object.items()) {
        const auto named = [&key = key](const JobOption& option) { return option.key == key; };
        const auto option = std::find_if(options_.begin(), options_.end(), named);
        const JsonPlace inside = place.inside(key);
        if (option == options_.end()) {
            std::vector<std::string> keys;
            for (const JobOption& each : options_) keys.push_back(each.key);
            throw inside.failure("there is no such parameter" + didYouMean(key, keys) + " remove it there.");
        }
        const std::vector<std::size_t>& parameters = option->parameters;
        if (parameters.size() == 1) {
            give(parameters[0], valueFromJson(values_.rows()[parameters[0]], json, inside, key, notes), key);
            continue;
        }
        if (!json.is_array() || json.size() != parameters.size())
            throw inside.failure("this must be an array of " + std::to_string(parameters.size()) +
                                 " values; correct it there.");
        for (std::size_t i = 0; i < parameters.size(); ++i)
            give(parameters[i], valueFromJson(values_.rows()[parameters[i]], json[i], inside, key, notes), key);
    }
}

ParameterValues GivenValues::withImplied() const
{
    ParameterValues values = values_;
    std::map<std::size_t, std::pair<double, std::string>> implied;
    for (const auto& [parameter, option] : given_)
        for (const Implication& implication : values.rows()[parameter].given.implies) {
            const std::size_t target = values.table().find(implication.parameter).value();
            if (given_.count(target) != 0) continue;
            const auto [known, isNew] = implied.try_emplace(target, implication.value, option);
            if (!isNew && known->second.first != implication.value)
                throw Failure(ErrorKind::usage,
                              known->second.second + " and " + option + " exclude each other; give one of them.");
            values.setParameter(target, implication.value);
        }
    return values;
}

void GivenValues::refuseMissing(const std::string& command) const
{
    if (onDocument_) return;
    for (const JobOption& option : options_)
        if (option.mustBeGiven && given_.count(option.parameters.front()) == 0)
            throw Failure(ErrorKind::usage,
                          '`' + command + "` needs " + option.name + "; `" + command + " --help` says what it is.");
}

void GivenValues::refuseUseless(const ParameterValues& values) const
{
    if (!typed_) return;
    for (const auto& [parameter, option] : given_) {
        if (acts(values, parameter)) continue;
        const std::string missing = typedCondition(*values.rows()[parameter].actsWhen, values, options_);
        throw Failure(ErrorKind::usage,
                      option + " has no effect without " + missing + "; leave it out, or give that too.");
    }
}

ParameterValues GivenValues::settled(const std::string& command) const
{
    refuseMissing(command);
    ParameterValues values = withImplied();
    refuseUseless(values);
    return values;
}

Json jsonOf(const ParameterValues& values)
{
    Json json = Json::object();
    for (const JobOption& option : optionsOf(values.table())) {
        Json members = Json::array();
        for (const std::size_t i : option.parameters) members.push_back(jsonFromValue(values.rows()[i], values.row(i)));
        json[option.key] = option.parameters.size() == 1 ? members.front() : members;
    }
    return json;
}

std::vector<std::string> wordsOf(const ParameterValues& values)
{
    const std::vector<JobOption> options = optionsOf(values.table());
    const auto isGiven = [&](const JobOption& option) {
        const auto differs = [&](std::size_t i) { return !values.isInitial(i); };
        const bool any = std::any_of(option.parameters.begin(), option.parameters.end(), differs);
        return acts(values, option.parameters.front()) && (any || option.mustBeGiven);
    };
    std::vector<bool> given;
    for (const JobOption& option : options) given.push_back(isGiven(option));
    // If two given values imply different values of a parameter, that parameter must be given, too.
    for (std::size_t k = 0; k < options.size(); ++k)
        for (const std::size_t i : options[k].parameters)
            for (const Implication& implied : values.rows()[i].given.implies) {
                if (!given[k]) continue;
                const std::size_t target = values.table().find(implied.parameter).value();
                if (values.row(target) == Value(implied.value)) continue;
                given[static_cast<std::size_t>(&optionOf(options, target) - options.data())] = true;
            }
    std::vector<std::string> words, positional;
    for (std::size_t k = 0; k < options.size(); ++k) {
        const JobOption& option = options[k];
        const std::size_t first = option.parameters.front();
        if (!given[k]) continue;
        if (option.isFlag) {
            words.push_back(std::get<double>(values.row(first)) != 0 ? option.name : withoutFlag(option));
            continue;
        }
        for (const std::string& word : typedWords(option, values)) {
            if (option.positional)
                positional.push_back(word);
            else
                words.push_back(option.name + '=' + word);
        }
    }
    positional.insert(positional.end(), words.begin(), words.end());
    return positional;
}

}  // namespace vitrine::jobs
