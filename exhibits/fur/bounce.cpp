#include "exhibits/fur/bounce.h"

#include "exhibits/fur/rigid_bodies.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace vitrine::fur {
namespace {

// Places of the bodies at rest, in meters from the center of the pit, and their rotations about y.
const glm::dvec3 homes[furBodyCount] = {{-0.62, 0, -0.02}, {0.55, 0, 0.58}, {0.30, 0, -0.74}};
constexpr double homeTurns[furBodyCount] = {0, 0.35, 0.2};

constexpr double gravity = 9.81;      ///< m/s².
constexpr double strandScale = 0.15;  ///< Meters of lag that count as one strand length: a strand of the reference.
// A throw has the mean speed `jump`. These shares of it vary the upward speed and the two horizontal ones.
constexpr double throwUp = 0.16, throwAside = 0.35;
constexpr double landing =
    pitRadius + pitPadRadius;      ///< Meters from the axis; throws that would land farther out are made steeper.
constexpr double homeStart = 1.5;  ///< Seconds after which bodies that are not at their places hop there.
constexpr double nearHome = 0.04, nearTurn = 0.12;  ///< Meters and radians within which a body counts as at its place.
constexpr double hopLeast = 0.02, hopMost = 0.6;    ///< Height of a hop, meters.
constexpr double braking = 8;     ///< Deceleration rate of sliding and rolling bodies at their places, 1/s.
constexpr double calm = 0.3;      ///< Seconds for which all bodies have to lie still.
constexpr double settling = 0.5;  ///< Seconds in which the last millimeters are interpolated.
constexpr double dt = 1.0 / Bounce::stepsPerSecond;

double skinRadius(int body)
{
    return body == furBall ? ballRadius : body == furRoll ? rollRadius : ringTube;
}

double smooth(double low, double high, double x)
{
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Returns random number `i` of a throw, in [-1, 1): integer hash (splitmix64, Steele et al. 2014).
double throwOf(std::uint32_t toss, int i)
{
    std::uint64_t z = (static_cast<std::uint64_t>(toss) << 32U) +
                      static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15ULL + 0x632BE59BD9B4E019ULL;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) / static_cast<double>(1ULL << 52U) - 1;
}

/// Returns the velocity at which a body leaves the ground, m/s.
glm::dvec3 throwVelocity(const BounceSettings& s, int body)
{
    const auto random = [&](int n) { return throwOf(s.toss, 16 * body + n); };
    glm::dvec3 velocity = s.jump * glm::dvec3(throwAside * random(0), 1 + throwUp * random(1), throwAside * random(2));
    const glm::dvec3 aside = glm::dvec3(velocity.x, 0, velocity.z) * (2 * velocity.y / gravity);
    // Finds where the straight path from home leaves the circle of landing: |home + t aside| = landing.
    const double a = glm::dot(aside, aside);
    const double b = glm::dot(aside, homes[body]);
    const double c = glm::dot(homes[body], homes[body]) - landing * landing;
    if (a + 2 * b + c <= 0) return velocity;
    const double t = (std::sqrt(b * b - a * c) - b) / a;
    return {velocity.x * t, velocity.y, velocity.z * t};
}

glm::dquat homeTurn(int body)
{
    return glm::angleAxis(homeTurns[body], glm::dvec3(0, 1, 0));
}

/// Returns the height in meters of the center of a body that rests on the floor.
double restHeight(const BounceSettings& s, int body, double skinScale)
{
    if (body == furRing && s.model) return s.cushion[body] - s.model->bounds.low.y;
    return skinRadius(body) * skinScale + s.cushion[body];
}

/// Returns an upper bound of `restHeight`, whatever skin the third body has.
double heightOfStart(const BounceSettings& s, int body)
{
    return s.cushion[body] + (body == furBall   ? ballRadius * s.growth.largest()
                              : body == furRoll ? rollRadius
                                                : ringRadius + ringTube);
}

RigidShape shapeOf(const BounceSettings& s, int body)
{
    const double radius = skinRadius(body) + s.cushion[body];
    if (body == furBall) return BallShape{radius};
    if (body == furRoll) return RollShape{radius, rollHalfLength};
    if (!s.model) return RingShape{ringRadius, radius};
    HullShape hull;
    hull.margin = s.cushion[body];
    // Bullet's convex hulls are made for few points. About a thousand points of a large model show its shape well
    // enough.
    const std::size_t stride = s.model->vertices.size() / 1000 + 1;
    for (std::size_t i = 0; i < s.model->vertices.size(); i += stride)
        hull.points.emplace_back(s.model->vertices[i].position);
    return hull;
}

}  // namespace

