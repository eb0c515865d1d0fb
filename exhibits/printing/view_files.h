#pragma once

#include "render/image/image.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Whether a name comes before another one as people sort them: runs of digits by their value, capitals as small
/// letters. A strict weak order.
[[nodiscard]] bool beforeByNumber(const std::string& a, const std::string& b);

/// The pictures in a folder, hidden ones left out; numbers in their names count by value (view2 before VIEW10).
/// `others` (may be null) takes the files that are no pictures by their names, without descriptions (.json). Throws
/// Failure (Blame::file) when it cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> picturesIn(const std::filesystem::path& folder,
                                                            std::vector<std::filesystem::path>* others = nullptr);

/// The picture files that `names` mean, in viewing order from the left: files as given, folders by the names
/// in them. `notes` (may be null) takes a full sentence for each folder of which files are left out. Throws Failure
/// when there is none.
[[nodiscard]] std::vector<std::filesystem::path> viewFiles(const std::vector<std::string>& names,
                                                           std::vector<std::string>* notes = nullptr);

/// Columns and rows of a quilt, each from 1 to 1000: "8x6", "8X6" or "8×6"; nothing for all else.
[[nodiscard]] std::optional<glm::ivec2> quiltGrid(const std::string&);

/// Where a quilt's first view is: rows upwards as Looking Glass has them, or downwards as one reads.
enum class QuiltOrder : std::uint8_t { bottomLeft, topLeft };

/// View `k` (0 to columns * rows - 1) of a grid of views of one size: the sides of the picture by columns and rows,
/// rounded down. What is left over lies at the right edge, and above (`bottomLeft`) or below. Throws Failure
/// (Blame::usage) when the picture has fewer pixels than views.
[[nodiscard]] render::Image viewOfQuilt(const render::Image&, int columns, int rows, int k,
                                        QuiltOrder = QuiltOrder::bottomLeft);

/// A full sentence on what is left over where the picture does not divide into the grid; else empty.
[[nodiscard]] std::string quiltNote(const render::Image&, int columns, int rows);

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
