#pragma once

#include "exhibits/printing/print_layout.h"
#include "exhibits/printing/view_set.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine::printing {

/// How a row of a print with vertical lenses follows from a row of every view; the same for all rows.
///
/// What a lens shows of a view, the mean over one lens, is kept in a slot of three floats. Slots lie as the strips do
/// on the paper, lens after lens: a column of the print takes slots that are neighbors.
struct LensPlan {
    LensPlan(const PrintLayout&, const ViewSet&);

    /// The columns of a view that a lens shows, two by two, and where their weights are: those of one pair are eight
    /// floats, three times that of the first, three times that of the second, 0 and 0.
    struct Span {
        int column;
        int pairs;
        std::uint32_t first;
    };

    [[nodiscard]] std::size_t slotCount() const { return lenses * views; }
    /// The slots of columns x0 to x1, ends excluded, lie under these lenses, ends excluded.
    struct Lenses {
        std::size_t first, last;
    };
    [[nodiscard]] Lenses lensesOf(std::size_t x0, std::size_t x1) const;

    std::size_t views = 0;
    std::size_t lenses = 0;            ///< Under which slots are wanted.
    std::vector<int> viewOfSlot;       ///< Of a lens.
    std::vector<Span> spans;           ///< Per lens, for every width that views have.
    std::vector<std::size_t> spansOf;  ///< Per slot of a lens, into `spans`.
    std::vector<float> weights;

    std::size_t taps = 1;                  ///< Slots that a column takes.
    bool single = false;                   ///< One slot with weight 1.
    std::vector<std::uint32_t> firstSlot;  ///< Per column.
    std::vector<float> tapWeights;         ///< Per column, one per tap.

private:
    void planColumns(const PrintLayout&);
    void planLenses(const PrintLayout&, const ViewSet&);

    std::int64_t firstLens_ = 0;
};

}  // namespace vitrine::printing
