#include "exhibits/kit/sdf_exhibit.h"

#include "exhibits/kit/sdf_passes.h"
#include "exhibits/kit/surface_net.h"
#include "render/scene/held_bytes.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <limits>
#include <optional>

namespace vitrine {
namespace {

struct PreparedSdf final : PreparedPart {
    std::optional<render::Asset<render::Mesh>> mesh;  ///< Mesh that is shown in place of the field.
    std::shared_ptr<const PreparedPart> body;         ///< Data that the exhibit prepared for its body; may be null.
};

const PreparedPart* bodyOf(const PreparedPart* prepared)
{
    return prepared ? static_cast<const PreparedSdf*>(prepared)->body.get() : nullptr;
}

/// Returns the box scaled about its center.
render::Box resized(const render::Box& box, double factor)
{
    return {box.center() - factor * box.halfSize(), box.center() + factor * box.halfSize()};
}

}  // namespace

/// Returns sources in which the kit's shaders find field, material and shading under names of the kit.
std::shared_ptr<const render::ShaderSources> sdfSources(const SdfShaders& shaders)
{
    std::map<std::string, std::string> texts;
    if (shaders.generated) texts = shaders.generated->textByPath();
    texts["kit/sdf/field.glsl"] = "#include \"" + shaders.field + "\"\n";
    texts["kit/sdf/material.glsl"] = "#include \"" + shaders.material + "\"\n";
    texts["kit/sdf/shading.glsl"] = "#include \"" + shaders.shading + "\"\n";
    return std::make_shared<render::ShaderSources>(std::move(texts));
}

SdfExhibit::SdfExhibit(const SdfShaders& shaders) : sources_(sdfSources(shaders)) {}

render::Box SdfExhibit::bounds(const ParameterValues& values) const
{
    return resized(boxOverTime(values), values[rows().boxSize]);
}

bool SdfExhibit::isGlass(const ParameterValues& values) const
{
    const SdfMaterialParameters* t = materialParameters();
    return t && values[t->material] == SdfMaterial::glass;
}

std::shared_ptr<const PreparedPart> SdfExhibit::prepare(const PrepareContext& context) const
{
    auto part = std::make_shared<PreparedSdf>();
    part->body = prepareBody(context);
    if (part->body) {
        part->unreadable = part->body->unreadable;
        part->filesId = part->body->filesId;
    }
    if (context.seen && context.values[rows().shownAs] == SdfShown::mesh) {
        const SdfBody now = body(context.values, context.time);
        const int cells = now.values[rows().tessellation];
        const std::string kind = std::string(name()) + ".mesh";
        part->mesh = context.assets.made<render::Mesh>(kind, now.shape + ';' + std::to_string(cells), [&] {
            auto mesh = surfaceNet(now.distance, now.box, cells, kind);
            const std::uint64_t bytes = heldBytes(*mesh);
            return render::AssetStore::Made<render::Mesh>{std::move(mesh), bytes};
        });
    }
    return part->body || part->mesh ? part : nullptr;
}

double SdfExhibit::firstHit(const ExhibitState& state, const render::Ray& ray) const
{
    constexpr double never = std::numeric_limits<double>::infinity();
    constexpr double tolerance = 1e-4;  // Meters; less than a pixel from any place that a walking user can reach.
    const SdfBody now = body(state.values, state.time);
    const render::Ray own = ray.transformed(glm::affineInverse(now.exhibitFromBody));
    const double length = glm::length(own.direction);
    const render::RayInterval inside = render::insideBox(own, now.box);
    if (!(inside.enter <= inside.exit) || !(length > 0)) return never;
    double t = inside.enter;
    for (int step = 0; step < 1000 && t <= inside.exit; ++step) {
        const double distance = now.distance(own.at(t));
        if (distance < tolerance) return t;
        t += distance / length;
    }
    return never;
}

render::Camera SdfExhibit::bestView(const ParameterValues& values) const
{
    const render::Box box = boxOverTime(values);
    const double reach = glm::length(box.halfSize());
    return {box.center() + glm::dvec3(0.9, 0.3, 1.6) * reach, box.center(), 0.698132};
}

double SdfExhibit::nextChange(const ParameterValues&, double) const
{
    return std::numeric_limits<double>::infinity();
}

std::vector<OfferedComparison> SdfExhibit::comparisons() const
{
    const auto number = [](auto value) { return static_cast<double>(value); };
    return {{"mesh",
             "The rasterized mesh",
             "A mesh of the object: its outline is nearly right, but reflections break at every edge. “Tessellation” "
             "sets the number of cells.",
             {{"shownAs", number(SdfShown::mesh)}}},
            {"field",
             "The marched field",
             "The ray-marched field, beside the mesh that is shown in its place.",
             {{"shownAs", number(SdfShown::field)}, {"heatMap", number(SdfHeatMap::none)}}},
            {"cost",
             "What each ray costs",
             "Field evaluations of every pixel, black to white: “Heat scale” says how many are white.",
             {{"shownAs", number(SdfShown::field)}, {"heatMap", number(SdfHeatMap::evaluations)}}}};
}

bool SdfExhibit::mirrors(const ParameterValues& values) const
{
    const SdfMaterialParameters* material = materialParameters();
    return material && values[material->roughness] < mirrorRoughness;
}

SdfScene SdfExhibit::sceneOf(const PlanContext& context, const SdfBody& now) const
{
    const SdfMaterialParameters* material = materialParameters();
    const bool spreads =
        !material || (now.values[material->roughness] > 0 && now.values[material->refractiveIndex] > 1);
    const bool glass = isGlass(now.values);
    return {name(),
            rows(),
            glass,
            glass && spreads,
            mirrors(now.values),
            context,
            now,
            resized(now.box, now.values[rows().boxSize]),
            now.sources ? now.sources : sources_};
}

void SdfExhibit::planShadow(const PlanContext& context, render::FramePlan& plan) const
{
    SdfBody now = body(context.values, context.time);
    complete(now, bodyOf(context.prepared));
    planSdfShadow(sceneOf(context, now), plan);
}

void SdfExhibit::plan(const PlanContext& context, render::FramePlan& plan) const
{
    SdfBody now = body(context.values, context.time);
    complete(now, bodyOf(context.prepared));
    const SdfScene scene = sceneOf(context, now);
    const auto* prepared = static_cast<const PreparedSdf*>(context.prepared);
    planSdf(scene, prepared && prepared->mesh ? &*prepared->mesh : nullptr, plan);
    planBeside(scene, plan);
}

}  // namespace vitrine
