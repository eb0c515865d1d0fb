#include "app/compare/comparison_folder.h"

#include "app/compare/comparison_page.h"
#include "app/kit/part_folder.h"
#include "exhibits/framework/table/preset_values.h"
#include "render/files/atomic_write.h"
#include "render/image/image_io.h"
#include "render/version.h"

#include <cmath>

namespace vitrine::app {
namespace {

using render::Json;

Json sideJson(const PassSide& side)
{
    static constexpr std::array<const char*, 3> states{"ran", "skipped", "absent"};
    return Json{{"state", states.at(static_cast<std::size_t>(side.state))},
                {"ms", side.milliseconds < 0 ? Json(nullptr) : Json(side.milliseconds)},
                {"why", side.why}};
}

Json timeJson(const ComparedSide& side)
{
    if (!side.time) return nullptr;
    return Json{
        {"median", side.time->median}, {"low", side.time->low}, {"high", side.time->high}, {"runs", side.time->runs}};
}

Json parametersJson(Subjects subjects, const std::vector<DifferingParameter>& rows)
{
    Json all = Json::array();
    for (const DifferingParameter& row : rows)
        all.push_back(Json{{"exhibit", std::string(subjects[row.subject]->name())},
                           {"name", row.name},
                           {"a", row.a ? jsonFromValue(row.info, *row.a) : Json(nullptr)},
                           {"b", row.b ? jsonFromValue(row.info, *row.b) : Json(nullptr)},
                           {"actsInA", row.actsInA},
                           {"actsInB", row.actsInB}});
    return all;
}

void writeDifferences(const std::filesystem::path& folder, const ComparisonResult& result, double pixelsPerDegree)
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

Json comparisonJson(Subjects subjects, const Comparison& comparison, const ComparisonText& text)
{
    const ComparisonRequest& request = comparison.request();
    const ComparisonResult& result = comparison.result();
    Json errors = Json::object(), passes = Json::array(), counters = Json::object();
    for (const auto& [metric, error] : result.errors)
        errors[std::string(toString(metric))] = std::isfinite(error) ? Json(error) : Json("infinite");
    for (const PassCost& cost : result.passes)
        passes.push_back(
            Json{{"name", cost.name}, {"kind", toString(cost.work)}, {"a", sideJson(cost.a)}, {"b", sideJson(cost.b)}});
    for (const CounterCost& cost : result.counters)
        counters[cost.name] =
            Json{{"a", cost.a ? Json(*cost.a) : Json(nullptr)}, {"b", cost.b ? Json(*cost.b) : Json(nullptr)}};
    const FrameRequest& frame = request.frame;
    return Json{
        {"format", "vitrine-comparison"},
        {"version", 1},
        {"app", render::programVersion()},
        {"a", text.names[0]},
        {"b", text.names[1]},
        {"size", Json::array({frame.raster.size.x, frame.raster.size.y})},
        {"samples", Json::array({request.samples[0], request.samples[1]})},
        {"time", frame.time},
        {"seed", frame.seed},
        {"camera", jsonFromCamera(frame.camera, Json::object())},
        {"machine", text.machine},
        {"clock", Json{{"method", result.sides[0].report.clock}, {"trusted", result.sides[0].report.clockTrusted}}},
        {"errors", errors},
        {"rows", parametersJson(subjects, result.rows)},
        {"ms", Json{{"a", timeJson(result.sides[0])}, {"b", timeJson(result.sides[1])}}},
        {"passes", passes},
        {"counters", counters}};
}

void writeComparisonFolder(const std::filesystem::path& folder, Subjects subjects, const Comparison& comparison,
                           const ComparisonText& text)
{
    requireComparisonFolder(folder);
    PartFolder part(folder);
    const std::filesystem::path pictures = part.path() / "pictures";
    const ComparisonResult& result = comparison.result();
    for (std::size_t side = 0; side < 2; ++side)
        render::writePicture(pictures / (side == 0 ? "a.png" : "b.png"), result.sides[side].picture,
                             render::PictureFormat::png8, {.preset = text.presets[side]});
    writeDifferences(pictures, result, comparison.request().pixelsPerDegree);
    render::atomicWrite(part.path() / "comparison.json", render::writeJson(comparisonJson(subjects, comparison, text)));
    render::atomicWrite(part.path() / "index.html", comparisonPage(subjects, comparison, text));
    part.publish();
}

}  // namespace vitrine::app
