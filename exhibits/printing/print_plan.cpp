#include "exhibits/printing/print_plan.h"

#include "exhibits/printing/print_file.h"
#include "exhibits/printing/print_json.h"
#include "render/failure.h"
#include "render/image/picture_stream.h"

#include <cmath>
#include <numbers>

namespace vitrine::printing {
namespace {

constexpr double flipZone = 40;  ///< Degrees; sheets for depth have about 30, sheets for flips about 50.

PrintLayout layoutOf(const ParameterValues& values, const PrintViews* views)
{
    return PrintLayout(printSettings(values, views ? views->count() : values[printTable().views]));
}

/// Returns the values of a chart, which has its own border and views.
ParameterValues chartValues(ParameterValues values)
{
    values.set(printTable().border, 0.0);
    values.set(printTable().compensate, false);
    return values;
}

/// Returns the layout of a chart, with the number of views that it tests.
PrintLayout chartLayout(const ParameterValues& values)
{
    return layoutOf(chartValues(values), nullptr);
}

Chart chartOf(const ParameterValues& values, const PrintLayout& layout)
{
    return {layout, values[printTable().chart], values[printTable().chartSpan]};
}

/// Returns the width of tiles in millimeters; 0: one file.
double tileWidth(const ParameterValues& values)
{
    return values[printTable().direction] == 0 ? values[printTable().tileWidth] * 1000
                                               : 0;  // Only vertical lenses can be cut between.
}

}  // namespace

PrintPlan printPlan(const ParameterValues& values, const PrintViews* views, bool chart,
                    const std::filesystem::path& path)
{
    PrintPlan plan;
    try {
        const PrintLayout layout = chart ? chartLayout(values) : layoutOf(values, views);
        if (chart) static_cast<void>(chartOf(values, layout));
        const std::vector<std::int64_t> cuts = tileCuts(layout, chart ? 0 : tileWidth(values));
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            render::requireStreamSides(path, cuts[i + 1] - cuts[i], layout.height());
        plan.numbers = numbersOf(layout, render::storedDpi(path, layout.settings().dpiX));
        plan.warnings = warningsOf(layout);
        const bool upright = std::abs(values[printTable().direction]) < std::numbers::pi / 4;
        if (!chart && upright && plan.numbers.zoneDegrees > flipZone)
            plan.warnings.emplace_back("This sheet is made for flips, and its lenses stand upright: each eye sees "
                                       "another picture. For a flip, lay them across (direction 90°).");
        if (!chart && views) plan.warnings.insert(plan.warnings.end(), views->notes().begin(), views->notes().end());
        const std::string stretched = !chart && views ? stretchWarning(layout, views->full()) : std::string();
        if (!stretched.empty()) plan.warnings.push_back(stretched);
        plan.bytes =
            static_cast<double>(layout.width()) * static_cast<double>(layout.height()) * 3 * (bitsOf(values) / 8);
        plan.layout = layout;
    } catch (const Failure& failure) {
        plan = {};
        plan.refusal = failure.what();
    }
    return plan;
}

std::shared_ptr<const PrintPreview> printPreview(const ParameterValues& values, std::shared_ptr<const PrintViews> views)
{
    if (views) {
        const PrintLayout layout = layoutOf(values, views.get());
        return std::make_shared<PrintPreview>(layout, std::move(views));
    }
    const PrintLayout layout = chartLayout(values);
    return std::make_shared<PrintPreview>(layout, chartOf(values, layout));
}

std::vector<std::filesystem::path> exportPrint(const ParameterValues& values, const PrintViews* views,
                                               const std::vector<std::string>& sources,
                                               const std::filesystem::path& path, const Progress& progress)
{
    const PrintTable& table = printTable();
    const PrintLayout layout = views ? layoutOf(values, views) : chartLayout(values);
    PrintFile file;
    file.path = path;
    file.bits = bitsOf(values);
    file.compression = values[table.compression];
    file.tileWidth = views ? tileWidth(values) : 0;
    file.threads = interlacingThreads();
    file.progress = progress;
    PrintSources from{sources, sources};
    if (views && !views->scenePreset().empty())
        from.scene = render::parseJson(views->scenePreset(), "the scene").root();
    file.json = render::writeJson(
        printJson(views ? values : chartValues(values), layout, render::storedDpi(path, layout.settings().dpiX), from));
    if (!views) return writeChart(layout, chartOf(values, layout), file);
    file.profile = views->profile();
    if (layout.settings().compensate) {
        const ViewMatrix mixing = viewMixing(layout);
        file.json = withCrossTalk(file.json, crossTalkOf(views->full(), mixing, compensation(mixing)));
    }
    return writePrint(layout, views->full(), file);
}

}  // namespace vitrine::printing
