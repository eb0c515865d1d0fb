#pragma once

#include "render/files/strict_json.h"

#include <string>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Fills the options of a command from the params of the method of that name, with all their checks: one way of reading
/// for the command line and the service. Keys are the options' names with underscores for dashes; flags take true and
/// false; "set", "animate" and the like take objects ({"morph": 0.3, "hall.exposure": "1"}) or lists of "name=value";
/// "eye" and the like lists of numbers, "size" a list of two. Throws Failure (Blame::usage) naming the key.
void readParams(CLI::App& options, const std::string& method, const render::Json& params);

}  // namespace vitrine::app
