#include "exhibits/printing/lenticular_desk.h"

#include "exhibits/framework/state_folder.h"
#include "exhibits/printing/chart.h"
#include "exhibits/printing/desk_preview.h"
#include "exhibits/printing/desk_settings.h"
#include "exhibits/printing/print_file.h"
#include "exhibits/printing/print_json.h"
#include "exhibits/printing/sheet.h"
#include "exhibits/printing/view_files.h"
#include "exhibits/printing/view_maker.h"
#include "render/failure.h"
#include "render/files/extension.h"
#include "render/files/read_file.h"
#include "render/image/image_io.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace vitrine::printing {
namespace {

namespace fs = std::filesystem;

constexpr int smallSide = 400;
constexpr int draftWidth = 240;
constexpr int largestView = 16384;
constexpr double flipZone = 40;  ///< Degrees: sheets for depth have about 30, sheets for flips about 50.
constexpr std::size_t mostJsonBytes = 4U << 20U;

/// Box-filtered by a whole factor, so that its longer side is at most about twice `side`.
render::Image shrunk(const render::Image& image, int side)
{
    const int factor = std::max(image.width, image.height) / side;
    if (factor <= 1) return image;
    const int width = (image.width + factor - 1) / factor;
    const int height = (image.height + factor - 1) / factor;
    render::Image small(width, height, image.channels);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int x1 = std::min((x + 1) * factor, image.width);
            const int y1 = std::min((y + 1) * factor, image.height);
            for (int c = 0; c < image.channels; ++c) {
                float sum = 0;
                for (int v = y * factor; v < y1; ++v)
                    for (int u = x * factor; u < x1; ++u) sum += image.at(u, v, c);
                small.at(x, y, c) = sum / static_cast<float>((x1 - x * factor) * (y1 - y * factor));
            }
        }
    }
    return small;
}

/// Of the print's shape.
glm::ivec2 viewSize(const PrintLayout& layout, int width)
{
    const PrintSettings& s = layout.settings();
    const double height = width * (s.height + 2 * s.bleed) / (s.width + 2 * s.bleed);
    return {width, static_cast<int>(std::clamp(std::round(height), 1.0, static_cast<double>(largestView)))};
}

bool sameLens(const Sheet& a, const Sheet& b)
{
    const auto near = [](double x, double y) { return std::abs(x - y) <= 1e-6 * std::max(std::abs(x), std::abs(y)); };
    return near(a.nominalLpi, b.nominalLpi) && near(a.effectiveLpi, b.effectiveLpi) && near(a.radius, b.radius) && near(a.thickness, b.thickness) &&
           near(a.index, b.index) && near(a.conic, b.conic);
}

/// In all but the sheet.
bool samePrint(const PrintSettings& a, const PrintSettings& b)
{
    const auto all = [](const PrintSettings& s) {
        return std::tuple(s.dpiX, s.dpiY, s.width, s.height, s.bleed, s.distance, s.visualLpi, s.phase, s.direction, s.reverse, s.mirror, s.views, s.method,
                          s.guard, s.border, s.dither, s.compensate, s.inkSpread);
    };
    return all(a) == all(b);
}

}  // namespace

void DeskViews::add(const render::Image& image)
{
    full_.add(image);
    small_.add(shrunk(image, smallSide));
}

LenticularDesk::LenticularDesk() : own_(configFolder() / "sheets.json") {}

ViewOrigin LenticularDesk::origin(const ParameterValues& values) const
{
    return values[table_.origin];
}

ParameterValues LenticularDesk::withOrigin(const ParameterValues& values, ViewOrigin origin) const
{
    ParameterValues changed = values;
    changed.set(table_.origin, origin);
    return changed;
}

bool LenticularDesk::matters(const ParameterInfo& row, const ParameterValues& values, bool chart) const
{
    const auto is = [&](auto parameter) { return row.name == table_.rows()[parameter.row].name; };
    const ViewOrigin from = values[table_.origin];
    if (row.group == "Views") {
        if (chart) return is(table_.views) && values[table_.chart] != ChartKind::pitch && values[table_.chart] != ChartKind::phase;
        if (is(table_.viewWidth) || is(table_.samples) || is(table_.baselineScale) || is(table_.convergence)) return from == ViewOrigin::shown;
        if (is(table_.quiltColumns) || is(table_.quiltRows)) return from == ViewOrigin::quilt;
        if (is(table_.views)) return from != ViewOrigin::quilt;
        return !is(table_.origin);  // It has a place of its own, beside the files.
    }
    if (is(table_.chart)) return chart;
    if (is(table_.chartSpan)) return chart && values[table_.chart] == ChartKind::pitch;
    if (is(table_.zone)) return values[table_.lens] == LensShape::derived;
    if (is(table_.radius) || is(table_.thickness)) return values[table_.lens] == LensShape::given;
    if (is(table_.distance)) return !values[table_.infiniteDistance];
    if (is(table_.border) || is(table_.compensate)) return !chart;
    if (is(table_.dither)) return values[table_.bits] == 0;
    if (is(table_.guard)) return values[table_.method] == Method::guard;
    if (is(table_.tileWidth)) return values[table_.direction] == 0;
    return true;
}

