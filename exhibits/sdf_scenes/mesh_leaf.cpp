#include "exhibits/sdf_scenes/mesh_leaf.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::scenes {
namespace {

constexpr double steepestOfField = 1 + 2e-6;
/// Meters. Points closer to the surface are evaluated with the whole scene, so that leaves with different steps agree
/// about their side.
constexpr double undecided = 1e-9;
/// Vertices keep this share of a cell away from its faces, so that no two of them coincide.
constexpr double margin = 0.01;
/// Directions in which the planes are weaker than this, relative to the strongest, count as undetermined.
constexpr double weakest = 0.01;

/// Computes the eigenvectors of a symmetric matrix, by Jacobi rotations.
void diagonalize(glm::dmat3& m, glm::dmat3& vectors)
{
    vectors = glm::dmat3(1);
    for (int sweep = 0; sweep < 12; ++sweep) {
        double rest = 0;
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                rest += std::abs(m[p][q]);
                if (std::abs(m[p][q]) < 1e-300) continue;
                const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
                const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
                const double c = 1 / std::hypot(t, 1.0), s = t * c;
                glm::dmat3 turn(1);
                turn[p][p] = turn[q][q] = c;
                turn[p][q] = -s;
                turn[q][p] = s;
                m = glm::transpose(turn) * m * turn;
                vectors = vectors * turn;
            }
        if (rest < 1e-15 * (m[0][0] + m[1][1] + m[2][2])) break;
    }
}

}  // namespace

double MeshField::cut(const glm::dvec3& p, double distance) const
{
    if (!std::isfinite(part.low.x)) return distance;
    const glm::dvec3 outside = glm::max(part.low - p, p - part.high);
    const double within = std::min(std::max({outside.x, outside.y, outside.z}), 0.0);
    return std::max(distance, glm::length(glm::max(outside, glm::dvec3(0))) + within);
}

Planes::Planes(const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& normals)
{
    for (const glm::dvec3& p : points) mean_ += p / static_cast<double>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        square_ += glm::outerProduct(normals[i], normals[i]);
        right_ += normals[i] * glm::dot(normals[i], points[i] - mean_);
    }
}

glm::dvec3 Planes::meetingPoint() const
{
    glm::dmat3 values = square_, axes;
    diagonalize(values, axes);
    const double strongest = std::max({values[0][0], values[1][1], values[2][2]});
    glm::dvec3 offset(0);
    for (int i = 0; i < 3; ++i)
        if (values[i][i] > weakest * strongest) offset += axes[i] * (glm::dot(axes[i], right_) / values[i][i]);
    return mean_ + offset;
}

glm::dvec3 Planes::bestPointOf(const render::Box& box) const
{
    // Coordinate descent: the sum of squares is convex.
    const glm::dvec3 low = box.low - mean_, high = box.high - mean_;
    glm::dvec3 offset = glm::clamp(glm::dvec3(0), low, high);
    const double towardMean = 0.01 * (square_[0][0] + square_[1][1] + square_[2][2]);
    for (int round = 0; round < 24; ++round)
        for (int i = 0; i < 3; ++i) {
            const double rest = right_[i] - glm::dot(square_[i], offset) + square_[i][i] * offset[i];
            offset[i] = std::clamp(rest / (square_[i][i] + towardMean), low[i], high[i]);
        }
    return mean_ + offset;
}

LeafMesher::LeafMesher(const MeshField& field)
    : field_(field), walk_(field.scene.program(), field.scene.words().words, false),
      colors_(field.scene.program(), field.scene.words().words, true)
{
}

double LeafMesher::distance(const glm::dvec3& p)
{
    ++evaluations_;
    walk_.run(*steps_, p);
    return field_.cut(p, walk_.state(0).distance);
}

void LeafMesher::findNear(MeshLeaf& leaf)
{
    steps_ = leaf.steps.get();
    findNear(leaf, glm::ivec3(0), leafCells);
}

void LeafMesher::findNear(MeshLeaf& leaf, const glm::ivec3& low, int size)
{
    const double half = 0.5 * size;
    const double d = distance(field_.at(glm::dvec3(leaf.low + low) + half));
    if (std::abs(d) > half * std::sqrt(3.0) * field_.cell * steepestOfField + undecided) return;
    if (size == 1) {
        const std::size_t cell = cellOfLeaf(low.x, low.y, low.z);
        leaf.near.set(cell);
        leaf.middleInside.set(cell, d < 0);
        return;
    }
    for (int corner = 0; corner < 8; ++corner)
        findNear(leaf, low + size / 2 * glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2), size / 2);
}

