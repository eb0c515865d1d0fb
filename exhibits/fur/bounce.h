#pragma once

#include "exhibits/fur/coat.h"
#include "exhibits/fur/spring.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace vitrine {

/// How the size of the ball changes by itself.
struct Growth {
    double amount = 0;    ///< Meters of radius, up and down.
    double rate = 0;      ///< Hertz.
    bool always = false;  ///< Otherwise only while the bodies bounce.
    double start = 0;     ///< Seconds on the exhibit's clock at which the button was pressed; for `always`.

    bool operator==(const Growth&) const = default;
    /// Skin over skin at rest, `since` seconds after the press.
    [[nodiscard]] double skinScale(double since) const;
    /// The most that it ever is.
    [[nodiscard]] double largest() const;
};

/// Everything that the motion after a press depends on.
struct BounceSettings {
    double cushion[furBodyCount] = {};          ///< Meters of fur under each skin that the contact does not flatten.
    std::shared_ptr<const render::Mesh> model;  ///< In place of the ring.
    double jump = 3;                            ///< Mean speed with which they leave the ground, m/s.
    std::uint32_t toss = 1;                     ///< Which of many throws.
    Growth growth;
    Spring spring;
    FurSpring method = FurSpring::closedForm;
    int springRate = 240;  ///< Spring steps a second.
    double inertia = 1, gravity = 0.3, airDrag = 0, strength = 1;
    double displacementLimit = 1;  ///< Strand lengths.
    double rotationLimit = 1;      ///< Radians.

    bool operator==(const BounceSettings&) const = default;
};
/// All of them but the model spelled out to the last bit.
[[nodiscard]] std::string keyOf(const BounceSettings&);
/// `time`: of the press, on the exhibit's clock.
[[nodiscard]] BounceSettings bounceSettings(const FurTable&, const ParameterValues&,
                                            std::shared_ptr<const render::Mesh> model, double time);

/// How far the middle of a body gets while it jumps, whatever it meets: pit space, meters.
struct Flight {
    double highest = 0;   ///< Above the pit's floor.
    double farthest = 0;  ///< From the pit's axis.
};
[[nodiscard]] Flight flightOf(const BounceSettings&, int body);

/// The space that the bodies and their fur may fill, pit space: at rest, or at any time of a jump. The largest skin
/// that a body may have is counted, so that a visitor's model need not be known.
[[nodiscard]] render::Box bouncingSpace(const FurTable&, const ParameterValues&, bool jumping);

/// Where the bodies lie before a press, and again when they have come to rest; `since` only moves what grows.
[[nodiscard]] FurStates restStates(const BounceSettings&, double since = 0);

/// What happens after a press of the button: three bodies thrown up from rest, bouncing, then rolling back to
/// where they lay (those that left the pit hop over its rim first), and their fur. Simulated in steps of 1/240 s as far
/// as it is asked for, and kept: the state at a time is the same however, and in whatever order, one asks.
class Bounce {
public:
    static constexpr int stepsPerSecond = 240;
    static constexpr double longest = 14;  ///< Seconds after which everything rests in any case.

    explicit Bounce(const BounceSettings&);
    ~Bounce();

    [[nodiscard]] const BounceSettings& settings() const { return settings_; }
    /// At `since` seconds after the press, between steps by interpolation; at rest before it and after the end.
    [[nodiscard]] FurStates at(double since);
    /// Seconds after the press at which all is at rest, when that is at or before `since`; else infinity.
    [[nodiscard]] double restedAt(double since);
    /// Meters by which a body was put to rest beside its place, at most, and then moved there: as far as it was
    /// simulated.
    [[nodiscard]] double slid() const { return slid_; }
    /// Steps that have been simulated so far.
    [[nodiscard]] std::int64_t steps() const;

private:
    struct MotionState {
        glm::dvec3 position[furBodyCount];
        glm::dquat rotation[furBodyCount];
        SpringState tipOffset[furBodyCount];
        SpringState tipRotation[furBodyCount];  ///< As rotation vectors, pit space.
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
    double landed_ = std::numeric_limits<double>::infinity();  ///< When the bodies had come to lie, seconds.
    std::unique_ptr<World> world_;
    std::int64_t steps_ = 0;
    double slid_ = 0;
};

/// A jump that several may ask about at once: a state of a simulation as the asset store keeps it. Simulated as far as
/// anybody has asked, and the answer to each question is always the same.
class RecordedJump {
public:
    explicit RecordedJump(const BounceSettings& settings) : bounce_(settings) {}

    struct Sample {
        FurStates states;
        double rested = 0;       ///< As Bounce::restedAt.
        std::int64_t steps = 0;  ///< That lead from the press to here.
    };
    [[nodiscard]] Sample at(double since) const;
    /// Steps that have been simulated so far, whoever asked for them.
    [[nodiscard]] std::int64_t stepsTaken() const;
    /// Of memory, when all of it is simulated.
    static constexpr std::uint64_t mostBytes = 2U << 20U;

private:
    mutable std::mutex mutex_;
    mutable Bounce bounce_;
};

}  // namespace vitrine