bool LenticularDesk::sameViews(const ParameterValues& a, const ParameterValues& b) const
{
    const bool rendered = b[table_.origin] == ViewOrigin::shown;
    const auto decides = [&](const ParameterInfo& row) {
        if (row.group == "Views") return row.name == table_.rows()[table_.origin.row].name || matters(row, b, false);
        // The cameras stand as the lenses show, and frame what the print's shape takes.
        return rendered && (row.group == "Sheet" || row.name == "width" || row.name == "height" || row.name == "bleed" || row.name == "direction" ||
                            row.name == "distance" || row.name == "infiniteDistance" || row.name == "visualPerInch");
    };
    for (std::size_t i = 0; i < a.rows().size(); ++i)
        if (a.row(i) != b.row(i) && decides(a.rows()[i])) return false;
    return true;
}

double LenticularDesk::viewingDistance(const ParameterValues& values) const
{
    return values[table_.infiniteDistance] ? std::numeric_limits<double>::infinity() : values[table_.distance];
}

std::vector<Sheet> LenticularDesk::allSheets(std::string& problem) const
{
    std::vector<Sheet> all = knownSheets();
    try {
        for (Sheet& sheet : own_.read()) all.push_back(std::move(sheet));
    } catch (const Failure& failure) {
        problem = failure.what();
    }
    return all;
}

std::vector<SheetEntry> LenticularDesk::sheets(std::string& problem) const
{
    std::vector<SheetEntry> entries;
    for (const Sheet& sheet : allSheets(problem)) entries.push_back({sheet.name, entries.size() >= knownSheets().size()});
    return entries;
}

ParameterValues LenticularDesk::withSheet(const ParameterValues& values, const std::string& name) const
{
    std::string problem;
    for (const Sheet& sheet : allSheets(problem))
        if (sheet.name == name) return printing::withSheet(table_, values, sheet);
    throw Failure(Blame::usage, "There is no sheet \"" + name + "\"; choose one of the list.");
}

std::string LenticularDesk::sheetName(const ParameterValues& values, const std::string& preferred) const
{
    try {
        const Sheet own = sheetOf(table_, values);
        std::string problem;
        std::string first;
        for (const Sheet& sheet : allSheets(problem)) {
            if (!sameLens(own, sheet)) continue;
            if (sheet.name == preferred) return preferred;
            if (first.empty()) first = sheet.name;
        }
        return first;
    } catch (const Failure&) {  // A sheet that cannot be has no name; the summary says why.
    }
    return {};
}

void LenticularDesk::saveSheet(const ParameterValues& values, const std::string& name)
{
    Sheet sheet = sheetOf(table_, values);
    sheet.name = name;
    own_.save(sheet);
}

void LenticularDesk::removeSheet(const std::string& name)
{
    own_.remove(name);
}

std::shared_ptr<PrintViews> LenticularDesk::newViews() const
{
    return std::make_shared<DeskViews>();
}

std::shared_ptr<const PrintViews> LenticularDesk::readViews(const ParameterValues& values, const std::vector<std::string>& names, const PrintProgress& progress) const
{
    auto views = std::make_shared<DeskViews>();
    const auto tell = [&](double part) {
        if (progress && !progress(part)) throw PrintStopped();
    };
    if (values[table_.origin] == ViewOrigin::quilt) {
        if (names.empty()) throw Failure(Blame::usage, "There is no quilt; choose a picture with a grid of views.");
        tell(0);
        const render::Image quilt = render::readImage(names.front());
        const int columns = values[table_.quiltColumns];
        const int rows = values[table_.quiltRows];
        for (int k = 0; k < columns * rows; ++k) {
            tell(static_cast<double>(k) / (columns * rows));
            views->add(viewOfQuilt(quilt, columns, rows, k));
        }
        views->setProfile(render::embeddedProfile(names.front()));
        return views;
    }
    if (names.empty()) throw Failure(Blame::usage, "There are no views; choose a folder or pictures.");
    const std::vector<fs::path> files = viewFiles(names);
    const std::vector<std::size_t> chosen = chosenViews(files.size(), {1, false, std::min(values[table_.views], static_cast<int>(files.size()))});
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        tell(static_cast<double>(i) / static_cast<double>(chosen.size()));
        views->add(render::readImage(files[chosen[i]]));
    }
    views->setProfile(render::embeddedProfile(files[chosen.front()]));
    return views;
}