double Growth::skinScale(double since) const
{
    if (!(rate > 0) || amount == 0) return 1;
    const double share = always ? 1 : smooth(0, 0.3, since) * (1 - smooth(2.5, 4.5, since));
    const double phase = std::fmod(rate * (always ? start + since : since), 1.0);
    return 1 + share * amount / ballRadius * std::sin(2 * std::numbers::pi * phase);
}

double Growth::largest() const
{
    return rate > 0 ? 1 + amount / ballRadius : 1;
}

BounceSettings bounceSettings(const FurTable& table, const ParameterValues& v,
                              std::shared_ptr<const render::Mesh> model, double time)
{
    BounceSettings s;
    for (int i = 0; i < furBodyCount; ++i) s.cushion[i] = colliderRadius(table, v, i, 1) - skinRadius(i);
    s.model = std::move(model);
    s.jump = v[table.jump];
    s.toss = static_cast<std::uint32_t>(v[table.toss]);
    const bool growing = v[table.growing] && !v[table.byHand];  // With `byHand`, the bodies keep still.
    s.growth = {v[table.growth], v[table.growthRate], growing, growing ? time : 0.0};
    s.spring = {2 * std::numbers::pi * v[table.frequency], v[table.damping]};
    s.method = v[table.springModel];
    s.springRate = v[table.springRate];
    s.inertia = v[table.inertia];
    s.gravity = v[table.gravity];
    s.airDrag = v[table.airDrag];
    s.strength = v[table.strength];
    s.displacementLimit = v[table.displacementLimit];
    s.rotationLimit = v[table.rotationLimit];
    return s;
}

std::string keyOf(const BounceSettings& s)
{
    std::string key;
    const auto add = [&key](double x) { key += std::to_string(std::bit_cast<std::uint64_t>(x)) + ' '; };
    for (const double cushion : s.cushion) add(cushion);
    for (const double x : {s.growth.amount, s.growth.rate, s.growth.start, s.spring.omega, s.spring.zeta, s.jump,
                           s.inertia, s.gravity, s.airDrag, s.strength, s.displacementLimit, s.rotationLimit})
        add(x);
    for (const std::int64_t n : {std::int64_t{s.toss}, std::int64_t{s.growth.always},
                                 std::int64_t{static_cast<int>(s.method)}, std::int64_t{s.springRate}})
        key += std::to_string(n) + ' ';
    return key;
}

Flight flightOf(const BounceSettings& s, int body)
{
    const double fastest = s.jump * glm::length(glm::dvec3(throwAside, 1 + throwUp, throwAside));
    return {heightOfStart(s, body) + fastest * fastest / (2 * gravity), pitRadius + 1};
}

render::Box bouncingSpace(const FurTable& table, const ParameterValues& values, bool jumping)
{
    const BounceSettings s = bounceSettings(table, values, nullptr, 0);
    render::Box space;
    for (int i = 0; i < furBodyCount; ++i) {
        // Strands keep their length within 1 %. A millimeter is added as a margin.
        const double reach = (i == furBall   ? ballRadius * s.growth.largest()
                              : i == furRoll ? rollRadius + rollHalfLength
                                             : ringRadius + ringTube) +
                             1.02 * values[table.coats[static_cast<std::size_t>(i)].length] + 1e-3;
        const Flight flight = flightOf(s, i);
        space.include(homes[i] + glm::dvec3(-reach, 0, -reach));
        space.include(homes[i] + glm::dvec3(reach, heightOfStart(s, i) + reach, reach));
        if (!jumping) continue;
        space.include({-flight.farthest - reach, 0, -flight.farthest - reach});
        space.include({flight.farthest + reach, flight.highest + reach, flight.farthest + reach});
    }
    return space;
}

