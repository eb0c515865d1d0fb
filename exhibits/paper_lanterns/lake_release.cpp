#include "exhibits/paper_lanterns/lake_release.h"

#include "exhibits/kit/blue_noise.h"
#include "exhibits/paper_lanterns/paper_lanterns_cpu.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::paper_lanterns {
namespace {

constexpr double ownSpeed = 0.55;             ///< Meters per second of a lantern that drifts away.
constexpr double secondsBetweenPlaces = 0.1;  ///< Time step along its path, seconds.
constexpr double beginsToTurn = 1;            ///< Meters from another lantern at which it begins to turn.
constexpr double renewsAfter = 0.5;           ///< Meters of travel after which nearby lanterns are searched again.

/// A lantern on the water, in the frame of reference that drifts with the lattice.
struct Floating {
    glm::dvec2 place{0};
    double turn = 0;
    double light = 0;
    double hue = 0;
    glm::ivec2 number{0};  ///< Number of its cell.
};

/// Water along its path: the other lanterns, and the distance to keep from them.
struct Waterway {
    glsl::Lake lake;
    glm::dvec2 corner{0};         ///< Corner of cell (0, 0).
    glm::dvec2 driftVelocity{0};  ///< Velocity of the lattice.
    double tube = 0;              ///< Radius within which a leaning tube stays.
    double lean = 0;
    double farther = 0;  ///< Extension of the search range, meters.
    std::optional<glm::ivec2> freed = {};
    std::map<std::pair<int, int>, std::optional<Floating>> known = {};  ///< Lanterns by cell number, y first.
    mutable ReleaseWork work = {};

    /// Returns half the extent of a lantern with this turn along a unit direction.
    [[nodiscard]] double halfExtent(double turn, const glm::dvec2& u) const
    {
        const double c = std::cos(turn), s = std::sin(turn);
        const double base = lake.lake.baseHalfWidth * (std::abs(u.x * c + u.y * s) + std::abs(u.y * c - u.x * s));
        return std::max(base + lake.lake.baseHalfHeight * lean + 0.02, tube);
    }

    /// Returns the distance between centers beyond which the gap exceeds `beginsToTurn`.
    [[nodiscard]] double sight() const { return 2 * lake.lake.reach + beginsToTurn; }

    /// Returns the gap between a lantern and another one, and the direction away from the other; below 0 they may
    /// touch. For distant ones it returns a lower bound.
    [[nodiscard]] double gap(const glm::dvec2& place, double turn, const Floating& other, glm::dvec2& away) const
    {
        ++work.gaps;
        const glm::dvec2 apart = place - other.place;
        const double distance = glm::length(apart);
        away = distance > 1e-9 ? apart / distance : glm::dvec2(1, 0);
        if (distance > sight()) return distance - 2 * lake.lake.reach;
        return distance - halfExtent(turn, away) - halfExtent(other.turn, away);
    }

    /// Returns the lantern in a cell; none if the cell is empty.
    [[nodiscard]] const std::optional<Floating>& numbered(const glm::ivec2& number)
    {
        const auto [found, isNew] = known.try_emplace({number.y, number.x});
        if (!isNew) return found->second;
        ++work.lanterns;
        const auto lantern = lake.lanternOfCell(number - lake.lake.firstCell);
        if (lantern.light < 0 || number == freed) return found->second;
        // Drift is excluded, since float32 would round it differently at each time.
        const glm::dvec2 middle = corner + lake.lake.cell * glm::dvec2(number.x + 0.5, -number.y - 0.5);
        found->second = {middle + lake.offMiddle(number), lantern.turn, lantern.light, lantern.hue, number};
        return found->second;
    }

