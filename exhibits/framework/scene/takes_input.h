#pragma once

#include "exhibits/framework/scene/prepare.h"
#include "render/scene/ray.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine {

enum class PointerEvent : std::uint8_t { press, move, release };

/// Values of parameters, by index.
using ParameterChanges = std::vector<std::pair<std::size_t, Value>>;

/// Capability: a picture in the exhibit takes the pointer and the keys, for example that of a shader that reads them.
class TakesInput {
public:
    virtual ~TakesInput() = default;
    /// Returns a number for what a ray from the eye (own space) would grip in the picture; nothing if it misses the
    /// picture, or if the picture takes no pointer there. `reach`: largest distance of a handle, in meters.
    [[nodiscard]] virtual std::optional<std::size_t> gripUnder(const ExhibitState&, const render::Ray&,
                                                               double reach) const = 0;
    /// Returns the changes that an event of the pointer makes, for a grip of `gripUnder`. A ray beside the picture
    /// counts as its nearest edge.
    [[nodiscard]] virtual ParameterChanges pointed(const ExhibitState&, std::size_t grip, PointerEvent,
                                                   const render::Ray&) const = 0;
    /// Returns whether the picture takes keys.
    [[nodiscard]] virtual bool takesKeys(const ExhibitState&) const = 0;
    /// Returns the changes that a key makes. Codes are those of browsers: 65 is A, 37 to 40 are the arrows.
    [[nodiscard]] virtual ParameterChanges keyed(const ExhibitState&, int code, bool isDown) const = 0;
    /// Returns the changes that a push of a parameter's button makes now; nothing if the parameter has no button.
    [[nodiscard]] virtual std::optional<ParameterChanges> pushed(const ExhibitState&, std::size_t parameter) const = 0;
};

}  // namespace vitrine
