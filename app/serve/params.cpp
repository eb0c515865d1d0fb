#include "app/serve/params.h"

#include "app/serve/json_rpc.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/text/joined.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <vector>

namespace vitrine::app {
namespace {

using render::Json;

std::string keyOf(const CLI::Option& option)
{
    std::string key = option.get_single_name();
    std::replace(key.begin(), key.end(), '-', '_');
    return key;
}

std::string keysOf(const CLI::App& options)
{
    return joined(options.get_options(), ", ", [](const CLI::Option* option) { return keyOf(*option); });
}

/// Converts a value to the text that would be typed. `separator` separates the elements of a list.
std::string typed(const std::string& key, const Json& value, char separator)
{
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
    if (value.is_number_integer()) return value.dump();
    if (value.is_number()) return render::shortestNumber(value.get<double>());
    if (value.is_array() && !value.empty()) {
        std::string text;
        for (const Json& element : value) {
            if (!element.is_number() && !element.is_string())
                throw Failure(ErrorKind::usage, key + ": a list is of numbers, or of names.");
            text += (text.empty() ? "" : std::string(1, separator)) + typed(key, element, separator);
        }
        return text;
    }
    throw Failure(ErrorKind::usage,
                  key + ": give a text, a number, true or false, or a list of numbers; to leave it as it "
                        "is, leave it out.");
}

/// Converts an object to a list of "name=value"; a list is taken as it is.
std::vector<std::string> typedList(const std::string& key, const Json& value)
{
    std::vector<std::string> texts;
    if (value.is_object()) {
        for (const auto& [name, member] : value.items()) {
            if (name.empty() || name.find('=') != std::string::npos)
                throw Failure(ErrorKind::usage, key + ": \"" + name + "\" is no parameter's name.");
            texts.push_back(name + '=' + typed(key + '.' + name, member, ','));
        }
    } else if (value.is_array()) {
        for (const Json& element : value) texts.push_back(typed(key, element, ','));
    } else {
        texts.push_back(typed(key, value, ','));
    }
    return texts;
}

void take(CLI::Option& option, const std::string& key, const Json& value)
{
    if (option.get_items_expected_max() == 0) {
        if (!value.is_boolean()) throw Failure(ErrorKind::usage, key + ": give true or false.");
        if (value.get<bool>()) option.add_result("true");
    } else if (option.get_items_expected_max() > 1) {
        for (std::string& text : typedList(key, value)) option.add_result(std::move(text));
    } else {
        if (value.is_boolean()) throw Failure(ErrorKind::usage, key + ": this takes a value, not true or false.");
        option.add_result(typed(key, value, key == "size" ? 'x' : ','));
    }
    if (option.count() > 0) option.run_callback();
}

void requireWhole(const CLI::App& options, const std::string& method)
{
    for (const CLI::Option* option : options.get_options()) {
        if (option->get_required() && option->count() == 0)
            throw Failure(ErrorKind::usage, method + ": " + keyOf(*option) + " is missing.");
        if (option->count() == 0) continue;
        for (const CLI::Option* other : option->get_excludes())
            if (other->count() > 0)
                throw Failure(ErrorKind::usage,
                              method + ": give either " + keyOf(*option) + " or " + keyOf(*other) + '.');
    }
}

/// Returns the JSON types that `take` accepts for the option.
Json typesOf(const CLI::Option& option)
{
    if (option.get_items_expected_max() == 0) return "boolean";
    if (option.get_items_expected_max() > 1) return Json::array({"array", "object", "string", "number"});
    return Json::array({"string", "number", "array"});
}

Json schemaOf(const CLI::App& options)
{
    Json properties = Json::object(), required = Json::array(), positional = Json::array();
    for (const CLI::Option* option : options.get_options()) {
        const std::string key = keyOf(*option);
        Json property{{"description", withoutDashes(option->get_description())}, {"type", typesOf(*option)}};
        if (option->get_items_expected_max() > 0) property["x-takes"] = option->get_type_name();
        if (const std::string initial = option->get_default_str(); !initial.empty()) property["x-initial"] = initial;
        properties[key] = std::move(property);
        if (option->get_required()) required.push_back(key);
        if (option->get_positional()) positional.push_back(key);
    }
    Json schema = objectSchema();
    schema["properties"] = std::move(properties);
    schema["required"] = std::move(required);
    schema["x-positional"] = std::move(positional);  // Names that the command line takes without a dash, in order.
    schema["additionalProperties"] = false;
    return schema;
}

}  // namespace

Json objectSchema()
{
    return {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"type", "object"}};
}

void readParams(CLI::App& options, const std::string& method, const Json& params)
{
    options.set_help_flag();
    if (params.is_null()) throw ParamsSchema(schemaOf(options));
    for (const auto& [key, value] : params.items()) {
        const std::vector<CLI::Option*> all = options.get_options();
        const auto found =
            std::find_if(all.begin(), all.end(), [&name = key](const CLI::Option* o) { return keyOf(*o) == name; });
        if (found == all.end()) {
            const std::string keys = keysOf(options);
            throw Failure(ErrorKind::usage,
                          method + " knows no \"" + key + "\"; it takes " + (keys.empty() ? "nothing" : keys) + '.');
        }
        try {
            take(**found, key, value);
        } catch (const CLI::ParseError& error) {
            throw Failure(ErrorKind::usage, withoutDashes(error.what()) + '.');
        }
    }
    requireWhole(options, method);
}

}  // namespace vitrine::app
