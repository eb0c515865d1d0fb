#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/files/asset_store.h"
#include "render/text/message.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace vitrine {

/// A required file that cannot be read.
struct UnreadableFile {
    std::string step;  ///< Name in the frame report: "hall/model".
    Message why;       ///< A full sentence: which parameter names which file, and what is wrong with it.
    Message instead;   ///< A full sentence: what is drawn in its place.
};

/// Result of `Exhibit::prepare`: files, meshes, the state of a simulation. Each exhibit that needs it derives its own
/// type. Immutable, so that any thread may plan from it.
struct PreparedPart {
    virtual ~PreparedPart() = default;

    std::vector<UnreadableFile> unreadable;
    /// Hash of the files that it was made from; part of the keys of passes that keep their result.
    std::uint64_t filesId = 0;
};

/// Arguments of `Exhibit::prepare`.
struct PrepareContext {
    const ParameterValues& values;
    double time = 0;  ///< Seconds since the exhibit's clock started.
    double sinceOwnPress =
        std::numeric_limits<double>::infinity();  ///< Seconds since its button was pressed; infinity: never.
    bool seen = false;                            ///< The exhibit may be visible in the picture ...
    bool shadowSeen = false;                      ///< ... or its shadow may be. At least one of the two is true.
    bool idle = false;                            ///< The values have not changed for a while.
    render::AssetStore& assets;                   ///< Cache in which all assets are made and kept.
};

/// State of an exhibit in a prepared picture.
struct ExhibitState {
    const ParameterValues& values;
    double time = 0;
    double sinceOwnPress = std::numeric_limits<double>::infinity();
    const PreparedPart* prepared = nullptr;  ///< Null if it is out of view.
};

/// Returns an error that says which parameter of which exhibit names an unreadable file, and why: "Ring model of Fur
/// with Physics: Cannot read bear.glb: there is no such file.".
[[nodiscard]] inline Message unreadableFile(const ParameterInfo& parameter, std::string_view exhibitTitle,
                                            const Message& why)
{
    const Message name = Message::ofTable(label(parameter)), title = Message::ofTable(exhibitTitle);
    return why.english().ends_with('.') ? message("{1} of {2}: {3}", name, title, why)
                                        : message("{1} of {2}: {3}.", name, title, why);
}

}  // namespace vitrine