FurStates restStates(const BounceSettings& s, double since)
{
    FurStates states;
    for (int i = 0; i < furBodyCount; ++i) {
        FurState& state = states[static_cast<std::size_t>(i)];
        state.skinScale = i == furBall ? s.growth.skinScale(since) : 1;
        state.position = homes[i] + glm::dvec3(0, restHeight(s, i, state.skinScale), 0);
        state.rotation = homeTurn(i);
        state.tipOffset = limited({{0, -s.gravity, 0}, {}}, s.displacementLimit).value * s.strength;
    }
    return states;
}

struct Bounce::World {
    RigidBodies bodies{{pitRadius, pitRim, pitPadRadius, pitPadLift, gravity}};
    double nextHop[furBodyCount] = {};  ///< Seconds; earliest time at which the body hops again.
    glm::dvec3 lastVelocity[furBodyCount] = {};
    glm::dvec3 lastSpin[furBodyCount] = {};
    double calmSince = 0;  ///< Seconds.
    MotionState asleep{};  ///< State in which the bodies stopped.
};

Bounce::Bounce(const BounceSettings& settings) : settings_(settings), world_(std::make_unique<World>())
{
    const FurStates rest = restStates(settings_);
    MotionState first;
    for (int i = 0; i < furBodyCount; ++i) {
        const FurState& state = rest[static_cast<std::size_t>(i)];
        first.position[i] = state.position;
        first.rotation[i] = state.rotation;
        first.tipOffset[i] = limited({{0, -settings_.gravity, 0}, {}}, settings_.displacementLimit);
        const int body =
            world_->bodies.add(shapeOf(settings_, i), {state.position, state.rotation}, i == furBall ? 2.2 : 2.0);
        const auto random = [&](int n) { return throwOf(settings_.toss, 16 * i + n); };
        const glm::dvec3 spin(random(3), 0.6 * random(4), random(5));
        world_->bodies.accelerate(body, throwVelocity(settings_, i), spin * (2.2 * settings_.jump));
    }
    motion_.push_back(first);
}

Bounce::~Bounce() = default;

std::int64_t Bounce::steps() const
{
    return steps_;
}

/// Keeps a body within its flight limits, so nothing is drawn outside its bounds. Collisions and the growing ball may
/// give it no more energy than the fastest throw.
void Bounce::hold()
{
    for (int i = 0; i < furBodyCount; ++i) {
        const Flight flight = flightOf(settings_, i);
        glm::dvec3 at = world_->bodies.pose(i).position;
        glm::dvec3 velocity = world_->bodies.velocity(i);
        const glm::dvec3 was = at;
        const double left = 2 * gravity * std::max(flight.highest - at.y, 0.0);
        const double squared = glm::dot(velocity, velocity);
        const bool fast = squared > left;
        if (fast) velocity *= std::sqrt(left / squared);
        at.y = std::min(at.y, flight.highest);
        const double out = std::hypot(at.x, at.z);
        if (out > flight.farthest) {
            const glm::dvec3 outwards = glm::dvec3(at.x, 0, at.z) / out;
            at -= outwards * (out - flight.farthest);
            velocity -= outwards * std::max(glm::dot(velocity, outwards), 0.0);
        }
        if (fast || at != was) world_->bodies.move(i, at, velocity);
    }
}