    /// Returns all lanterns whose center is within a distance, row by row, for the lattice at a time.
    [[nodiscard]] std::vector<Floating> within(const glm::dvec2& place, double distance, double seconds)
    {
        const glm::dvec2 at = glm::dvec2(place.x - corner.x, corner.y - place.y) / lake.lake.cell;
        const glm::dvec2 half(distance / lake.lake.cell);
        const glm::dvec2 begin(firstCellAt(seconds * driftVelocity, lake.lake.cell));
        const glm::ivec2 cells = glm::max(lake.lake.cells, glm::ivec2(1));
        const glm::dvec2 last = begin + glm::dvec2(cells - 1);
        const glm::ivec2 low(glm::clamp(glm::floor(at - half), begin, last));
        const glm::ivec2 high(glm::clamp(glm::floor(at + half), begin, last));
        std::vector<Floating> found;
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                if (const auto& other = numbered({x, y}); other && glm::distance(other->place, place) <= distance)
                    found.push_back(*other);
        return found;
    }
};

double leastGap(const Waterway& way, const std::vector<Floating>& others, const glm::dvec2& place, double turn)
{
    double least = std::numeric_limits<double>::infinity();
    glm::dvec2 away;
    for (const Floating& other : others) least = std::min(least, way.gap(place, turn, other, away));
    return least;
}

Waterway waterwayOf(const PaperLanternsTable& t, const ParameterValues& values, const LakeBlock& block)
{
    static const std::shared_ptr<const render::Texture> noise = blueNoise();
    Waterway way;
    copyLake(way.lake.lake, block);
    way.lake.blueNoise = noise->bytes.data();
    way.corner = latticeCorner(t, values, way.lake.lake.cell);
    way.driftVelocity = values[t.drift] * windOf(t, values);
    way.tube = static_cast<double>(tubeReach(block));
    way.lean = static_cast<double>(mostLean(block));
    return way;
}

/// Returns the lantern to release: a new one if there is room around the place, else the nearest one.
Floating setFree(Waterway& way, const glm::dvec2& wanted, double at)
{
    constexpr double room = 0.25, farthest = 4;
    const std::vector<Floating> others =
        way.within(wanted, farthest + 2 * way.lake.lake.reach + room + way.farther, at);
    const auto hasRoom = [&](const Floating& free) {
        glm::dvec2 away;
        return std::all_of(others.begin(), others.end(),
                           [&](const Floating& other) { return way.gap(free.place, free.turn, other, away) >= room; });
    };
    Floating free{wanted, 0.6, 0, 0, {}};
    for (double off = 0; off <= farthest; off += 0.5)
        for (int i = 0; i < (off > 0 ? 12 : 1); ++i) {
            const double angle = 2 * std::numbers::pi * i / 12;
            free.place = wanted + off * glm::dvec2(std::cos(angle), std::sin(angle));
            if (hasRoom(free)) return free;
        }
    free = *std::min_element(others.begin(), others.end(), [&](const Floating& a, const Floating& b) {
        return glm::distance(a.place, wanted) < glm::distance(b.place, wanted);
    });
    way.freed = free.number;
    way.known.erase({free.number.y, free.number.x});
    return free;
}

/// Returns the velocity: `wanted`, without the part towards nearby lanterns, which is turned along them instead.
glm::dvec2 steered(const Waterway& way, const std::vector<Floating>& near, const glm::dvec2& place, double turn,
                   const glm::dvec2& wanted)
{
    glm::dvec2 velocity = wanted, away;
    for (const Floating& other : near) {
        const double gap = way.gap(place, turn, other, away);
        const double towards = -glm::dot(velocity, away);
        if (gap > beginsToTurn || towards <= 0) continue;
        const double share = 1 - glm::smoothstep(0.0, beginsToTurn, gap);
        const glm::dvec2 along(-away.y, away.x);
        const double side = glm::dot(velocity, along) < 0 ? -1 : 1;
        velocity += share * towards * (away + 0.7 * side * along);
    }
    return velocity;
}

/// Moves the place away from lanterns that it would touch.
glm::dvec2 keptClear(const Waterway& way, const std::vector<Floating>& near, const glm::dvec2& from,
                     const glm::dvec2& to, double turn)
{
    glm::dvec2 place = to, away;
    for (int round = 0; round < 4; ++round) {
        bool moved = false;
        for (const Floating& other : near)
            if (const double gap = way.gap(place, turn, other, away); gap < 0) {
                place -= gap * away;
                moved = true;
            }
        if (!moved) return place;
    }
    // If two other lanterns leave no room between them, the released lantern stays in place.
    const double least = leastGap(way, near, place, turn);
    return least >= -1e-3 || least >= leastGap(way, near, from, turn) ? place : from;
}

double heightOver(double since)
{
    return 0.5 * since * since / (since + 3);
}

/// Cache of the lanterns near the released one.
class Company {
public:
    explicit Company(Waterway& way) : way_(way) {}

