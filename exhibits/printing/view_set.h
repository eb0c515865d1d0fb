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

/// The views of a print, as the interlacer reads them: linear Rec. 709 in 16 bits, three samples a pixel. Row 0 at the
/// top. All have the same height; widths differ.
/// Views that do not fit into its share of memory lie in a scratch file and come into memory by rows.
class ViewSet {
public:
    /// Beside it, decoding pictures and writing the largest prints take some 165 MB: together they stay below 300. What
    /// lies in the scratch file instead is interlaced three times more slowly.
    static constexpr std::size_t usualMemory = 120U << 20U;

    /// `memory`: bytes of samples that are kept in memory.
    explicit ViewSet(std::size_t memory = usualMemory) : memory_(memory) {}

    static constexpr std::size_t behind = 16;  ///< Samples.

    struct View {
        int width = 0;
        std::shared_ptr<const std::uint16_t>
            samples{};  ///< width * height * 3, and `behind` unused ones: columns are read several at once.
    };

    /// Adds a picture of linear light with 1 to 4 channels, over white where it is transparent. A picture of
    /// another height than the first is scaled along its columns to the first one's. Throws Failure when there is
    /// no room for it, neither in memory nor in the folder for temporary files.
    void add(const render::Image&);

    [[nodiscard]] int count() const { return static_cast<int>(views_.size()); }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] const View& view(int k) const { return views_[static_cast<std::size_t>(k)]; }
    [[nodiscard]] const std::uint16_t* row(int k, int y) const
    {
        const View& v = view(k);
        return v.samples.get() + static_cast<std::size_t>(y) * static_cast<std::size_t>(v.width) * 3;
    }

    /// Bytes of samples in the scratch file.
    [[nodiscard]] std::uint64_t scratchBytes() const { return scratch_ ? scratch_->size() : 0; }
    /// Tells that row `y` of every view was read and is not wanted soon.
    void rowIsRead(int y) const;
    /// Tells it of all rows.
    void allIsRead() const;

private:
    std::size_t memory_;
    std::size_t used_ = 0;
    int height_ = 0;
    std::vector<View> views_;
    std::size_t firstOnDisk_ = std::numeric_limits<std::size_t>::max();
    std::shared_ptr<render::ScratchFile> scratch_;
};

/// "The views are not shaped as the print is and are stretched to it." where one is by more than two percent, else
/// empty.
[[nodiscard]] std::string stretchWarning(const PrintLayout&, const ViewSet&);

}  // namespace vitrine::printing
