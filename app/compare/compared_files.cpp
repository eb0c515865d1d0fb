#include "app/compare/compared_files.h"

#include "app/kit/number_option.h"
#include "render/failure.h"
#include "render/image/image_io.h"

#include <CLI/CLI.hpp>

namespace vitrine::app {
namespace {

render::Image comparedFile(const std::string& file, std::vector<std::string>& warnings)
{
    std::vector<std::string> ignored;
    render::Image image = render::readImage(file, {}, &ignored);
    for (const std::string& warning : ignored) warnings.push_back(file + ": " + warning);
    return image;
}

}  // namespace

ComparedFiles comparedFiles(const std::string& reference, const std::string& test, std::vector<std::string>& warnings)
{
    ComparedFiles files{comparedFile(reference, warnings), comparedFile(test, warnings)};
    const auto& [a, b] = files;
    if (a.width != b.width || a.height != b.height)
        throw Failure(ErrorKind::usage, reference + " is " + std::to_string(a.width) + " × " +
                                            std::to_string(a.height) + " pixels and " + test + " " +
                                            std::to_string(b.width) + " × " + std::to_string(b.height) +
                                            "; give two pictures of one size.");
    return files;
}

CLI::Option* addPixelsPerDegree(CLI::App& command, double& pixelsPerDegree)
{
    return addNumber(command, "--pixels-per-degree", pixelsPerDegree, {1, 1000},
                     "Pixels per degree of the viewer's field of view, for the metric flip");
}

}  // namespace vitrine::app
