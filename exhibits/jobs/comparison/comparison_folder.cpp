#include "exhibits/jobs/comparison/comparison_folder.h"

#include "exhibits/jobs/comparison/comparison_page.h"
#include "exhibits/jobs/comparison/comparison_table.h"
#include "exhibits/jobs/kit/part_folder.h"
#include "render/files/atomic_write.h"
#include "render/image/image_io.h"

namespace vitrine::jobs {
namespace {

void writeDifferences(const std::filesystem::path& folder, const compare::ComparisonResult& result,
                      double pixelsPerDegree)
{
    const render::Image &a = result.sides[0].picture, &b = result.sides[1].picture;
    const render::Image flip = render::flipMap(a, b, pixelsPerDegree);
    for (const int gain : comparisonGains) {
        const std::string name = std::to_string(gain) + ".png";
        render::writePicture(folder / ("flip-" + name), render::heatMap(flip, 1.0 / gain), render::PictureFormat::png8);
        render::writePicture(folder / ("signed-" + name), render::signedDifference(a, b, gain),
                             render::PictureFormat::png8);
    }
}

}  // namespace

void requireComparisonFolder(const std::filesystem::path& folder)
{
    requireFolderFor(folder, "comparison.json", "a comparison");
}

void writeComparisonFolder(const std::filesystem::path& folder, Subjects subjects,
                           const compare::Comparison& comparison, const ComparisonText& text)
{
    requireComparisonFolder(folder);
    PartFolder part(folder);
    const std::filesystem::path pictures = part.path() / "pictures";
    for (std::size_t side = 0; side < 2; ++side)
        render::writePicture(pictures / (side == 0 ? "a.png" : "b.png"), comparison.result().sides[side].picture,
                             render::PictureFormat::png8, {.preset = text.presets[side]});
    writeDifferences(pictures, comparison.result(), comparison.request().pixelsPerDegree);
    render::atomicWrite(part.path() / "comparison.json", render::writeJson(comparisonJson(subjects, comparison, text)));
    render::atomicWrite(part.path() / "index.html", comparisonPage(subjects, comparison, text));
    part.publish();
}

}  // namespace vitrine::jobs
