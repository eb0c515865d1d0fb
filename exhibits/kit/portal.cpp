#include "exhibits/kit/portal.h"

#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/surface_draw.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

/// Returns a square from -1 to 1 on z = 0, facing +z.
std::shared_ptr<const render::Mesh> squareMesh()
{
    static const std::shared_ptr<const render::Mesh> square = [] {
        auto mesh = std::make_shared<render::Mesh>();
        mesh->name = "opening";
        for (const glm::vec2 c : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
            mesh->vertices.push_back({glm::vec3(c, 0), {0, 0, 1}, {1, 0, 0, 1}, c * 0.5F + 0.5F, {}});
        mesh->indices = {0, 1, 2, 0, 2, 3};
        mesh->bounds = {{-1, -1, 0}, {1, 1, 0}};
        return mesh;
    }();
    return square;
}

/// Returns a point of the divider in exhibit space.
glm::dvec4 dividerOf(const Portal& portal)
{
    return {portal.divider, 0, -portal.behind, 1};
}

PortalBlock portalBlock(const Portal& portal, const PlanContext& context)
{
    const glm::dmat4& worldFromExhibit = context.worldFromExhibit;
    const glm::dmat4 exhibitFromOpening =
        glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -portal.behind)), glm::dvec3(portal.halfSize, 1));
    const glm::dmat4 workFromWorld = portal.workFromExhibit * glm::affineInverse(worldFromExhibit);
    const glm::dvec3 middle(worldFromExhibit * glm::dvec4(0, 0, -portal.behind, 1));
    const glm::dvec3 normal = glm::normalize(normalMatrix(glm::dmat3(worldFromExhibit)) * glm::dvec3(0, 0, 1));
    PortalBlock block;
    block.worldFromOpening = glm::mat4(worldFromExhibit * exhibitFromOpening);
    block.workFromWorld = glm::mat4(workFromWorld);
    block.plane = glm::vec4(glm::dvec4(normal, -glm::dot(normal, middle)));
    block.workPerMeter = static_cast<float>(glm::length(glm::dvec3(workFromWorld[2])));
    block.radianceScale = static_cast<float>(1 / context.lighting.adaptation);
    block.dividerAt = glm::vec3(worldFromExhibit * dividerOf(portal));
    block.dividerUp = glm::vec3(worldFromExhibit * glm::dvec4(0, 1, 0, 0));
    block.side = static_cast<float>(portal.side);
    return block;
}

}  // namespace

render::Box portalBounds(const Portal& portal)
{
    return {{-portal.halfSize, -portal.behind}, {portal.halfSize, -portal.behind}};
}

std::optional<glm::ivec2> portalColumns(const Portal& portal, const glm::dmat4& worldFromExhibit,
                                        const render::View& view)
{
    if (portal.side == 0) return std::nullopt;
    const glm::dvec3 toLine = glm::dvec3(worldFromExhibit * dividerOf(portal)) - view.eye;
    const glm::dvec3 right = glm::cross(toLine, glm::dvec3(worldFromExhibit * glm::dvec4(0, 1, 0, 0)));
    // The signed distance of a ray from the divider is linear across the picture.
    const auto at = [&](double x, double y) { return glm::dot(right, view.direction({x, y})) * portal.side; };
    double low = 1, high = -1;
    for (const double y : {-1.0, 1.0}) {
        const double first = at(-1, y), last = at(1, y);
        if (first >= 0) low = -1;
        if (last >= 0) high = 1;
        if ((first >= 0) == (last >= 0)) continue;
        const double between = -1 + 2 * first / (first - last);
        low = std::min(low, between);
        high = std::max(high, between);
    }
    // One more column on either side allows for jitter and rounding.
    const double width = view.raster.size.x;
    const auto column = [&](double ndc) { return (0.5 + 0.5 * ndc) * width - view.raster.offset.x; };
    if (high <= low) return glm::ivec2(0);
    return glm::clamp(
        glm::ivec2(static_cast<int>(std::floor(column(low))) - 1, static_cast<int>(std::ceil(column(high))) + 1),
        glm::ivec2(0), glm::ivec2(view.raster.drawn().x));
}

render::Camera closeView(double halfHeight, double behind)
{
    const double fovY = glm::radians(50.0);
    const double away = halfHeight / (openingInView * std::tan(0.5 * fovY));
    return {{0, 0, away - behind}, {0, 0, -behind}, fovY};
}

render::Camera portalView(const Portal& portal)
{
    return closeView(portal.halfSize.y, portal.behind);
}

render::Pass portalPass(std::string name, std::string reason, const ParameterValues& values, std::string fragment,
                        const Portal& portal, const PlanContext& context)
{
    render::Pass pass =
        exhibitPass(std::move(name), std::move(reason), values, "kit/portal/portal.vert", std::move(fragment));
    drawSurface(pass, context.channels);
    pass.blocks[BLOCK_LIGHT] = render::std140Bytes(context.lighting.light);
    render::Draw draw;
    draw.object = render::std140Bytes(portalBlock(portal, context));
    if (context.alone) {
        pass.shader.defines.emplace_back("ALONE");
        pass.state.cull = render::Cull::none;
    } else {
        draw.mesh = squareMesh();
        draw.mirrored = isMirrored(context.worldFromExhibit);
        pass.depthOnly = {.shader = {.vertex = "kit/portal/portal.vert", .fragment = "kit/depth.frag"}};
    }
    pass.draws = {std::move(draw)};
    return pass;
}

}  // namespace vitrine
