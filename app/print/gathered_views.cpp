#include "app/print/gathered_views.h"

#include "app/print/rendered_views.h"
#include "app/progress.h"
#include "exhibits/printing/view_files.h"
#include "render/failure.h"
#include "render/image/image_io.h"
#include "render/image/picture_stream.h"

#include <set>
#include <utility>

namespace vitrine::app {
namespace {

namespace fs = std::filesystem;

printing::SequenceSettings sequenceOf(const ViewOptions& options)
{
    return {options.every, options.pingPong, options.count};
}

GatheredViews viewsOfFiles(const ViewOptions& options, const LayoutOf& layoutOf)
{
    const std::vector<fs::path> files = printing::viewFiles(options.files);
    const std::vector<std::size_t> chosen = printing::chosenViews(files.size(), sequenceOf(options));
    (void)layoutOf(static_cast<int>(chosen.size()));
    GatheredViews result;
    ProgressLine line("reading views");
    std::set<std::pair<int, int>> sizes;
    for (const std::size_t i : chosen) {
        if (!line.show(static_cast<double>(result.sources.size()) / static_cast<double>(chosen.size())))
            throw Failure(Blame::usage, "Reading the views was stopped; nothing was written.");
        const render::Image image = render::readImage(files[i], {.canceled = StopSignal::stopped});
        sizes.emplace(image.width, image.height);
        result.views.add(image);
        result.sources.push_back(files[i].filename().string());
    }
    if (sizes.size() > 1) result.notes.emplace_back("The views differ in size; each is scaled to the print.");
    result.profile = render::embeddedProfile(files[chosen.front()]);
    return result;
}

GatheredViews viewsOfQuilt(const ViewOptions& options, const LayoutOf& layoutOf)
{
    const glm::ivec2 grid = parseSize("--quilt", options.quilt[0]);
    if (grid.x > 1000 || grid.y > 1000)
        throw Failure(Blame::usage,
                      "--quilt " + options.quilt[0] + ": give columns x rows, such as --quilt 8x6 quilt.png.");
    const std::vector<std::size_t> chosen =
        printing::chosenViews(static_cast<std::size_t>(grid.x * grid.y), sequenceOf(options));
    (void)layoutOf(static_cast<int>(chosen.size()));
    const fs::path file = options.quilt[1];
    const render::Image quilt = render::readImage(file, {.canceled = StopSignal::stopped});
    const auto order =
        options.quiltOrder == "top-left" ? printing::QuiltOrder::topLeft : printing::QuiltOrder::bottomLeft;
    GatheredViews result;
    for (const std::size_t k : chosen) {
        result.views.add(printing::viewOfQuilt(quilt, grid.x, grid.y, static_cast<int>(k), order));
        result.sources.push_back(file.filename().string() + ", view " + std::to_string(k));
    }
    result.profile = render::embeddedProfile(file);
    return result;
}

}  // namespace

GatheredViews gatherViews(const ViewOptions& options, const LayoutOf& layoutOf)
{
    const int ways = static_cast<int>(!options.files.empty()) + static_cast<int>(!options.quilt.empty()) +
                     static_cast<int>(!options.scene.subject.empty());
    if (ways == 0)
        throw Failure(Blame::usage, "There are no views; give pictures with --views or --quilt, or an --exhibit.");
    if (ways > 1)
        throw Failure(Blame::usage, "The views come from one place: give only one of --views, --quilt and --exhibit.");
    if (!options.scene.subject.empty()) return renderedViews(options, layoutOf);
    return options.quilt.empty() ? viewsOfFiles(options, layoutOf) : viewsOfQuilt(options, layoutOf);
}

}  // namespace vitrine::app
