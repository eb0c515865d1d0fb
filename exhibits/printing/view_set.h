#pragma once

#include "exhibits/printing/print_layout.h"
#include "render/files/scratch_file.h"
#include "render/image/image.h"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Views of a print in the form that the interlacer reads: linear Rec. 709 in 16 bits, three samples per pixel, row 0
/// at the top. All have the same height, but their widths may differ.
///
/// Views that exceed its memory limit are in a scratch file, and are loaded by rows.
class ViewSet {
public:
    /// Default memory limit. Decoding pictures and writing the largest prints take about 180 MB in addition, so the
    /// total stays below 300 MB. Views in the scratch file are interlaced three times more slowly.
    static constexpr std::size_t usualMemory = 104U << 20U;

    /// `memory` is the number of bytes of samples kept in memory.
    explicit ViewSet(std::size_t memory = usualMemory) : memory_(memory) {}

    static constexpr std::size_t behind = 16;  ///< Unused samples after a view.

    struct View {
        int width = 0;
        std::shared_ptr<const std::uint16_t>
            samples{};  ///< width * height * 3, and `behind` unused ones, since several columns are read at once.
    };

    /// Adds a picture of linear light with 1 to 4 channels, over white where it is transparent. If its height differs
    /// from the first one's, its columns are resampled. Throws Failure if there is no space, neither in memory nor in
    /// the folder for temporary files.
    void add(const render::Image&);

    [[nodiscard]] int count() const { return static_cast<int>(views_.size()); }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] const View& view(int k) const { return views_[static_cast<std::size_t>(k)]; }
    [[nodiscard]] const std::uint16_t* row(int k, int y) const
    {
        const View& v = view(k);
        return v.samples.get() + static_cast<std::size_t>(y) * static_cast<std::size_t>(v.width) * 3;
    }

    /// Returns the bytes of samples in the scratch file.
    [[nodiscard]] std::uint64_t scratchBytes() const { return scratch_ ? scratch_->size() : 0; }
    /// Releases row `y` of every view on disk; it may be read again later.
    void rowIsRead(int y) const;
    /// Releases all rows on disk.
    void allIsRead() const;

private:
    std::size_t memory_;
    std::size_t used_ = 0;
    int height_ = 0;
    std::vector<View> views_;
    std::size_t firstOnDisk_ = std::numeric_limits<std::size_t>::max();
    std::shared_ptr<render::ScratchFile> scratch_;
};

/// Returns "The views are not shaped as the print is and are stretched to it." if the shape of a view differs by more
/// than two percent; otherwise empty.
[[nodiscard]] std::string stretchWarning(const PrintLayout&, const ViewSet&);

}  // namespace vitrine::printing
