#include "exhibits/printing/print_plan.h"

#include "exhibits/framework/table/value_text.h"
#include "exhibits/printing/print_json.h"
#include "exhibits/printing/print_marks.h"
#include "exhibits/printing/soft_proof.h"
#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/image/picture_stream.h"

#include <cmath>
#include <numbers>

namespace vitrine::printing {
namespace {

constexpr std::size_t mostProfileBytes = 64U << 20U;
constexpr double flipZone = 40;  ///< Degrees; sheets for depth have about 30, sheets for flips about 50.

PrintLayout layoutOf(const ParameterValues& values, const PrintViews* views)
{
    return PrintLayout(printSettings(values, views ? views->count() : viewCount(values)));
}

bool isChart(const ParameterValues& values)
{
    return values[printTable().origin] == ViewOrigin::chart;
}

Chart chartOf(const ParameterValues& values, const PrintLayout& layout)
{
    return {layout, values[printTable().chart], values[printTable().chartSpan]};
}

}  // namespace

ParameterValues chartValues(ParameterValues values)
{
    values.set(printTable().origin, ViewOrigin::chart);
    values.set(printTable().border, 0.0);
    for (const auto& mark :
         {printTable().cropMarks, printTable().registrationMarks, printTable().colorBar, printTable().pitchStrip})
        values.set(mark, false);
    values.set(printTable().compensate, false);
    return values;
}

std::string outputProfile(const ParameterValues& values)
{
    const std::string& file = values[printTable().outputProfile];
    if (file.empty()) return {};
    std::string profile = render::readFile(file, mostProfileBytes);
    if (profile.empty() || render::profileChannels(profile) == 0)
        throw Failure(ErrorKind::usage, file +
                                            ": this is no ICC profile of red, green and blue or of four inks; give a "
                                            "file (.icc) of the printer or of a color space.");
    return profile;
}

PrintFile printFile(const ParameterValues& values, const std::filesystem::path& path, const std::string* profile)
{
    const PrintTable& table = printTable();
    PrintFile file;
    file.path = path;
    file.bits = bitsOf(values);
    file.compression = values[table.compression];
    // Only vertical lenses can be cut between.
    file.tileWidth = isChart(values) || values[table.direction] != 0 ? 0 : values[table.tileWidth] * 1000;
    file.tileOverlap = file.tileWidth > 0 ? values[table.tileOverlap] * 1000 : 0;
    file.threads = interlacingThreads();
    file.outputProfile = profile ? *profile : outputProfile(values);
    file.conversion = {values[table.intent], values[table.blackPoint], file.bits};
    return file;
}

PrintPlan printPlan(const ParameterValues& values, const PrintViews* views, const std::filesystem::path& path,
                    const std::string* profile)
{
    PrintPlan plan;
    try {
        const bool chart = isChart(values);
        const PrintLayout layout = layoutOf(values, views);
        if (chart) static_cast<void>(chartOf(values, layout));
        const PrintFile file = printFile(values, path, profile);
        const int channels = render::profileChannels(file.outputProfile);
        static_cast<void>(PrintMarks(layout));
        for (const PrintTile& tile : printTiles(layout, file.tileWidth, file.tileOverlap))
            render::requireStream(path, {tile.x1 - tile.x0, layout.height(), channels, file.bits});
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
            static_cast<double>(layout.width()) * static_cast<double>(layout.height()) * channels * (file.bits / 8);
        plan.layout = layout;
    } catch (const Failure& failure) {
        plan = {};
        plan.refusal = failure.what();
    }
    return plan;
}

std::shared_ptr<const PrintPreview> printPreview(const ParameterValues& values, std::shared_ptr<const PrintViews> views)
{
    const PrintLayout layout = layoutOf(values, views.get());
    if (!views) return std::make_shared<PrintPreview>(layout, chartOf(values, layout));
    const PrintFile file = printFile(values, {});
    std::shared_ptr<const SoftProof> proof;
    if (!file.outputProfile.empty())
        proof = std::make_shared<SoftProof>(views->profile(), file.outputProfile, file.conversion);
    return std::make_shared<PrintPreview>(layout, std::move(views), std::move(proof));
}

namespace {

/// Returns the files of a print in tiles: name, columns of the print, and how many of them the one at the left has,
/// too. Empty if there is only one.
render::Json tilesJson(const ParameterValues& values, const PrintLayout& layout, const std::filesystem::path& path)
{
    const std::string noProfile;
    const PrintFile file = printFile(values, path, &noProfile);
    const std::vector<std::filesystem::path> paths = printFiles(layout, file);
    const std::vector<PrintTile> tiles = printTiles(layout, file.tileWidth, file.tileOverlap);
    render::Json json = render::Json::array();
    if (tiles.size() < 2) return json;
    for (std::size_t i = 0; i < tiles.size(); ++i)
        json.push_back({{"file", paths[i].filename().string()},
                        {"columns", {tiles[i].x0, tiles[i].x1}},
                        {"repeatedColumns", tiles[i].repeated},
                        {"overlap", static_cast<double>(tiles[i].repeated) / layout.settings().dpiX * mmPerInch}});
    return json;
}

}  // namespace

std::string printText(const ParameterValues& values, const PrintViews* views, const std::filesystem::path& path,
                      std::optional<CrossTalk>* compensated)
{
    const PrintLayout layout = layoutOf(values, views);
    PrintSources from;
    if (views) {
        from.names = views->sources();
        if (!views->scenePreset().empty()) from.scene = render::parseJson(views->scenePreset(), "the scene").root();
        from.rig = views->rig();
    } else {
        const std::size_t chart = printTable().chart.row;
        from.names = {formatValue(values.rows()[chart], values.row(chart)) + " chart"};
    }
    render::Json json = printJson(values, layout, render::storedDpi(path, layout.settings().dpiX), from);
    if (render::Json tiles = tilesJson(values, layout, path); !tiles.empty()) json["report"]["tiles"] = tiles;
    std::string text = render::writeJson(json);
    if (!views || !layout.settings().compensate) return text;
    const ViewMatrix mixing = viewMixing(layout);
    const CrossTalk talk = crossTalkOf(views->full(), mixing, compensation(mixing));
    if (compensated) *compensated = talk;
    return withCrossTalk(text, talk);
}

StagedPrint stagedPrint(const ParameterValues& values, const PrintViews* views, PrintFile file)
{
    const PrintLayout layout = layoutOf(values, views);
    if (!views) return stagedChart(layout, chartOf(values, layout), file);
    if (!views->profile().empty()) file.profile = views->profile();
    return stagedPrint(layout, views->full(), file);
}

}  // namespace vitrine::printing
