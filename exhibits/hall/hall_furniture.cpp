#include "exhibits/hall/hall_furniture.h"

#include "exhibits/framework/scene/scene_lighting.h"
#include "exhibits/hall/hall_model.h"
#include "render/hash.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <unordered_map>

namespace vitrine::hall {
namespace {

using render::MeshInstance;

constexpr double wallHeight = 1.8;  ///< Colliders that are at least as high are walls.

/// Returns for each vertex the first vertex of its connected component.
std::vector<std::uint32_t> pieceOfVertices(const render::Mesh& mesh)
{
    std::vector<std::uint32_t> parent(mesh.vertices.size());
    std::unordered_map<std::uint64_t, std::uint32_t> firstAt;
    firstAt.reserve(parent.size());
    for (std::uint32_t i = 0; i < parent.size(); ++i) {
        const glm::ivec3 at(glm::round(glm::dvec3(mesh.vertices[i].position) * 1e4));
        parent[i] = firstAt.emplace(render::Hash().addValue(at).value(), i).first->second;
    }
    const auto root = [&](std::uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3)
        for (const std::size_t corner : {t + 1, t + 2}) parent[root(mesh.indices[corner])] = root(mesh.indices[t]);
    for (std::uint32_t i = 0; i < parent.size(); ++i) parent[i] = root(i);
    return parent;
}

MeshPiece pieceOf(const std::vector<glm::dvec3>& points)
{
    MeshPiece piece;
    for (const glm::dvec3& p : points) piece.box.include(p);
    const glm::dvec3 center = piece.box.center();
    const glm::dvec3 half = piece.box.halfSize();
    double widest = 0;
    for (const glm::dvec3& p : points) {
        const double radius = std::hypot(p.x - center.x, p.z - center.z);
        piece.meanRadius += radius / static_cast<double>(points.size());
        widest = std::max(widest, radius);
    }
    piece.round = std::abs(widest - half.x) < 0.06 * widest && std::abs(widest - half.z) < 0.06 * widest;
    piece.discLow = piece.box.high.y;
    piece.discHigh = piece.box.low.y;
    for (const glm::dvec3& p : points) {
        if (std::hypot(p.x - center.x, p.z - center.z) < 0.7 * widest) continue;
        piece.discLow = std::min(piece.discLow, p.y);
        piece.discHigh = std::max(piece.discHigh, p.y);
    }
    return piece;
}

bool isFurniture(const Collider& collider)
{
    return 2 * collider.halfSize.y < wallHeight;
}

/// Returns whether a piece with this center belongs to the obstacle of a collider.
bool standsIn(const Collider& collider, const glm::dvec3& middle)
{
    constexpr double margin = 0.12;  // A plaque hangs a little in front of its plinth.
    const glm::dvec3 p = glm::abs(glm::dvec3(collider.localFromWorld * glm::dvec4(middle, 1)));
    const double deep = collider.cylinder ? collider.halfSize.x : collider.halfSize.z;
    return p.x < collider.halfSize.x + margin && p.y < collider.halfSize.y + 0.3 && p.z < deep + margin;
}

/// Returns the collider around a piece of furniture; none if the piece is no furniture.
std::optional<std::size_t> colliderOf(const HallModel& model, const StandingShape& shape)
{
    const glm::dvec3 half = boundsOf(shape).halfSize();
    if (std::max(half.x, half.z) > 1 || shape.center.y + shape.halfHeight < 0) return std::nullopt;  // Floor or wall.
    const std::vector<Collider>& colliders = model.colliders();
    const auto at = std::find_if(colliders.begin(), colliders.end(), [&](const Collider& collider) {
        return isFurniture(collider) && standsIn(collider, shape.center);
    });
    if (at == colliders.end()) return std::nullopt;
    return static_cast<std::size_t>(at - colliders.begin());
}

const render::Box* openingAlongX(const HallModel& model)
{
    for (const render::Box& opening : model.openings())
        if (flatAxis(opening) == 2) return &opening;
    return nullptr;
}

/// Adds a slender piece within the opening to the bars.
void addBar(const render::Box& piece, const render::Box& opening, WindowBars& bars, std::vector<double>& depths)
{
    constexpr double slender = 0.1;  // Meters.
    constexpr double margin = 0.15;
    const render::Box around{opening.low - margin, opening.high + margin};
    if (!around.contains(piece.low) || !around.contains(piece.high)) return;
    const glm::dvec3 half = piece.halfSize();
    const bool upright = 2 * half.x < slender && half.y > 0.5;
    const bool level = 2 * half.y < slender && half.x > 0.5;
    if (upright)
        bars.upright.emplace_back(piece.center().x, half.x);
    else if (level)
        bars.level.emplace_back(piece.center().y, half.y);
    else
        return;
    depths.push_back(piece.center().z);
}

glm::dvec3 meanColor(const HallModel& model, const MeshInstance& part)
{
    return model.surfaces().untextured(part.material ? part.material->name : std::string()).meanColor;
}

/// Weakens the contact shadow of a shape that is larger than the lightmaps' texels. They already contain its shadow,
/// but blurred, so only the part close to it is missing.
void countAsBaked(StandingShape& shape)
{
    constexpr float texels = 0.15F;  // Meters: three of the sky's lightmap on the floor.
    if (2 * shape.halfHeight < texels) return;
    shape.strength = 0.6F;
    shape.reach = 0.3F;
}

}  // namespace

std::vector<MeshPiece> piecesOf(const render::Mesh& mesh)
{
    const std::vector<std::uint32_t> pieces = pieceOfVertices(mesh);
    std::map<std::uint32_t, std::vector<glm::dvec3>> points;
    for (std::size_t i = 0; i < pieces.size(); ++i) points[pieces[i]].emplace_back(mesh.vertices[i].position);
    std::vector<MeshPiece> result;
    result.reserve(points.size());
    for (const auto& [first, all] : points) result.push_back(pieceOf(all));
    return result;
}

StandingShape shapeOf(const MeshPiece& piece, const glm::dvec3& color)
{
    if (!piece.round) return standingBox(piece.box, color);
    render::Box box = piece.box;
    const double height = box.high.y - box.low.y;
    if (height > 2 * box.halfSize().x) {
        const glm::dvec3 center = box.center();
        const glm::dvec3 reach(piece.meanRadius, 0.5 * height, piece.meanRadius);
        return standingCylinder({center - reach, center + reach}, color);
    }
    box.low.y = piece.discLow;
    box.high.y = piece.discHigh;
    return standingCylinder(box, color);
}

void joinBoards(std::vector<StandingShape>& shapes)
{
    constexpr double seam = 0.03;  // Meters between two boards.
    const auto joined = [](const StandingShape& a, const StandingShape& b) {
        if (a.kind != STANDING_BOX || b.kind != STANDING_BOX || a.color != b.color) return false;
        if (a.axis != glm::vec2(1, 0) || b.axis != a.axis) return false;
        const render::Box one = boundsOf(a);
        const render::Box other = boundsOf(b);
        if (std::abs(one.low.y - other.low.y) > 1e-3 || std::abs(one.high.y - other.high.y) > 1e-3) return false;
        for (const int axis : {0, 2}) {
            const int side = 2 - axis;
            if (std::abs(one.low[side] - other.low[side]) > 1e-3 || std::abs(one.high[side] - other.high[side]) > 1e-3)
                continue;
            if (one.low[axis] - other.high[axis] < seam && other.low[axis] - one.high[axis] < seam) return true;
        }
        return false;
    };
    for (std::size_t i = 0; i < shapes.size(); ++i)
        for (std::size_t j = i + 1; j < shapes.size();) {
            if (!joined(shapes[i], shapes[j])) {
                ++j;
                continue;
            }
            render::Box both = boundsOf(shapes[i]);
            both.include(boundsOf(shapes[j]).low);
            both.include(boundsOf(shapes[j]).high);
            shapes[i] = standingBox(both, shapes[i].color);
            shapes.erase(shapes.begin() + static_cast<std::ptrdiff_t>(j));
            j = i + 1;
        }
}

Furniture furnitureOf(const HallModel& model)
{
    Furniture furniture;
    std::vector<bool> found(model.colliders().size(), false);
    const render::Box* window = openingAlongX(model);
    std::vector<double> depths;
    for (const MeshInstance& part : model.walls()) {
        std::vector<StandingShape> ofPart;
        for (const MeshPiece& piece : piecesOf(*part.mesh)) {
            if (window) addBar(piece.box.transformed(part.modelFromPart), *window, furniture.bars, depths);
            const StandingShape shape = moved(shapeOf(piece, meanColor(model, part)), part.modelFromPart);
            if (const auto collider = colliderOf(model, shape)) {
                ofPart.push_back(shape);
                found[*collider] = true;
            }
        }
        joinBoards(ofPart);
        furniture.shapes.insert(furniture.shapes.end(), ofPart.begin(), ofPart.end());
    }
    const glm::dvec3 rim = model.surfaces().untextured("leather").meanColor;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Collider& collider = model.colliders()[i];
        if (!found[i] && !collider.cylinder && isFurniture(collider))
            furniture.shapes.push_back(moved(standingBox({-collider.halfSize, collider.halfSize}, rim),
                                             glm::inverse(collider.localFromWorld)));
    }
    for (StandingShape& shape : furniture.shapes) countAsBaked(shape);
    if (!depths.empty())
        furniture.bars.z = std::accumulate(depths.begin(), depths.end(), 0.0) / static_cast<double>(depths.size());
    else if (window)
        furniture.bars.z = window->center().z;
    return furniture;
}

std::vector<StandingShape> shapesOf(const HallModel& model, std::span<const MeshInstance> parts)
{
    std::vector<StandingShape> shapes;
    for (const MeshInstance& part : parts)
        for (const MeshPiece& piece : piecesOf(*part.mesh))
            shapes.push_back(moved(shapeOf(piece, meanColor(model, part)), part.modelFromPart));
    return shapes;
}

}  // namespace vitrine::hall
