#include "exhibits/ice_cream/backdrop_sheet.h"

#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/surface_draw.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace vitrine::ice_cream {
namespace backdrop_sheet {
namespace {

// The niche is 2.4 m wide, 1.6 m high and 0.5 m deep; the sheet stays a little within it. Meters.
constexpr double halfWidth = 1.19, floorHeight = -0.797, top = 0.797;
constexpr double front = -0.03, back = -0.49, sweep = 0.12;  ///< `sweep`: radius of the bend.
constexpr int bendSteps = 10;

struct ProfilePoint {
    double y, z, normalY, normalZ;
};

std::vector<ProfilePoint> profile()
{
    std::vector<ProfilePoint> points{{floorHeight, front, 1, 0}};
    for (int i = 0; i <= bendSteps; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / bendSteps;
        points.push_back({floorHeight + sweep * (1 - std::cos(angle)), back + sweep * (1 - std::sin(angle)),
                          std::cos(angle), std::sin(angle)});
    }
    points.push_back({top, back, 0, 1});
    return points;
}

std::shared_ptr<const render::Mesh> sheet()
{
    static const std::shared_ptr<const render::Mesh> made = [] {
        auto mesh = std::make_shared<render::Mesh>();
        mesh->name = "backdrop of the ice cream";
        for (const ProfilePoint& point : profile()) {
            for (const double x : {-halfWidth, halfWidth}) {
                render::Vertex vertex;
                vertex.position = glm::vec3(x, point.y, point.z);
                vertex.normal = glm::vec3(0, point.normalY, point.normalZ);
                mesh->vertices.push_back(vertex);
            }
        }
        for (std::uint32_t row = 0; row + 4 <= mesh->vertices.size(); row += 2)
            for (const std::uint32_t corner : {0U, 1U, 3U, 0U, 3U, 2U}) mesh->indices.push_back(row + corner);
        mesh->bounds = {{-halfWidth, floorHeight, back}, {halfWidth, top, front}};
        return mesh;
    }();
    return made;
}

bool isShown(const IceCreamTable& table, const ParameterValues& values)
{
    return values[table.backdrop] > 0 && values[table.lighting] == IceCreamLighting::hall;
}

}  // namespace
}  // namespace backdrop_sheet

render::Box backdropBox(const IceCreamTable& table, const ParameterValues& values)
{
    return backdrop_sheet::isShown(table, values) ? backdrop_sheet::sheet()->bounds : render::Box();
}

void planBackdrop(const IceCreamTable& table, const PlanContext& context, const glm::dvec3& foot, double footRadius,
                  render::FramePlan& plan)
{
    constexpr const char* name = "ice_cream/backdrop";
    if (!backdrop_sheet::isShown(table, context.values)) {
        plan.skip(name, context.values[table.lighting] == IceCreamLighting::hall
                            ? "the backdrop is switched off"
                            : "the light is that of the reference");
        return;
    }
    if (context.onNothing) {
        plan.skip(name, "the background stays empty");
        return;
    }
    render::Pass pass = exhibitPass(name, "a lamp behind the ice cream lights a sheet", context.values,
                                    "ice_cream/backdrop.vert", "ice_cream/backdrop.frag");
    drawSurface(pass, context.channels.withoutCounts());
    context.bindLighting(pass);
    IceCreamBackdrop block;
    block.worldFromExhibit = glm::mat4(context.worldFromExhibit);
    block.foot = glm::vec3(foot);
    block.footRadius = static_cast<float>(footRadius);
    render::Draw draw;
    draw.mesh = backdrop_sheet::sheet();
    draw.mirrored = isMirrored(context.worldFromExhibit);
    draw.object = render::std140Bytes(block);
    pass.draws = {std::move(draw)};
    plan.add(std::move(pass));
}

}  // namespace vitrine::ice_cream
