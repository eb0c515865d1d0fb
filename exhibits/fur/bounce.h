#pragma once

#include "exhibits/fur/coat.h"
#include "exhibits/fur/spring.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace vitrine::fur {

/// Periodic change of the ball's size.
struct Growth {
    double amount = 0;    ///< Amplitude of the radius, meters.
    double rate = 0;      ///< Frequency, hertz.
    bool always = false;  ///< If false, the ball changes only while the bodies bounce.
    double start = 0;     ///< Seconds on the exhibit's clock at which the button was pressed; used if `always`.

    bool operator==(const Growth&) const = default;
    /// Returns the radius of the skin relative to rest, `since` seconds after the press.
    [[nodiscard]] double skinScale(double since) const;
    /// Returns the largest value of `skinScale`.
    [[nodiscard]] double largest() const;
};

/// Settings that the motion after a press depends on.
struct BounceSettings {
    double cushion[furBodyCount] = {};          ///< Meters of fur under each skin that contact does not flatten.
    std::shared_ptr<const render::Mesh> model;  ///< Model in place of the ring; null: the ring.
    double jump = 3;                            ///< Mean speed at which the bodies leave the ground, m/s.
    std::uint32_t toss = 1;                     ///< Seed of the throw.
    Growth growth;
    Spring spring;
    FurSpring method = FurSpring::closedForm;
    int springRate = 240;  ///< Spring steps per second.
    double inertia = 1, gravity = 0.3, airDrag = 0, strength = 1;
    double displacementLimit = 1;  ///< Strand lengths.
    double rotationLimit = 1;      ///< Radians.

    bool operator==(const BounceSettings&) const = default;
};
/// Returns a key of all settings except the model, exact to the last bit.
[[nodiscard]] std::string keyOf(const BounceSettings&);
/// Returns the settings. `time` is the time of the press on the exhibit's clock, in seconds.
[[nodiscard]] BounceSettings bounceSettings(const FurTable&, const ParameterValues&,
                                            std::shared_ptr<const render::Mesh> model, double time);

/// Limits of the center of a jumping body, whatever it collides with; pit space, meters.
struct Flight {
    double highest = 0;   ///< Height above the floor of the pit.
    double farthest = 0;  ///< Distance from the axis of the pit.
};
[[nodiscard]] Flight flightOf(const BounceSettings&, int body);

/// Returns the space that the bodies and their fur may fill, in pit space: at rest, or at any time of a jump. The body
/// in place of the ring counts with its largest possible skin, so the user's model need not be known.
[[nodiscard]] render::Box bouncingSpace(const FurTable&, const ParameterValues&, bool jumping);

/// Returns the states before a press, which are also those after the bodies have come to rest. `since` only affects the
/// ball's changing size.
[[nodiscard]] FurStates restStates(const BounceSettings&, double since = 0);

/// Motion after the button is pressed: three bodies are thrown up from rest, bounce, and roll back to their places, and
/// their fur follows. Bodies that left the pit hop back over its rim first.
///
/// The simulation runs in steps of 1/240 s as far as a call needs, and is kept. The state at a time does not depend on
/// the number or order of the calls.
class Bounce {
public:
    static constexpr int stepsPerSecond = 240;
    static constexpr double longest = 14;  ///< Seconds after which everything is at rest in any case.

    explicit Bounce(const BounceSettings&);
    ~Bounce();

    [[nodiscard]] const BounceSettings& settings() const { return settings_; }
    /// Returns the states `since` seconds after the press, interpolated between steps. Before the press and after the
    /// end it is the state at rest.
    [[nodiscard]] FurStates at(double since);
    /// Returns the seconds after the press at which everything is at rest, if that is at most `since`; else infinity.
    [[nodiscard]] double restedAt(double since);
    /// Returns the largest distance in meters between where a body stopped and its place, to which it is then moved.
    /// Covers the part simulated so far.
    [[nodiscard]] double slid() const { return slid_; }
    /// Returns the number of steps simulated so far.
    [[nodiscard]] std::int64_t steps() const;

private:
    struct MotionState {
        glm::dvec3 position[furBodyCount];
        glm::dquat rotation[furBodyCount];
        SpringState tipOffset[furBodyCount];
        SpringState tipRotation[furBodyCount];  ///< Rotation vectors, pit space.
    };
    struct World;
    void extend(double since);
    void block();
    [[nodiscard]] MotionState stepBodies();
    void stepSprings(int body, std::size_t before, int steps);
    bool home(double now);
    void hold();
    [[nodiscard]] bool still(const MotionState&) const;
    [[nodiscard]] FurStates states(const MotionState&, double since) const;

    BounceSettings settings_;
    std::vector<MotionState> motion_;
    double end_ = std::numeric_limits<double>::infinity();
    double landed_ = std::numeric_limits<double>::infinity();  ///< Seconds at which the bodies have stopped.
    std::unique_ptr<World> world_;
    std::int64_t steps_ = 0;
    double slid_ = 0;
};

/// Simulated jump in the asset store, which several threads may read at once. It is simulated as far as any caller
/// needed, and the state at a time is always the same.
class RecordedJump {
public:
    explicit RecordedJump(const BounceSettings& settings) : bounce_(settings) {}

    struct Sample {
        FurStates states;
        double rested = 0;       ///< As Bounce::restedAt.
        std::int64_t steps = 0;  ///< Steps from the press to this time.
    };
    [[nodiscard]] Sample at(double since) const;
    /// Returns the number of steps simulated so far, for all callers together.
    [[nodiscard]] std::int64_t stepsTaken() const;
    /// Size in bytes of a complete jump.
    static constexpr std::uint64_t mostBytes = 2U << 20U;

private:
    mutable std::mutex mutex_;
    mutable Bounce bounce_;
};

}  // namespace vitrine::fur
