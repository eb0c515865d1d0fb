#include "exhibits/pixel_art/pixel_art.h"

#include "exhibits/kit/portal.h"
#include "exhibits/pixel_art/method_table.h"
#include "exhibits/pixel_art/pixel_passes.h"
#include "exhibits/pixel_art/visitor_model.h"
#include "render/files/asset_store.h"
#include "render/files/assets.h"
#include "render/hash.h"
#include "render/image/image_io.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vitrine::pixel_art {

struct PixelArt::Prepared final : PreparedPart {
    PosedModel posed;
    std::shared_ptr<const PaletteTextures> palette;
};

namespace {

constexpr double screenBehind = 0.545;  ///< Distance of the screen behind the mouth of the frame, meters.

/// Returns the time in whole steps since the beginning.
double stepTime(const PixelArtTable& t, const ParameterValues& values, double time)
{
    const double rate = values[t.frameRate];
    const double now = values[t.moment] + (values[t.animate] ? time : 0);
    const double step = std::floor(now * rate + 1e-6) / rate;
    return std::isfinite(step) ? step : 0;
}

/// Returns the time within the loop of the animation.
double withinRound(double step)
{
    const double rest = std::fmod(step, worldRound);
    return rest < 0 ? rest + worldRound : rest;
}

std::vector<WorldPart> partsOf(PixelWorld world, double time)
{
    switch (world) {
    case PixelWorld::isle: return isleParts(time);
    case PixelWorld::thinBars: return barParts();
    case PixelWorld::testScene: break;
    }
    return testParts(time);
}

/// The same size as in shaders/pixel_art/screen.frag.
constexpr glm::dvec2 screenHalf{1.12, 0.63};

/// Returns the angles of the eye to the right of and above the screen's axis, radians.
glm::dvec2 asideOf(const glm::dmat4& worldFromExhibit, const glm::dvec3& eye)
{
    const glm::dvec3 p(glm::affineInverse(worldFromExhibit) * glm::dvec4(eye, 1));
    const double before = std::max(p.z + screenBehind, 0.2);
    return {std::atan(p.x / before), std::atan(p.y / before)};
}

using PaletteAsset = render::AssetStore::Made<PaletteTextures>;

PaletteAsset madePalette(std::vector<Rgb8> colors)
{
    if (colors.empty()) colors.emplace_back(0, 0, 0);
    auto made = std::make_shared<PaletteTextures>(paletteTextures(std::move(colors)));
    return {std::move(made), 33000};
}

render::Asset<PaletteTextures> paletteOf(const PixelArtTable& t, const ParameterValues& values,
                                         render::AssetStore& assets)
{
    const PaletteName name = values[t.palette];
    const std::string& given = values[t.palettePicture];
    if (name != PaletteName::goldenHour && given.empty())
        return assets.made<PaletteTextures>("pixel_art.palette", std::to_string(static_cast<int>(name)), [name] {
            const auto colors = shippedPalette(name);
            return madePalette({colors.begin(), colors.end()});
        });
    const std::string path = given.empty() ? render::asset("pictures/golden-hour.png").string() : given;
    const int count = values[t.paletteColors];
    return assets.get<PaletteTextures>(
        "pixel_art.palette", path,
        [count](const std::string& file) { return madePalette(mainColors(render::readColor(file), count)); },
        static_cast<std::uint64_t>(count));
}

}  // namespace

render::Box PixelArt::bounds(const ParameterValues&) const
{
    return portalBounds(Portal{});
}

render::Camera PixelArt::bestView(const ParameterValues&) const
{
    return closeView(screenHalf.y, screenBehind);
}

double PixelArt::nextChange(const ParameterValues& values, double time) const
{
    const bool ofModel = !values[table_.model].empty() && !values[table_.turn] &&
                         !(values[table_.animation] > 0 && values[table_.animationSpeed] > 0);
    if (!values[table_.animate] || ofModel) return std::numeric_limits<double>::infinity();
    const double step = 1 / values[table_.frameRate];
    const double since = std::fmod(time + values[table_.moment] + 1e-6, step);
    return std::isfinite(since) ? std::max(step - since, 0.0) : 0;
}

bool PixelArt::press(ParameterValues& values) const
{
    values.set(table_.animate, !values[table_.animate]);
    return true;
}

std::vector<StudyView> PixelArt::studyViews(const ParameterValues& values) const
{
    ParameterValues still = values;
    still.set(table_.animate, false);
    ParameterValues later = still, perspective = still, bars = still, bare = still;
    later.set(table_.moment, 2.5);
    later.set(table_.azimuth, values[table_.azimuth] + 0.7);
    perspective.set(table_.projection, PixelProjection::perspective);
    bars.set(table_.world, PixelWorld::thinBars);
    bare.set(table_.world, PixelWorld::testScene);
    const render::Camera camera = bestView(values);
    render::Camera aside = camera, part = camera;
    aside.eye += glm::dvec3(0.9, 0.2, 0);
    part.fovY = 0.17;
    return {{"best view", camera, 0, still},
            {"later, from the side", aside, 0, later},
            {"in perspective", camera, 0, perspective},
            {"thin bars", camera, 0, bars},
            {"bare scene, a part", part, 0, bare}};
}

