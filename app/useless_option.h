#pragma once

#include <string>

namespace CLI {
class App;
}

namespace vitrine::app {

struct PictureOptions;

/// Refuses an option that was given, where it changes nothing without `other` ("--method guard") and that is not given.
/// Throws Failure (Blame::usage) naming both.
void refuseWithout(const CLI::App&, const std::string& option, bool acts, const std::string& other);

/// The same where it changes nothing about `what`, which has a German text that follows "bei".
void refuseOn(const CLI::App&, const std::string& option, bool idle, const std::string& what);

/// The same for the options of all commands that draw a scene.
void refuseUselessSceneOptions(const CLI::App&, const PictureOptions&);

}  // namespace vitrine::app