double LeafMesher::cornerValue(const glm::ivec3& corner)
{
    double& value = values_[static_cast<std::size_t>((corner.z * corners_ + corner.y) * corners_ + corner.x)];
    if (!std::isnan(value)) return value;
    const glm::dvec3 p = field_.at(glm::dvec3(low_ + corner));
    value = distance(p);
    if (std::abs(value) < undecided) {
        ++evaluations_;
        walk_.run(field_.scene.program().steps(), p);
        value = field_.cut(p, walk_.state(0).distance);
    }
    return value;
}

glm::dvec3 LeafMesher::slopeAt(const glm::dvec3& p, double d)
{
    const double h = 1e-4 * field_.cell;
    const glm::dvec3 there(distance(p + glm::dvec3(h, 0, 0)), distance(p + glm::dvec3(0, h, 0)),
                           distance(p + glm::dvec3(0, 0, h)));
    return (there - d) / h;
}

/// Returns a vertex of a cell. A thin wedge may end beyond the last cell that contains a lattice point of it. So if the
/// planes meet up to two cells away and the surface is close, the vertex is placed there. A small margin keeps it from
/// coinciding with another vertex.
glm::dvec3 LeafMesher::vertexOf(const Planes& planes, const render::Box& cell)
{
    const glm::dvec3 meeting = planes.meetingPoint();
    if (cell.contains(meeting)) return broughtToSurface(meeting, cell);
    const glm::dvec3 inside = glm::clamp(meeting, cell.low, cell.high);
    const render::Box around = grown(cell, 2 * field_.cell);
    if (around.contains(meeting) && std::abs(distance(meeting)) < 0.2 * field_.cell)
        return glm::mix(inside, broughtToSurface(meeting, around), 1 - margin);
    return broughtToSurface(planes.bestPointOf(cell), cell);
}

/// Moves a point onto the surface, as far as the cell extends; at a sharp edge it is already there.
glm::dvec3 LeafMesher::broughtToSurface(glm::dvec3 p, const render::Box& cell)
{
    for (int round = 0; round < 16; ++round) {
        const double d = distance(p);
        if (std::abs(d) < 1e-3 * field_.cell) break;
        const glm::dvec3 slope = slopeAt(p, d);
        const double square = glm::dot(slope, slope);
        if (!(square > 1e-6)) break;
        p = glm::clamp(p - slope * (d / std::max(square, 0.1)), cell.low, cell.high);
    }
    return p;
}

LeafMesher::Crossing LeafMesher::crossingBetween(const glm::dvec3& a, const glm::dvec3& b, double valueA, double valueB)
{
    // Secant method with bracketing (regula falsi, Illinois).
    double low = 0, high = 1, atLow = valueA, atHigh = valueB, t = 0.5;
    int side = 0;
    for (int i = 0; i < 12; ++i) {
        t = std::clamp(low + (high - low) * atLow / (atLow - atHigh), low, high);
        const double d = distance(glm::mix(a, b, t));
        if (std::abs(d) < 1e-5 * field_.cell) break;
        const bool likeLow = (d < 0) == (valueA < 0);
        (likeLow ? low : high) = t;
        (likeLow ? atLow : atHigh) = d;
        if (side == (likeLow ? 1 : -1)) (likeLow ? atHigh : atLow) *= 0.5;
        side = likeLow ? 1 : -1;
    }
    const glm::dvec3 p = glm::mix(a, b, std::clamp(t, margin, 1 - margin));
    const glm::dvec3 slope = slopeAt(p, distance(p));
    const double length = glm::length(slope);
    return {p, length > 1e-6 ? slope / length : glm::normalize(b - a) * (valueA < 0 ? 1.0 : -1.0)};
}