std::vector<DraggedLine> PixelArt::draggedLines(const ExhibitState& state, const glm::dvec3& eye) const
{
    const ParameterValues& values = state.values;
    if (!values[table_.split]) return {};
    const PixelCamera camera = pixelCamera(table_, values, asideOf(glm::dmat4(1), eye));
    const double column = std::floor(values[table_.divider] * camera.size.x + 0.5);
    const double remainder = pixelView(camera, values[table_.snap]).block.remainder.x;
    const double x = ((column - remainder) / camera.size.x - 0.5) * 2 * screenHalf.x;
    return {{table_.divider.row, {x, -screenHalf.y, -screenBehind}, {x, screenHalf.y, -screenBehind}}};
}

double PixelArt::valueUnder(const ExhibitState& state, std::size_t, const render::Ray& ray) const
{
    const ParameterValues& values = state.values;
    const PixelCamera camera = pixelCamera(table_, values, asideOf(glm::dmat4(1), ray.origin));
    const double remainder = pixelView(camera, values[table_.snap]).block.remainder.x;
    const double x = ray.at((-screenBehind - ray.origin.z) / std::min(ray.direction.z, -1e-4)).x;
    const double column = (0.5 * x / screenHalf.x + 0.5) * camera.size.x + remainder;
    return std::clamp(std::floor(column + 0.5) / camera.size.x, 0.0, 1.0);
}

std::unique_ptr<TableMeasurement> PixelArt::measureTable(const ParameterValues& values) const
{
    return std::make_unique<MethodTable>(MethodTable::all(values));
}

std::shared_ptr<const PreparedPart> PixelArt::prepare(const PrepareContext& context) const
{
    auto made = std::make_shared<Prepared>();
    const ParameterValues& values = context.values;
    const auto unread = [&](const char* step, std::size_t row, const Message& why, Message instead) {
        made->unreadable.push_back({step, unreadableFile(table_.rows()[row], title(), why), std::move(instead)});
    };
    render::Hash id;
    if (!values[table_.model].empty()) {
        made->posed = posedModel(table_, values, stepTime(table_, values, context.time), context.assets);
        if (const Message& why = made->posed.failure; !why.empty())
            unread("pixel_art/model", table_.model.row, why, message("The small world is shown in its place."));
        id.addValue(made->posed.id);
    }
    if (values[table_.palette] != PaletteName::none || !values[table_.palettePicture].empty()) {
        const auto found = paletteOf(table_, values, context.assets);
        made->palette = found.value;
        if (!found.failure.empty())
            unread("pixel_art/palette", table_.palettePicture.row, found.failure,
                   message("All colors are shown in its place."));
        id.addValue(found.id);
    }
    made->filesId = id.value();
    return made;
}

void PixelArt::plan(const PlanContext& context, render::FramePlan& plan) const
{
    const auto* prepared = static_cast<const Prepared*>(context.prepared);
    const ParameterValues& values = context.values;
    const double time = withinRound(stepTime(table_, values, context.time));
    PixelShot shot{table_, values, pixelCamera(table_, values, asideOf(context.worldFromExhibit, plan.view.eye)), time};
    if (prepared && prepared->posed.model) {
        const PosedModel& posed = prepared->posed;
        shot.time = 0;  // Time drives only patterns, which a model does not have, so a static model is not drawn again.
        shot.parts = modelParts(*posed.model, posed.framed, values[table_.turn] ? time : 0);
        for (const Message& warning : posed.warnings) plan.warn("pixel_art/model", warning.english());
        if (!posed.pose.still.empty()) plan.skip("pixel_art/pose", posed.pose.still, render::Work::simulation);
    } else {
        shot.parts = partsOf(values[table_.world], time);
    }
    shot.partsId = prepared ? prepared->filesId : 0;
    shot.palette = prepared ? prepared->palette.get() : nullptr;
    shot.keepsLit = false;
    const glm::ivec2 seen = plan.view.raster.size;
    shot.seenSmaller = !context.alone || seen.x < shot.camera.size.x || seen.y < shot.camera.size.y;
    const PixelBlock block = planPixelPicture(shot, plan);
    render::Pass pass = portalPass("pixel_art/screen", "in view", values, "pixel_art/screen.frag", Portal{}, context);
    pass.blocks[BLOCK_EXHIBIT] = render::std140Bytes(block);
    pass.inputs = {{UNIT_EXHIBIT_A, pixelShownImage}};
    plan.add(std::move(pass));
}

}  // namespace vitrine::pixel_art
