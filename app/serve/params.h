#pragma once

#include "render/files/strict_json.h"

#include <exception>
#include <string>
#include <utility>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Fills the options of a command from the params of the method of the same name, with all their checks, so that
/// command line and service read alike. Keys are option names with underscores for dashes. Flags take true and false;
/// "set", "animate" and similar ones take objects ({"morph": 0.3, "hall.exposure": "1"}) or lists of "name=value".
/// "eye" and similar ones take lists of numbers, "size" a list of two. Throws Failure (ErrorKind::usage) naming the
/// key.
///
/// Null params ask for a description in place of the call: throws ParamsSchema.
void readParams(CLI::App& options, const std::string& method, const render::Json& params);

/// JSON Schema of the params of a method, thrown in place of its call.
struct ParamsSchema : std::exception {
    explicit ParamsSchema(render::Json schema) : json(std::move(schema)) {}
    render::Json json;
};
/// Returns the schema of an object whose members are not listed.
[[nodiscard]] render::Json objectSchema();

}  // namespace vitrine::app
