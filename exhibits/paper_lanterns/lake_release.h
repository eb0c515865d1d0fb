#pragma once

#include "exhibits/paper_lanterns/lake_scene.h"

namespace vitrine {

/// What finding the way of a lantern that was set free took.
struct ReleaseWork {
    int gaps = 0;      ///< How often the room between two lanterns was reckoned.
    int lanterns = 0;  ///< Cells of the lattice that were read.
};

/// Puts the lantern that the button has set free into a block that has all else. It begins on the
/// water before the frame: a new one where there is room, else the nearest of the lattice, whose cell stays empty from
/// then on. It drifts with all others, goes its own way among them, and steers clear of each: the same at the same
/// moment, however one got there. Only others that it may meet are looked at; `farther` is by how many meters more.
ReleaseWork setReleased(const PaperLanternsTable&, const ParameterValues&, double seconds, const LakePress&, LakeBlock&,
                        double farther = 0);

}  // namespace vitrine
