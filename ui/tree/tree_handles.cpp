#include "ui/tree/tree_handles.h"

#include "ui/tree/tree_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vitrine::ui {
namespace {

constexpr double reach = 76;       ///< Pixels from the center to the end of a handle.
constexpr double grabWithin = 7;   ///< Pixels.
constexpr double shortest = 0.15;  ///< Part of `reach`. A handle that looks shorter points at the eye.
constexpr int ringPoints = 64;

double dot(const QPointF& a, const QPointF& b)
{
    return a.x() * b.x() + a.y() * b.y();
}

/// Returns the axes in the parent's space along or about which the three numbers of a place act.
glm::dmat3 axesOf(HandleMode mode, const TreePlace& place)
{
    if (mode == HandleMode::move) return glm::dmat3(1);
    if (mode == HandleMode::scale) return place.rotation();
    // Rotations apply about z first, then y, then x: each axis is turned by the later ones.
    TreePlace aboutX = place, aboutXy = place;
    aboutX.rotate = {place.rotate.x, 0, 0};
    aboutXy.rotate = {place.rotate.x, place.rotate.y, 0};
    return {glm::dvec3(1, 0, 0), aboutX.rotation()[1], aboutXy.rotation()[2]};
}

/// Projection of points in the parent's space to pixels of the widget.
struct Projector {
    glm::dmat4 worldFromParent;
    const render::View& view;
    QSizeF widget;

    [[nodiscard]] std::optional<QPointF> at(const glm::dvec3& p) const
    {
        return onScreen(view, widget, glm::dvec3(worldFromParent * glm::dvec4(p, 1)));
    }
    /// Returns the pixels per meter of the parent's space, across the view, at p.
    [[nodiscard]] double pixelsPerMeter(const glm::dvec3& p) const
    {
        const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(worldFromParent))));
        const double depth = (view.clipFromWorld * (worldFromParent * glm::dvec4(p, 1))).w;
        return scale * widget.height() / (2 * view.tanHalfFov.y * std::max(depth, 1e-6));
    }
};

std::optional<Handle> arrow(int axis, HandleMode mode, const Projector& project, const glm::dvec3& middle,
                            const glm::dvec3& along, double scale)
{
    const double perMeter = project.pixelsPerMeter(middle);
    const double length = reach / perMeter;
    const auto from = project.at(middle), to = project.at(middle + length * along);
    if (!from || !to) return std::nullopt;
    const QPointF line = *to - *from;
    if (std::sqrt(dot(line, line)) < shortest * reach) return std::nullopt;
    // Twice the distance from the center is twice the size.
    const QPointF perUnit = mode == HandleMode::scale ? line / std::max(std::abs(scale), 1e-9) : line / length;
    return Handle{axis, {*from, *to}, {perUnit, perUnit}};
}

std::optional<Handle> ring(int axis, const Projector& project, const glm::dvec3& middle, const glm::dvec3& about)
{
    const double radius = reach / project.pixelsPerMeter(middle);
    const glm::dvec3 other = std::abs(about.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(other, about)), v = glm::cross(about, u);
    Handle handle{axis, {}, {}};
    for (int i = 0; i <= ringPoints; ++i) {
        const double angle = 2 * std::numbers::pi * i / ringPoints;
        const auto at = [&](double a) { return project.at(middle + radius * (std::cos(a) * u + std::sin(a) * v)); };
        const auto here = at(angle), next = at(angle + 1e-4);
        if (!here || !next) return std::nullopt;
        handle.line.push_back(*here);
        handle.perUnit.push_back((*next - *here) / 1e-4);
    }
    return handle;
}

double toLine(const QPointF& p, const QPointF& a, const QPointF& b)
{
    const QPointF ab = b - a;
    const double t = std::clamp(dot(p - a, ab) / std::max(dot(ab, ab), 1e-12), 0.0, 1.0);
    const QPointF away = p - (a + t * ab);
    return std::sqrt(dot(away, away));
}

double rounded(double x, double step)
{
    return std::round(x / step) * step;
}

}  // namespace

std::vector<Handle> handlesOf(HandleMode mode, const TreePlace& place, const glm::dmat4& worldFromExhibit,
                              const render::View& view, const QSizeF& widget)
{
    std::vector<Handle> handles;
    if (mode == HandleMode::none) return handles;
    const Projector project{worldFromExhibit * place.exhibitFromParent, view, widget};
    const glm::dmat3 axes = axesOf(mode, place);
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 along = glm::normalize(axes[axis]);
        if (auto handle = mode == HandleMode::turn
                              ? ring(axis, project, place.translate, along)
                              : arrow(axis, mode, project, place.translate, along, place.scale[axis]))
            handles.push_back(std::move(*handle));
    }
    return handles;
}

std::optional<Grip> gripAt(const std::vector<Handle>& handles, const QPointF& pointer)
{
    std::optional<Grip> best;
    double nearest = grabWithin;
    for (std::size_t h = 0; h < handles.size(); ++h)
        for (std::size_t i = 0; i + 1 < handles[h].line.size(); ++i) {
            const double distance = toLine(pointer, handles[h].line[i], handles[h].line[i + 1]);
            if (distance >= nearest) continue;
            nearest = distance;
            best = Grip{h, i};
        }
    return best;
}

TreePlace dragged(HandleMode mode, const TreePlace& from, const Handle& handle, std::size_t point, const QPointF& moved)
{
    TreePlace to = from;
    const QPointF perUnit = handle.perUnit[point];
    const double amount = dot(moved, perUnit) / std::max(dot(perUnit, perUnit), 1e-12);
    if (mode == HandleMode::move)
        to.translate[handle.axis] = rounded(from.translate[handle.axis] + amount, 1e-4);
    else if (mode == HandleMode::turn)
        to.rotate[handle.axis] = rounded(from.rotate[handle.axis] + amount, std::numbers::pi / 18000);
    else if (mode == HandleMode::scale)
        to.scale[handle.axis] = std::max(rounded(from.scale[handle.axis] + amount, 1e-4), 1e-3);
    return to;
}

}  // namespace vitrine::ui