    [[nodiscard]] const std::vector<Floating>& at(const glm::dvec2& place, double seconds)
    {
        const glm::ivec2 first = firstCellAt(seconds * way_.driftVelocity, way_.lake.lake.cell);
        if (first_ != first || glm::distance(place, middle_) > renewsAfter) {
            // A step is shorter than `beginsToTurn`, so the list includes all lanterns that the released one may touch
            // on the way.
            near_ = way_.within(place, way_.sight() + renewsAfter + way_.farther, seconds);
            middle_ = place;
            first_ = first;
        }
        return near_;
    }

private:
    Waterway& way_;
    std::vector<Floating> near_;
    glm::dvec2 middle_{0};
    std::optional<glm::ivec2> first_;  ///< First cell of the lattice for which the list was made.
};

/// Returns the place after the time since the press, in the frame that drifts with the lattice.
glm::dvec2 placeAfter(Waterway& way, const Floating& free, bool rises, const glm::dvec2& wind, const LakePress& press)
{
    glm::dvec2 place = free.place;
    const double clearOver = way.lake.lake.high - way.lake.lake.low;
    Company company(way);
    for (double time = 0; time < press.since; time += secondsBetweenPlaces) {
        const double step = std::min(secondsBetweenPlaces, press.since - time);
        const glm::dvec2 wanted = rises ? 0.036 * time * wind : ownSpeed * straightAhead();
        if (rises && heightOver(time) > clearOver) {
            place += step * wanted;
            continue;
        }
        const std::vector<Floating>& near = company.at(place, press.at + time);
        const glm::dvec2 velocity = steered(way, near, place, free.turn, wanted);
        const glm::dvec2 next = keptClear(way, near, place, place + step * velocity, free.turn);
        // The released lantern has stopped, because other lanterns leave no room.
        if (!rises && step == secondsBetweenPlaces && next == place) break;
        place = next;
    }
    return place;
}

}  // namespace

ReleaseWork setReleased(const PaperLanternsTable& t, const ParameterValues& values, double seconds,
                        const LakePress& press, LakeBlock& block, double farther)
{
    const double since = press.since;
    block.released = glm::vec4(0, 0, 0, -1);
    block.freedCell = glm::ivec2(std::numeric_limits<int>::min());
    if (!(since >= 0) || !std::isfinite(since)) return {};
    const glm::dvec2 ahead = straightAhead(), wind = windOf(t, values);
    const glm::dvec2 drifted = values[t.drift] * seconds * wind;
    const glm::dvec2 begin = 9.5 * ahead - 1.1 * glm::dvec2(-ahead.y, ahead.x);
    const glm::dvec2 wanted = begin - values[t.drift] * press.at * wind;
    Waterway way = waterwayOf(t, values, block);
    way.farther = farther;
    const Floating free = setFree(way, wanted, press.at);
    if (way.freed) block.freedCell = *way.freed;
    if (since >= releasedFor) return way.work;
    const bool rises = values[t.release] == LakeRelease::rises;
    const glm::dvec2 place = drifted + placeAfter(way, free, rises, wind, press);
    const auto ride = way.lake.rideAt(place);
    double height = ride.height;
    glm::dvec2 tilt = ride.slope;
    if (rises) {
        const double wet = std::exp(-since);
        height = height * wet + heightOver(since);
        tilt = tilt * wet + (1 - wet) * 0.06 * glm::dvec2(std::sin(1.1 * since), std::cos(0.9 * since));
    }
    // A new lantern is lit at first; at the end it burns down.
    const double light = free.light > 0 ? free.light : 0.75 * std::min(1.0, 0.25 + since);
    block.released = glm::vec4(place.x, height, place.y, light * std::min(1.0, (releasedFor - since) / 8));
    block.releasedPose = glm::vec4(glm::vec2(tilt), free.turn, free.hue);
    return way.work;
}

}  // namespace vitrine::paper_lanterns