ViewRig LenticularDesk::rigOf(const ParameterValues& values, const Look& look) const
{
    const PrintLayout layout = layoutOf(values, nullptr);
    return {layout, look.camera, viewSize(layout, values[table_.viewWidth]), {values[table_.baselineScale], values[table_.convergence]}};
}

std::vector<PrintShot> LenticularDesk::shots(const ParameterValues& values, const Look& look, const FrameRequest& frame, bool draft) const
{
    const PrintLayout layout = layoutOf(values, nullptr);
    ViewShot base{look, {}};
    base.request.frame = frame;
    base.request.frame.raster.size = viewSize(layout, draft ? std::min(values[table_.viewWidth], draftWidth) : values[table_.viewWidth]);
    base.request.samples = draft ? 1 : values[table_.samples];
    std::vector<PrintShot> shots;
    for (ViewShot& shot : shotsOf(rigOf(values, look), base)) shots.push_back({std::move(shot.look), std::move(shot.request)});
    return shots;
}

ParameterValues LenticularDesk::withBaselineScale(const ParameterValues& values, double scale) const
{
    ParameterValues changed = values;
    changed.set(table_.baselineScale, scale);
    return changed;
}

SceneDepth LenticularDesk::sceneDepth(const ParameterValues& values, const Look& look, const render::Image& picture) const
{
    const ViewRig rig = rigOf(values, look);
    const DepthRange scene = depthRange(picture);
    const DepthRange budget = rig.budget();
    SceneDepth depth{scene.nearest, scene.farthest, budget.nearest, budget.farthest, std::min(1.0, rig.strengthThatHolds(scene)), warningsOf(rig, scene)};
    if (values[table_.reverse] && rig.baseline() > 0) depth.warnings.emplace_back("In reverse order the depth of rendered views is inside out.");
    return depth;
}

double LenticularDesk::tileWidth(const ParameterValues& values) const
{
    return values[table_.direction] == 0 ? values[table_.tileWidth] * 1000 : 0;  // Only upright lenses can be cut between.
}

PrintLayout LenticularDesk::layoutOf(const ParameterValues& values, const PrintViews* views) const
{
    return PrintLayout(printSettings(table_, values, views ? views->count() : values[table_.views]));
}

PrintLayout LenticularDesk::chartLayout(const ParameterValues& values) const
{
    PrintSettings settings = printSettings(table_, values, values[table_.views]);
    settings.border = 0;  // Charts have one of their own.
    settings.compensate = false;
    return PrintLayout(settings);
}

PrintSummary LenticularDesk::summary(const ParameterValues& values, const PrintViews* views, bool chart, const fs::path& path) const
{
    PrintSummary summary;
    try {
        const PrintLayout layout = chart ? chartLayout(values) : layoutOf(values, views);
        if (chart) static_cast<void>(Chart(layout, values[table_.chart], values[table_.chartSpan]));
        else static_cast<void>(tileCuts(layout, tileWidth(values)));
        const PrintNumbers numbers = numbersOf(layout, render::storedDpi(path, layout.settings().dpiX));
        summary.warnings = warningsOf(layout);
        const bool upright = std::abs(values[table_.direction]) < std::numbers::pi / 4;
        if (!chart && upright && numbers.zoneDegrees > flipZone)
            summary.warnings.emplace_back("This sheet is made for flips, and its lenses stand upright: each eye sees another picture. For a flip, lay them across (direction 90°).");
        summary.width = layout.width();
        summary.height = layout.height();
        summary.bytes = static_cast<double>(layout.width()) * static_cast<double>(layout.height()) * 3 * (values[table_.bits] == 0 ? 1 : 2);
        summary.pixelsPerLens = numbers.pixelsPerLens;
        summary.storedLpi = numbers.effectiveLpi;
        summary.effectiveViews = numbers.effectiveViews;
        summary.zone = numbers.zoneDegrees * radiansPerDegree;
        summary.depthBudget = numbers.depthBudget / 1000;
        summary.ownShare = numbers.ownShare;
        if (views && !chart) {
            const ViewSet& set = static_cast<const DeskViews&>(*views).full();
            const double shape = static_cast<double>(set.view(0).width) / set.height() * static_cast<double>(layout.height()) / static_cast<double>(layout.width()) *
                                 layout.settings().dpiX / layout.settings().dpiY;
            if (shape > 1.02 || shape < 0.98) summary.warnings.emplace_back("The views are not shaped as the print is and are stretched to it.");
        }
    } catch (const Failure& failure) {
        summary.refusal = failure.what();
    }
    return summary;
}

