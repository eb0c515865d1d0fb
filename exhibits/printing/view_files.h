#pragma once

#include "exhibits/printing/view_place.h"
#include "render/image/image.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Returns whether a name comes before another one in natural order: runs of digits by their value, ignoring case. A
/// strict weak order.
[[nodiscard]] bool beforeByNumber(const std::string& a, const std::string& b);

/// Returns the pictures in a folder except hidden ones; numbers in their names count by value (view2 before VIEW10).
/// Names of other files, except descriptions (.json), are added to `others` (may be null). Throws Failure
/// (ErrorKind::file) if the folder cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> picturesIn(const std::filesystem::path& folder,
                                                            std::vector<std::filesystem::path>* others = nullptr);

/// Returns the picture files of `names`, in viewing order from the left: files as given, folders sorted by name. A full
/// sentence for each folder with ignored files is added to `notes` (may be null). Throws Failure if there are none.
[[nodiscard]] std::vector<std::filesystem::path> viewFiles(const std::vector<std::string>& names,
                                                           std::vector<std::string>* notes = nullptr);

/// Returns view `k` (0 to columns * rows - 1) of a grid of views of one size. The size is that of the picture divided
/// by columns and rows, rounded down. The remainder is at the right edge, and above (`bottomLeft`) or below. Throws
/// Failure (ErrorKind::usage) if the picture has fewer pixels than views.
[[nodiscard]] render::Image viewOfQuilt(const render::Image&, int columns, int rows, int k,
                                        QuiltOrder = QuiltOrder::bottomLeft);

/// Returns a full sentence on the remainder if the picture cannot be divided into the grid; otherwise empty.
[[nodiscard]] std::string quiltNote(const render::Image&, int columns, int rows);

/// Selection from a sequence of pictures.
struct SequenceSettings {
    int every = 1;          ///< Every n-th picture, including the first, as for the frames of a video.
    bool pingPong = false;  ///< Whether it returns from the last to the first: 1 2 3 4 3 2.
    int count = 0;          ///< Number of the remaining pictures, evenly spaced from the first to the last; 0: all.
};

/// Returns the indices of the pictures, in viewing order. Throws Failure (ErrorKind::usage) with what to do if there
/// are none, fewer than `count`, or more than the maximum of a print (256).
[[nodiscard]] std::vector<std::size_t> chosenViews(std::size_t available, const SequenceSettings&);

}  // namespace vitrine::printing