const LeafMesher::Crossing& LeafMesher::crossingAt(const glm::ivec3& corner, unsigned axis)
{
    std::int32_t& known =
        crossingOf_[3 * static_cast<std::size_t>((corner.z * corners_ + corner.y) * corners_ + corner.x) + axis];
    if (known < 0) {
        glm::ivec3 end = corner;
        ++end[static_cast<int>(axis)];
        known = static_cast<std::int32_t>(crossings_.size());
        crossings_.push_back(crossingBetween(field_.at(glm::dvec3(low_ + corner)), field_.at(glm::dvec3(low_ + end)),
                                             cornerValue(corner), cornerValue(end)));
    }
    return crossings_[static_cast<std::size_t>(known)];
}

MeshVertex LeafMesher::vertexAt(const glm::dvec3& p, const glm::dvec3& normal)
{
    colors_.run(*steps_, p);
    ++evaluations_;
    const auto& m = colors_.surface(0).material;
    return {glm::vec3(p), glm::vec3(normal), glm::clamp(glm::vec3(m[0], m[1], m[2]), 0.0F, 1.0F)};
}

void LeafMesher::addVertices(const glm::ivec3& place, unsigned inside, LeafSurface& surface)
{
    const CellLoops& loops = cellLoops(inside);
    const render::Box cell{field_.at(glm::dvec3(low_ + place) + margin),
                           field_.at(glm::dvec3(low_ + place) + (1 - margin))};
    std::array<glm::dvec3, 4> at{}, means{}, normals{};
    std::vector<glm::dvec3> points, planes;
    for (int loop = 0; loop < loops.loops; ++loop) {
        const auto k = static_cast<std::size_t>(loop);
        points.clear();
        planes.clear();
        for (unsigned e = 0; e < 12; ++e) {
            if (loops.loopOf[e] != loop) continue;
            const unsigned start = edgeStart(e);
            const glm::ivec3 corner = place + glm::ivec3(start & 1U, start >> 1U & 1U, start >> 2U);
            const Crossing& crossing = crossingAt(corner, e / 4);
            points.push_back(crossing.position);
            planes.push_back(crossing.normal);
            means[k] += crossing.position;
            normals[k] += crossing.normal;
        }
        means[k] /= static_cast<double>(points.size());
        const double length = glm::length(normals[k]);
        normals[k] = length > 1e-6 ? normals[k] / length : planes.front();
        at[k] = vertexOf(Planes(points, planes), cell);
    }
    // Loops that meet, as those of a thin wall may, are kept apart.
    for (std::size_t a = 0; a < static_cast<std::size_t>(loops.loops); ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (glm::distance(at[a], at[b]) < margin * field_.cell) {
                at[a] = glm::clamp(means[a], cell.low, cell.high);
                at[b] = glm::clamp(means[b], cell.low, cell.high);
            }
    for (std::size_t k = 0; k < static_cast<std::size_t>(loops.loops); ++k)
        surface.vertices.push_back(vertexAt(at[k], normals[k]));
}

std::size_t LeafMesher::findSurface(const MeshLeaf& leaf, LeafSurface& surface)
{
    steps_ = leaf.steps.get();
    low_ = leaf.low;
    values_.fill(std::numeric_limits<double>::quiet_NaN());
    crossingOf_.fill(-1);
    crossings_.clear();
    std::size_t lost = 0;
    for (std::size_t cell = 0; cell < leafVolume; ++cell) {
        if (!leaf.near[cell]) continue;
        const glm::ivec3 place = placeInLeaf(cell);
        unsigned inside = 0;
        for (unsigned corner = 0; corner < 8; ++corner)
            if (cornerValue(place + glm::ivec3(corner & 1U, corner >> 1U & 1U, corner >> 2U)) < 0)
                inside |= 1U << corner;
        if (inside == 0 || inside == 255) {
            lost += leaf.middleInside[cell] != (inside == 255);
            continue;
        }
        surface.inside[cell] = static_cast<std::uint8_t>(inside);
        surface.firstVertex[cell] = static_cast<std::uint32_t>(surface.vertices.size());
        addVertices(place, inside, surface);
        for (unsigned axis = 0; axis < 3; ++axis) {
            if ((inside & 1U) == (inside >> (1U << axis) & 1U)) continue;
            const Crossing& crossing = crossingAt(place, axis);
            surface.edges.push_back({static_cast<std::uint16_t>(cell), static_cast<std::uint8_t>(axis),
                                     (inside & 1U) != 0, glm::vec3(crossing.position), glm::vec3(crossing.normal)});
        }
    }
    return lost;
}

}  // namespace vitrine::scenes
