#pragma once

#include <cstddef>
#include <vector>

namespace vitrine::lenticular {

/// What a print takes of a row of pictures.
struct SequenceSettings {
    int every = 1;          ///< Only every so many, the first included, as of the frames of a video.
    bool pingPong = false;  ///< After the last, back to the first: 1 2 3 4 3 2.
    int count = 0;          ///< So many of what is left, spread evenly from the first to the last; 0: all.
};

/// The numbers of the pictures, in viewing order. Throws Failure (Blame::usage) when there are none, fewer than
/// `count`, or more than a print takes (256), with what to do.
[[nodiscard]] std::vector<std::size_t> chosenViews(std::size_t available, const SequenceSettings&);

}  // namespace vitrine::lenticular
