#pragma once

#include "exhibits/fur/coat.h"
#include "exhibits/fur/spring.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace vitrine {

/// How the size of the ball changes by itself.
struct Growth {
    double amount = 0;      ///< Metres of radius, up and down.
    double rate = 0;        ///< Hertz.
    bool always = false;    ///< Otherwise only while the bodies bounce.
    double start = 0;       ///< Seconds on the exhibit's clock at which the button was pressed; for `always`.

    bool operator==(const Growth&) const = default;
    /// Skin over skin at rest, `since` seconds after the press.
    [[nodiscard]] double grown(double since) const;
};

/// Everything that the motion after a press depends on.
struct BounceSettings {
    double cushion[furBodyCount] = {};  ///< Metres of fur under each skin that the contact does not flatten.
    std::shared_ptr<const render::Mesh> model;  ///< In place of the ring.
    double jump = 3;                    ///< Mean speed with which they leave the ground, m/s.
    std::uint32_t toss = 1;             ///< Which of many throws.
    Growth growth;
    Spring spring;
    FurSpring method = FurSpring::closedForm;
    int springRate = 240;               ///< Spring steps a second.
    double inertia = 1, gravity = 0.3, airDrag = 0, strength = 1;
    double displacementLimit = 1;       ///< Strand lengths.
    double rotationLimit = 1;           ///< Radians.

    bool operator==(const BounceSettings&) const = default;
};
/// `time`: of the press, on the exhibit's clock.
[[nodiscard]] BounceSettings bounceSettings(const FurTable&, const ParameterValues&, std::shared_ptr<const render::Mesh> model, double time);

/// Where the bodies lie before a press, and again when they have come to rest; `since` only moves what grows.
[[nodiscard]] FurStates restStates(const BounceSettings&, double since = 0);

/// What happens after a press of the button: three bodies thrown up from rest, bouncing, then drawn back to
/// where they lay, and their fur. Simulated in steps of 1/240 s as far as it is asked for, and kept: the state
/// at a time is the same however, and in whatever order, one asks.
class Bounce {
public:
    static constexpr int stepsPerSecond = 240;
    static constexpr double longest = 9;  ///< Seconds after which everything rests in any case.

    explicit Bounce(const BounceSettings&);
    ~Bounce();

    [[nodiscard]] const BounceSettings& settings() const { return settings_; }
    /// At `since` seconds after the press, between steps by interpolation; at rest before it and after the end.
    [[nodiscard]] FurStates at(double since);
    /// Seconds after the press at which all is at rest, when that is at or before `since`; else infinity.
    [[nodiscard]] double restedAt(double since);
    /// Steps that have been simulated so far.
    [[nodiscard]] std::int64_t steps() const;

private:
    struct Moment {
        glm::dvec3 position[furBodyCount];
        glm::dquat turn[furBodyCount];
        SpringState pull[furBodyCount];
        SpringState lag[furBodyCount];  ///< As rotation vectors, pit space.
    };
    struct Flight;
    void extend(double since);
    void block();
    void home(double dt);
    [[nodiscard]] bool still(const Moment&) const;
    [[nodiscard]] FurStates states(const Moment&, double since) const;

    BounceSettings settings_;
    std::vector<Moment> moments_;
    double end_ = std::numeric_limits<double>::infinity();
    double landed_ = std::numeric_limits<double>::infinity();  ///< When the bodies fell asleep, seconds.
    std::unique_ptr<Flight> flight_;
    std::int64_t steps_ = 0;
};

}  // namespace vitrine
