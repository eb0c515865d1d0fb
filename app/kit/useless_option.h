#pragma once

#include <string>

namespace CLI {
class App;
}

namespace vitrine::app {

struct PictureOptions;

/// Refuses a given option that has no effect without `other` ("--method guard"). `acts`: it has an effect. Throws
/// Failure (ErrorKind::usage) naming both.
void refuseWithout(const CLI::App&, const std::string& option, bool acts, const std::string& other);

/// Refuses a given option that has no effect on `what`, if `idle`. `what` needs a German text that follows "bei".
void refuseOn(const CLI::App&, const std::string& option, bool idle, const std::string& what);

/// Refuses options without effect, for all commands that draw a scene.
void refuseUselessSceneOptions(const CLI::App&, const PictureOptions&);

}  // namespace vitrine::app
