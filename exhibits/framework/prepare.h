#pragma once

#include "exhibits/framework/parameters.h"
#include "render/files/asset_store.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace vitrine {

/// A file that is needed for what is shown, and that cannot be read.
struct UnreadableFile {
    std::string step;     ///< Name in the frame's ledger: "hall/model".
    std::string why;      ///< A full sentence: which parameter names which file, and what is wrong with it.
    std::string instead;  ///< A full sentence: what is drawn in its place.
};

/// What `Exhibit::prepare` resolved: files, meshes, the state of a simulation. Each exhibit that needs any derives a
/// type of its own. Never changes once it is made, so that any thread may plan from it.
struct PreparedPart {
    virtual ~PreparedPart() = default;

    std::vector<UnreadableFile> unreadable;
    std::uint64_t filesId =
        0;  ///< Another number when a file that it was made of changed: part of the keys of what is kept.
};

/// What an exhibit is prepared for.
struct PrepareContext {
    const ParameterValues& values;
    double time = 0;  ///< Seconds since the exhibit's clock started.
    double sinceOwnPress =
        std::numeric_limits<double>::infinity();  ///< Seconds since its button was pressed; infinity: never.
    bool seen = false;                            ///< It may be seen in the picture ...
    bool shadowSeen = false;                      ///< ... and the same of its shadow. One of the two at least.
    bool rests = false;                           ///< The values have not changed for a while.
    render::AssetStore& assets;                   ///< The one place in which things are made and kept.
};

/// An exhibit in a prepared picture.
struct ExhibitState {
    const ParameterValues& values;
    double time = 0;
    double sinceOwnPress = std::numeric_limits<double>::infinity();
    const PreparedPart* prepared = nullptr;  ///< Null where it is out of view.
};

/// "Ring model of Fur with Physics: Cannot read bear.glb: there is no such file.": which parameter of which exhibit
/// names a file that cannot be read, and why.
[[nodiscard]] inline std::string unreadableFile(const ParameterInfo& row, std::string_view exhibitTitle,
                                                const std::string& why)
{
    return label(row) + " of " + std::string(exhibitTitle) + ": " + why + (why.ends_with('.') ? "" : ".");
}

}  // namespace vitrine
