#pragma once

#include "render/image/image.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::printing {

/// The pictures in a folder, hidden ones left out; numbers in their names count by value (view2 before view10).
/// Throws Failure (Blame::file) when it cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> picturesIn(const std::filesystem::path& folder);

/// The picture files that `names` mean, in viewing order from the left: files as given, folders by the names
/// in them. Throws Failure when there is none.
[[nodiscard]] std::vector<std::filesystem::path> viewFiles(const std::vector<std::string>& names);

/// Where a quilt's first view is: rows upwards as Looking Glass has them, or downwards as one reads.
enum class QuiltOrder : std::uint8_t { bottomLeft, topLeft };

/// View `k` (0 to columns * rows - 1) of a grid of views of one size. Throws Failure (Blame::usage) when the
/// picture does not divide into the grid.
[[nodiscard]] render::Image viewOfQuilt(const render::Image&, int columns, int rows, int k,
                                        QuiltOrder = QuiltOrder::bottomLeft);

/// What a print takes of a row of pictures.
struct SequenceSettings {
    int every = 1;          ///< Only every so many, the first included, as of the frames of a video.
    bool pingPong = false;  ///< After the last, back to the first: 1 2 3 4 3 2.
    int count = 0;          ///< So many of what is left, spread evenly from the first to the last; 0: all.
};

/// The numbers of the pictures, in viewing order. Throws Failure (Blame::usage) when there are none, fewer than
/// `count`, or more than a print takes (256), with what to do.
[[nodiscard]] std::vector<std::size_t> chosenViews(std::size_t available, const SequenceSettings&);

}  // namespace vitrine::printing
