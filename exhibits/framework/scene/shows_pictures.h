#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/plan/history.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

struct PlanContext;
namespace render {
class FramePlan;
}

/// Source of a picture that an exhibit can show.
struct PictureSource {
    std::string name;   ///< Name of an exhibit, or one of the hall's below.
    std::string title;  ///< Name for people.

    bool operator==(const PictureSource&) const = default;
};

/// Sources that every museum has: the hall at its first view, from the place of the viewer, and out of the screen.
inline constexpr const char* hallAtFirst = "hall";
inline constexpr const char* hallFromHere = "here";
inline constexpr const char* hallFromScreen = "screen";

/// Planned picture of a source: an image of the format rgba8 with display values (sRGB), the lower row first.
struct ShownPicture {
    std::string image;
    glm::ivec2 size{1};
    std::uint64_t key = 0;  ///< Hash of everything that the picture depends on.
};

/// Plans the picture of a source, unless the plan has it already. A picture that the renderer holds unchanged is not
/// drawn again. Returns nothing if there is no such source.
using PlanPicture = std::function<std::optional<ShownPicture>(const std::string& source, render::FramePlan&)>;

/// Capability: shows pictures of the hall and of other exhibits.
class ShowsPictures {
public:
    virtual ~ShowsPictures() = default;
    /// Called once, before everything else, by the museum that has these sources.
    virtual void offerPictures(std::vector<PictureSource>) = 0;
    /// Returns the names of the sources that its picture reads with these values; empty: none.
    [[nodiscard]] virtual std::vector<std::string> shownPictures(const ParameterValues&) const = 0;
    /// Returns the size of these pictures. `alone`: size of the whole picture if the exhibit is shown alone.
    [[nodiscard]] virtual glm::ivec2 pictureSize(const ParameterValues&, std::optional<glm::ivec2> alone) const = 0;
    /// Does what `Exhibit::plan` does, and is called in its place for the main view while `shownPictures` is not empty.
    /// An empty function: this is itself such a picture, in which the exhibit is dark.
    virtual void planShowing(const PlanContext&, const render::PersistentState& kept, const PlanPicture&,
                             render::FramePlan&) const = 0;
};

}  // namespace vitrine
