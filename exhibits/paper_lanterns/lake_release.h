#pragma once

#include "exhibits/paper_lanterns/lake_scene.h"

namespace vitrine::paper_lanterns {

/// Cost of finding the path of a released lantern.
struct ReleaseWork {
    int gaps = 0;      ///< Evaluations of the gap between two lanterns.
    int lanterns = 0;  ///< Cells of the lattice that were read.
};

/// Adds the lantern that the button has released to a block that is complete otherwise. It starts on the water in front
/// of the frame: as a new lantern if there is room. Otherwise it is the nearest one of the lattice, whose cell is empty
/// from then on.
///
/// It drifts with all others, moves among them and avoids each. Its place depends on the time only, not on earlier
/// calls. Only lanterns that it may meet are examined; `farther` extends that range, in meters.
ReleaseWork setReleased(const PaperLanternsTable&, const ParameterValues&, double seconds, const LakePress&, LakeBlock&,
                        double farther = 0);

}  // namespace vitrine::paper_lanterns
