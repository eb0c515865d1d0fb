#pragma once

#include "exhibits/printing/print_layout.h"
#include "exhibits/printing/view_set.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine::printing {

/// Weights that make a row of a print with vertical lenses from a row of every view; the same for all rows.
///
/// The part of a view that a lens shows, its mean over one lens, is stored in a slot of three floats. Slots have the
/// order of the strips on the paper, lens by lens, so a column of the print uses adjacent slots.
struct LensPlan {
    LensPlan(const PrintLayout&, const ViewSet&);

    /// Columns of a view that a lens shows, in pairs, and the position of their weights. A pair has eight floats: three
    /// times the weight of the first column, three times that of the second, 0 and 0.
    struct Span {
        int column;
        int pairs;
        std::uint32_t first;
    };

    [[nodiscard]] std::size_t slotCount() const { return lenses * views; }
    /// Range of lenses under which the slots of columns x0 to x1 lie, ends excluded.
    struct Lenses {
        std::size_t first, last;
    };
    [[nodiscard]] Lenses lensesOf(std::size_t x0, std::size_t x1) const;

    std::size_t views = 0;
    std::size_t lenses = 0;            ///< Number of lenses with slots.
    std::vector<int> viewOfSlot;       ///< View of each slot of a lens.
    std::vector<Span> spans;           ///< Per lens, for every width of views.
    std::vector<std::size_t> spansOf;  ///< Per slot of a lens, index into `spans`.
    std::vector<float> weights;

    std::size_t taps = 1;                  ///< Slots that a column uses.
    bool single = false;                   ///< Whether a column uses one slot with weight 1.
    std::vector<std::uint32_t> firstSlot;  ///< Per column.
    std::vector<float> tapWeights;         ///< Per column, one per tap.

private:
    void planColumns(const PrintLayout&);
    void planLenses(const PrintLayout&, const ViewSet&);

    std::int64_t firstLens_ = 0;
};

}  // namespace vitrine::printing