/// Brings the bodies back to their places, so the next press begins where this one ends. A body that lies elsewhere, or
/// is turned differently, hops to its place, over the rim if necessary. It brakes where it lands. Returns whether all
/// bodies lie at their places.
bool Bounce::home(double now)
{
    bool all = true;
    for (int i = 0; i < furBodyCount; ++i) {
        const RigidPose pose = world_->bodies.pose(i);
        glm::dvec3 away = homes[i] - pose.position;
        away.y = 0;
        const glm::dvec3 turn = rotationVector(homeTurn(i) * glm::conjugate(pose.rotation));
        const glm::dvec3 velocity = world_->bodies.velocity(i);
        const glm::dvec3 spin = world_->bodies.angularVelocity(i);
        const bool there = glm::length(away) < nearHome && glm::length(turn) < nearTurn;
        const bool lies = glm::length(velocity) < 0.15 && glm::length(spin) < 0.5;
        all = all && there && lies;
        if (now < homeStart) continue;
        if (!lies) {
            if (world_->bodies.touches(i))
                world_->bodies.accelerate(i, glm::dvec3(-velocity.x, 0, -velocity.z) * (braking * dt),
                                          -spin * (braking * dt));
        } else if (!there && now >= world_->nextHop[i] && world_->bodies.touches(i)) {
            // The height grows with the distance, so the hop clears the rim and the bodies between.
            const double up = std::sqrt(2 * gravity * std::min(hopLeast + 0.4 * glm::length(away), hopMost));
            const double inAir = 2 * up / gravity;
            world_->bodies.accelerate(i, away / inAir + glm::dvec3(0, up, 0) - velocity, turn / inAir - spin);
            world_->nextHop[i] = now + inAir + 0.2;
        }
    }
    return all;
}

bool Bounce::still(const MotionState& m) const
{
    const FurStates rest = restStates(settings_);
    for (int i = 0; i < furBodyCount; ++i) {
        const glm::dvec3 droop = limited({{0, -settings_.gravity, 0}, {}}, settings_.displacementLimit).value;
        if (glm::length(m.tipOffset[i].value - droop) > 1e-3 || glm::length(m.tipOffset[i].rate) > 1e-2) return false;
        if (glm::length(m.tipRotation[i].value) > 1e-3 || glm::length(m.tipRotation[i].rate) > 1e-2) return false;
        if (glm::length(m.position[i] - rest[static_cast<std::size_t>(i)].position) > 1e-6) return false;
    }
    return true;
}

/// Computes one step of the bodies.
Bounce::MotionState Bounce::stepBodies()
{
    const double now = static_cast<double>(motion_.size()) * dt;
    MotionState next = motion_.back();
    ++steps_;
    if (now >= landed_) {
        const FurStates rest = restStates(settings_, now);
        const double share = smooth(0, settling, now - landed_);
        for (int i = 0; i < furBodyCount; ++i) {
            const FurState& state = rest[static_cast<std::size_t>(i)];
            next.position[i] = glm::mix(world_->asleep.position[i], state.position, share);
            next.rotation[i] = glm::slerp(world_->asleep.rotation[i], state.rotation, share);
        }
        return next;
    }
    world_->bodies.resizeBall(furBall, ballRadius * settings_.growth.skinScale(now) + settings_.cushion[furBall]);
    if (!home(now)) world_->calmSince = now;
    world_->bodies.step(dt);
    hold();
    for (int i = 0; i < furBodyCount; ++i) {
        const RigidPose pose = world_->bodies.pose(i);
        next.position[i] = pose.position;
        next.rotation[i] = pose.rotation;
    }
    if ((now > homeStart && now - world_->calmSince > calm) || now > longest - 2) {
        landed_ = now;
        world_->asleep = next;
        const FurStates rest = restStates(settings_, now);
        for (int i = 0; i < furBodyCount; ++i)
            slid_ = std::max(slid_, glm::length(rest[static_cast<std::size_t>(i)].position - next.position[i]));
    }
    return next;
}

/// Advances the springs of body `i` over `steps` steps of the rigid bodies, the first of which begins at index `before`
/// of `motion_`.
void Bounce::stepSprings(int i, std::size_t before, int steps)
{
    const double h = steps * dt;
    MotionState& after = motion_.back();
    const MotionState& last = motion_[before];
    const glm::dvec3 velocity = (after.position[i] - last.position[i]) / h;
    const glm::dvec3 spin = rotationVector(after.rotation[i] * glm::conjugate(last.rotation[i])) / h;
    SpringState tipOffset = last.tipOffset[i];
    SpringState tipRotation = last.tipRotation[i];
    tipOffset.rate -= settings_.inertia / strandScale * (velocity - world_->lastVelocity[i]);
    tipRotation.rate -= settings_.inertia * (spin - world_->lastSpin[i]);
    world_->lastVelocity[i] = velocity;
    world_->lastSpin[i] = spin;
    const glm::dvec3 trail = -settings_.airDrag * velocity - glm::dvec3(0, settings_.gravity, 0);
    after.tipOffset[i] =
        limited(advance(tipOffset, trail, settings_.spring, h, settings_.method), settings_.displacementLimit);
    after.tipRotation[i] =
        limited(advance(tipRotation, -0.25 * settings_.airDrag * spin, settings_.spring, h, settings_.method),
                settings_.rotationLimit);
    for (int n = 1; n < steps; ++n) {
        MotionState& between = motion_[before + static_cast<std::size_t>(n)];
        const double share = static_cast<double>(n) / steps;
        between.tipOffset[i] = {glm::mix(last.tipOffset[i].value, after.tipOffset[i].value, share),
                                after.tipOffset[i].rate};
        between.tipRotation[i] = {glm::mix(last.tipRotation[i].value, after.tipRotation[i].value, share),
                                  after.tipRotation[i].rate};
    }
}