std::shared_ptr<const PrintPreview> LenticularDesk::preview(const ParameterValues& values, std::shared_ptr<const PrintViews> views) const
{
    if (!views) return std::make_shared<ChartPreview>(chartLayout(values), values[table_.chart], values[table_.chartSpan]);
    return std::make_shared<ViewsPreview>(layoutOf(values, views.get()), std::static_pointer_cast<const DeskViews>(views));
}

std::vector<fs::path> LenticularDesk::write(const ParameterValues& values, std::shared_ptr<const PrintViews> views, const std::vector<std::string>& sources,
                                            const fs::path& path, const PrintProgress& progress) const
{
    const PrintLayout layout = views ? layoutOf(values, views.get()) : chartLayout(values);
    bool stopped = false;
    PrintFile file;
    file.path = path;
    file.bits = values[table_.bits] == 0 ? 8 : 16;
    file.compression = values[table_.compression];
    file.tileWidth = tileWidth(values);
    file.threads = interlacingThreads();
    file.progress = [&](double part) {
        stopped = progress && !progress(part);
        return !stopped;
    };
    render::Json json = printJson(layout, render::storedDpi(path, layout.settings().dpiX), sources);
    json["desk"] = deskJson(values, sources);
    if (views) {
        const std::string& look = static_cast<const DeskViews&>(*views).look();
        if (!look.empty()) json["scene"] = {{"preset", render::parseJson(look, "the look").root()}};
    }
    file.json = render::writeJson(json);
    try {
        if (views) {
            const auto& set = static_cast<const DeskViews&>(*views);
            file.profile = set.profile();
            if (layout.settings().compensate) {
                const ViewMatrix mixing = viewMixing(layout);
                file.json = withCrossTalk(file.json, crossTalkOf(set.full(), mixing, compensation(mixing)));
            }
            return writePrint(layout, set.full(), file);
        }
        file.tileWidth = 0;
        const Chart chart(layout, values[table_.chart], values[table_.chartSpan]);
        return writeRaster(layout,
                           {[&](const Region& region, std::uint8_t* out) { chart.fill(region, out); },
                            [&](const Region& region, std::uint16_t* out) { chart.fill(region, out); }},
                           file);
    } catch (const Failure&) {
        if (stopped) throw PrintStopped();
        throw;
    }
}

std::string LenticularDesk::settingsText(const ParameterValues& values, const std::vector<std::string>& sources) const
{
    render::Json json;
    try {
        const PrintLayout layout = layoutOf(values, nullptr);
        json = printJson(layout, layout.settings().dpiX, sources);
    } catch (const Failure&) {
        json["vitrinePrint"] = 1;  // Settings that cannot be are kept all the same: someone is in the middle of them.
    }
    json["desk"] = deskJson(values, sources);
    return render::writeJson(json);
}

PrintDesk::Settings LenticularDesk::settingsFrom(const std::string& text, const std::string& fileName) const
{
    const render::JsonDocument document = render::parseJson(text, fileName, {.bytes = mostJsonBytes});
    if (!document.root().is_object() || document.root().value("vitrinePrint", render::Json()) != 1) {
        throw document.failure("vitrinePrint", "this does not describe a lenticular print of version 1; give a print, or the JSON beside it.");
    }
    Settings settings{table_.initial(), {}, {}};
    settings.values = valuesFromDesk(table_, document, settings.sources, settings.notes);
    if (!document.root().contains("print")) return settings;
    const PrintSettings read = settingsFromJson(document);
    try {
        const PrintSettings here = printSettings(table_, settings.values, read.views);
        if (samePrint(here, read) && sameLens(here.sheet, read.sheet)) return settings;
    } catch (const Failure&) {  // The desk's part has no such print: the print's own part counts.
    }
    settings.values = withSettings(table_, settings.values, read);
    return settings;
}

std::string LenticularDesk::settingsIn(const fs::path& path) const
{
    if (render::lowerExtension(path) == ".json") return render::readFile(path, mostJsonBytes);
    return printDescription(path).text();
}

}  // namespace vitrine::printing
