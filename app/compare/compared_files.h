#pragma once

#include "render/image/image.h"

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace vitrine::app {

/// Two picture files of one size, with all their channels.
struct ComparedFiles {
    render::Image reference, test;
};
/// Reads both. Adds sentences about ignored parts of the files to `warnings`. Throws Failure for what is no picture,
/// and for two sizes.
[[nodiscard]] ComparedFiles comparedFiles(const std::string& reference, const std::string& test,
                                          std::vector<std::string>& warnings);

/// Adds the option of the metric flip.
CLI::Option* addPixelsPerDegree(CLI::App&, double& pixelsPerDegree);

}  // namespace vitrine::app