/// Computes the steps of the bodies up to the next step of the springs, and that step.
void Bounce::block()
{
    const int steps =
        std::max(static_cast<int>(std::lround(static_cast<double>(stepsPerSecond) / settings_.springRate)), 1);
    const std::size_t before = motion_.size() - 1;
    for (int n = 0; n < steps; ++n) motion_.push_back(stepBodies());
    for (int i = 0; i < furBodyCount; ++i) stepSprings(i, before, steps);
}

void Bounce::extend(double since)
{
    while (static_cast<double>(motion_.size() - 1) * dt <= since && end_ == std::numeric_limits<double>::infinity()) {
        block();
        const double now = static_cast<double>(motion_.size() - 1) * dt;
        if (now >= longest || (now > landed_ + settling && still(motion_.back()))) {
            end_ = now;
            world_.reset();
        }
    }
}

FurStates Bounce::states(const MotionState& m, double since) const
{
    FurStates states;
    for (int i = 0; i < furBodyCount; ++i) {
        FurState& state = states[static_cast<std::size_t>(i)];
        state.position = m.position[i];
        state.rotation = m.rotation[i];
        state.skinScale = i == furBall ? settings_.growth.skinScale(since) : 1;
        state.tipOffset = m.tipOffset[i].value * settings_.strength;
        state.tipRotation = rotationOf(m.tipRotation[i].value);
    }
    return states;
}

FurStates Bounce::at(double since)
{
    if (!(since > 0)) return restStates(settings_, 0);
    extend(std::min(since, longest));
    if (since >= end_) return restStates(settings_, since);
    const double at = since / dt;
    const auto k = std::min(static_cast<std::size_t>(at), motion_.size() - 2);
    const double share = std::clamp(at - static_cast<double>(k), 0.0, 1.0);
    const MotionState& a = motion_[k];
    const MotionState& b = motion_[k + 1];
    MotionState m;
    for (int i = 0; i < furBodyCount; ++i) {
        m.position[i] = glm::mix(a.position[i], b.position[i], share);
        m.rotation[i] = glm::slerp(a.rotation[i], b.rotation[i], share);
        m.tipOffset[i].value = glm::mix(a.tipOffset[i].value, b.tipOffset[i].value, share);
        m.tipRotation[i].value = glm::mix(a.tipRotation[i].value, b.tipRotation[i].value, share);
    }
    return states(m, since);
}

double Bounce::restedAt(double since)
{
    if (!(since > 0)) return std::numeric_limits<double>::infinity();
    extend(std::min(since, longest));
    return end_ <= since ? end_ : std::numeric_limits<double>::infinity();
}

RecordedJump::Sample RecordedJump::at(double since) const
{
    const std::lock_guard lock(mutex_);
    Sample sample;
    sample.states = bounce_.at(since);
    sample.rested = bounce_.restedAt(since);
    const double moved = std::clamp(std::min(since, sample.rested), 0.0, Bounce::longest);
    sample.steps = static_cast<std::int64_t>(std::ceil(moved * Bounce::stepsPerSecond));
    return sample;
}

std::int64_t RecordedJump::stepsTaken() const
{
    const std::lock_guard lock(mutex_);
    return bounce_.steps();
}

}  // namespace vitrine::fur
