#include "exhibits/printing/interlace.h"

#include "exhibits/printing/sheet.h"
#include "exhibits/printing/view_weights.h"
#include "render/failure.h"
#include "render/parallel.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

namespace vitrine::printing {
namespace {

constexpr double whole = 65536;  // Weight 1 of the kernels' encode8 and encode16.

/// Rows of the views that a printed row shows.
struct RowBlend {
    int first = 0;
    int count = 1;           ///< 1 or 2 rows when enlarging; more when the views have more rows than the print.
    std::uint16_t part = 0;  ///< Weight of the second row, if there are two.
    double from = 0, to = 0;
};

RowBlend rowBlend(std::int64_t y, std::int64_t height, int viewHeight, bool nearest)
{
    RowBlend rows;
    const double scale = static_cast<double>(viewHeight) / static_cast<double>(height);
    if (scale > 1) {
        rows.from = static_cast<double>(y) * scale;
        rows.to = std::min<double>(viewHeight, static_cast<double>(y + 1) * scale);
        rows.first = static_cast<int>(rows.from);
        rows.count = std::min(viewHeight, static_cast<int>(std::ceil(rows.to))) - rows.first;
        return rows;
    }
    const double center = (static_cast<double>(y) + 0.5) * scale;
    if (nearest) {
        rows.first = std::min(static_cast<int>(center), viewHeight - 1);
        return rows;
    }
    const double at = std::clamp(center - 0.5, 0.0, static_cast<double>(viewHeight - 1));
    rows.first = std::min(static_cast<int>(at), viewHeight - 1);
    rows.part = static_cast<std::uint16_t>(std::min(std::round((at - rows.first) * whole), whole - 1));
    rows.count = rows.part > 0 ? 2 : 1;
    return rows;
}

// Constants of the pattern in units of 2^-32, and the fraction of 52.9829189 in units of 2^-16. Integers that wrap
// around compute the fractions exactly, and identically everywhere.
constexpr std::uint32_t alongX = 288237660;  // 0.06711056
constexpr std::uint32_t alongY = 25070368;   // 0.00583715
constexpr std::uint32_t rest = 64417;        // 0.9829189

/// Returns the pattern, 0 to 2^16 - 1.
std::uint32_t pattern(std::uint32_t along)
{
    return (52 * along + (along >> 16U) * rest) >> 16U;
}

/// Channels are far apart in the pattern, so their grain does not add up to gray grain.
std::uint32_t placeOf(std::int64_t x, std::int64_t y, int channel)
{
    return alongX * static_cast<std::uint32_t>(x + 47 * channel) +
           alongY * static_cast<std::uint32_t>(y + 17 * channel);
}

/// Sampler of views for a raster whose lenses are not vertical: averages over one lens across and one pixel along.
class SlantedSampler {
public:
    SlantedSampler(const PrintLayout& layout, const ViewSet& views)
        : views_(views), width_(static_cast<double>(layout.width())),
          scaleY_(views.height() / static_cast<double>(layout.height()))
    {
        const bool acrossX = std::abs(layout.lensesPerPixelX()) >= std::abs(layout.lensesPerPixelY());
        boxX_ = acrossX ? 1 / std::abs(layout.lensesPerPixelX()) : 1;
        boxY_ = acrossX ? 1 : 1 / std::abs(layout.lensesPerPixelY());
    }

    /// Adds view `k` around (x, y), in pixels of the raster, multiplied by `weight`.
    void add(int k, double x, double y, float weight, std::array<float, 3>& sum)
    {
        const double scaleX = views_.view(k).width / width_;
        boxTaps(x * scaleX, boxX_ * scaleX, views_.view(k).width, columns_);
        boxTaps(y * scaleY_, boxY_ * scaleY_, views_.height(), rows_);
        for (std::size_t r = 0; r < rows_.weights.size(); ++r) {
            const std::uint16_t* at =
                views_.row(k, rows_.first + static_cast<int>(r)) + static_cast<std::size_t>(columns_.first) * 3;
            const float rowWeight = weight * rows_.weights[r];
            for (const float columnWeight : columns_.weights) {
                for (std::size_t c = 0; c < 3; ++c) sum[c] += rowWeight * columnWeight * static_cast<float>(at[c]);
                at += 3;
            }
        }
    }

private:
    const ViewSet& views_;
    double width_, scaleY_;
    double boxX_ = 1, boxY_ = 1;
    BoxTaps columns_{}, rows_{};
};

}  // namespace

double ditherAt(std::int64_t x, std::int64_t y, int channel)
{
    return pattern(placeOf(x, y, channel)) / 65536.0;
}

void ditherRows(const Region& region, const std::uint16_t* from, std::uint8_t* to)
{
    const auto width = static_cast<std::size_t>(region.x1 - region.x0);
    for (std::int64_t y = region.y0; y < region.y1; ++y, from += width * 3, to += width * 3) {
        for (int c = 0; c < 3; ++c) {
            std::uint32_t place = placeOf(region.x0, y, c);
            for (auto at = static_cast<std::size_t>(c); at < width * 3; at += 3, place += alongX) {
                to[at] = static_cast<std::uint8_t>((from[at] + ((257 * pattern(place)) >> 16U)) / 257);
            }
        }
    }
}

Interlacer::Interlacer(const PrintLayout& layout, const ViewSet& views, Instructions instructions)
    : layout_(layout.withoutBorder()), borderX_(layout.borderX()), borderY_(layout.borderY()), views_(views),
      kernels_(kernels::kernelsFor(instructions))
{
    if (views.count() != layout.settings().views) {
        throw Failure(ErrorKind::usage, "The print is laid out for " + std::to_string(layout.settings().views) +
                                            " views, and there are " + std::to_string(views.count()) + ".");
    }
    if (layout.settings().compensate) compensation_ = compensation(viewMixing(layout_));
    if (layout_.vertical()) plan_.emplace(layout_, views);
}

/// Buffers of one thread.
struct Interlacer::Workplace {
    explicit Workplace(const LensPlan& plan, bool compensates)
        : slots(plan.slotCount() * 3 + kernels::behindSlots), compensated(compensates ? slots.size() : 0)
    {
    }
    std::vector<const std::uint16_t*> rows{};
    std::vector<float> slots;        ///< Slots of a row.
    std::vector<float> compensated;  ///< Compensated slots of a row.
};

void Interlacer::interlaceViewRow(int row, const Region& region, Workplace& place, std::uint16_t* out) const
{
    const auto x0 = static_cast<std::size_t>(region.x0);
    const auto x1 = static_cast<std::size_t>(region.x1);
    const LensPlan::Lenses lenses = plan_->lensesOf(x0, x1);
    place.rows.clear();
    for (const int view : plan_->viewOfSlot) place.rows.push_back(views_.row(view, row));
    place.rows.resize(place.rows.size() + 3, place.rows.back());
    kernels_.filterLenses(*plan_, place.rows.data(), lenses, place.slots.data());
    views_.rowIsRead(row);
    const float* slots = place.slots.data();
    if (!compensation_.weights.empty()) {
        kernels::combineViews(*plan_, slots, compensation_.weights, lenses, place.compensated.data());
        slots = place.compensated.data();
    }
    kernels_.mixColumns(*plan_, slots, x0, x1, out);
}

template <typename Code> void Interlacer::fillVertical(const Region& region, Code* out) const
{
    const std::size_t samples = static_cast<std::size_t>(region.x1 - region.x0) * 3;
    const auto encode = [&](const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part) {
        if constexpr (sizeof(Code) == 1)
            kernels_.encode8(a, b, part, samples, out);
        else
            kernels_.encode16(a, b, part, samples, out);
    };
    Workplace place(*plan_, !compensation_.weights.empty());
    // Keeps the last two interlaced rows of the views. Printed rows come in order, so two are sufficient.
    const std::size_t room = samples + 2 * kernels::besideColumns;
    std::array<std::vector<std::uint16_t>, 2> kept{std::vector<std::uint16_t>(room), std::vector<std::uint16_t>(room)};
    std::array<int, 2> keptRow{-1, -1};
    const auto interlaced = [&](int row) -> const std::uint16_t* {
        const auto slot = static_cast<std::size_t>(row % 2);
        if (keptRow.at(slot) != row) {
            interlaceViewRow(row, region, place, kept.at(slot).data() + kernels::besideColumns);
            keptRow.at(slot) = row;
        }
        return kept.at(slot).data() + kernels::besideColumns;
    };
    std::vector<float> sum;
    RowBlend before{-1, 0};
    for (std::int64_t y = region.y0; y < region.y1; ++y, out += samples) {
        const RowBlend rows =
            rowBlend(y, layout_.height(), views_.height(), layout_.settings().method == Method::nearest);
        if (rows.count == 1 && before.count == 1 && rows.first == before.first) {
            std::memcpy(out, out - samples, samples * sizeof(Code));
        } else if (rows.count <= 2 && rows.to == 0) {
            const std::uint16_t* a = interlaced(rows.first);
            const std::uint16_t* b = rows.count == 2 ? interlaced(rows.first + 1) : a;
            encode(a, b, rows.part);
        } else {
            sum.assign(samples, 0.5F);
            for (int r = rows.first; r < rows.first + rows.count; ++r) {
                const std::uint16_t* a = interlaced(r);
                const auto weight = static_cast<float>(
                    (std::min<double>(rows.to, r + 1) - std::max<double>(rows.from, r)) / (rows.to - rows.from));
                for (std::size_t i = 0; i < samples; ++i) sum[i] += weight * static_cast<float>(a[i]);
            }
            std::vector<std::uint16_t> mean(samples);
            for (std::size_t i = 0; i < samples; ++i) mean[i] = static_cast<std::uint16_t>(std::min(sum[i], 65535.0F));
            encode(mean.data(), mean.data(), 0);
        }
        before = rows.to == 0 ? rows : RowBlend{-1, 0};
    }
}

template <typename Code> void Interlacer::fillSlanted(const Region& region, Code* out) const
{
    constexpr std::int64_t rowsBetween = 8;  // Rows after which rows on disk are released.
    constexpr double negligible = 1e-5;      // Smallest relevant weight of a view in another.
    const PrintSettings& settings = layout_.settings();
    const double pixelsX =
        layout_.printPitch() * settings.dpiX / mmPerInch * layout_.cosine();  // Pixels from lens to lens, across.
    const double pixelsY = layout_.printPitch() * settings.dpiY / mmPerInch * layout_.sine();
    const std::size_t samples = static_cast<std::size_t>(region.x1 - region.x0) * 3;
    std::vector<std::uint16_t> linear(samples);
    std::vector<ViewWeight> taps;
    SlantedSampler sampler(layout_, views_);
    for (std::int64_t y = region.y0; y < region.y1; ++y, out += samples) {
        std::uint16_t* pixel = linear.data();
        for (std::int64_t x = region.x0; x < region.x1; ++x, pixel += 3) {
            const double px = static_cast<double>(settings.mirror ? layout_.width() - 1 - x : x) + 0.5;
            const double py = static_cast<double>(y) + 0.5;
            viewWeightsAt(layout_, px, py, taps);
            const double u = layout_.lensAt(px, py);
            std::array<float, 3> sum{0.5F, 0.5F, 0.5F};
            for (const ViewWeight& tap : taps) {
                // The nearest point to the pixel on the lens's axis.
                const double off = static_cast<double>(tap.lens) + 0.5 - u;
                const double footX = px + off * pixelsX;
                const double footY = py + off * pixelsY;
                const auto weight = static_cast<float>(tap.weight);
                if (compensation_.weights.empty()) {
                    sampler.add(tap.view, footX, footY, weight, sum);
                    continue;
                }
                std::array<float, 3> combined{};
                for (int k = 0; k < views_.count(); ++k) {
                    const double share = compensation_.at(tap.view, k);
                    if (std::abs(share) > negligible) sampler.add(k, footX, footY, static_cast<float>(share), combined);
                }
                for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * std::clamp(combined[c], 0.0F, 65535.0F);
            }
            for (std::size_t c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint16_t>(std::min(sum[c], 65535.0F));
        }
        if constexpr (sizeof(Code) == 1)
            kernels_.encode8(linear.data(), linear.data(), 0, samples, out);
        else
            kernels_.encode16(linear.data(), linear.data(), 0, samples, out);
        if ((y - region.y0) % rowsBetween == rowsBetween - 1) views_.allIsRead();
    }
}

template <typename Code> void Interlacer::fillInner(const Region& region, Code* out) const
{
    if constexpr (sizeof(Code) == 1) {
        if (layout_.settings().dither) {
            constexpr std::int64_t band = 64;
            const auto samples = static_cast<std::size_t>(region.x1 - region.x0) * 3;
            std::vector<std::uint16_t> fine(samples * static_cast<std::size_t>(std::min(band, region.y1 - region.y0)));
            for (std::int64_t y = region.y0; y < region.y1; y += band) {
                const Region part{region.x0, y, region.x1, std::min(y + band, region.y1)};
                fillInner(part, fine.data());
                ditherRows(part, fine.data(), out + static_cast<std::size_t>(y - region.y0) * samples);
            }
            return;
        }
    }
    if (layout_.vertical())
        fillVertical(region, out);
    else
        fillSlanted(region, out);
}

template <typename Code> void Interlacer::fillPart(const Region& region, Code* out) const
{
    if (borderX_ == 0 && borderY_ == 0) return fillInner(region, out);
    const std::size_t stride = static_cast<std::size_t>(region.x1 - region.x0) * 3;
    std::fill_n(out, stride * static_cast<std::size_t>(region.y1 - region.y0), std::numeric_limits<Code>::max());
    const Region inner{std::max(region.x0 - borderX_, std::int64_t{0}), std::max(region.y0 - borderY_, std::int64_t{0}),
                       std::min(region.x1 - borderX_, layout_.width()),
                       std::min(region.y1 - borderY_, layout_.height())};
    if (inner.x0 >= inner.x1 || inner.y0 >= inner.y1) return;
    const std::size_t samples = static_cast<std::size_t>(inner.x1 - inner.x0) * 3;
    std::vector<Code> filled(samples * static_cast<std::size_t>(inner.y1 - inner.y0));
    fillInner(inner, filled.data());
    for (std::int64_t y = inner.y0; y < inner.y1; ++y) {
        Code* to = out + static_cast<std::size_t>(y + borderY_ - region.y0) * stride +
                   static_cast<std::size_t>(inner.x0 + borderX_ - region.x0) * 3;
        std::copy_n(filled.data() + static_cast<std::size_t>(y - inner.y0) * samples, samples, to);
    }
}

template <typename Code> void Interlacer::fillThreaded(const Region& region, Code* out, int threads) const
{
    assert(region.x0 >= 0 && region.y0 >= 0 && region.x1 <= layout_.width() + 2 * borderX_ &&
           region.y1 <= layout_.height() + 2 * borderY_);
    const std::int64_t rows = region.y1 - region.y0;
    const std::int64_t parts = std::clamp<std::int64_t>(threads, 1, std::max<std::int64_t>(rows, 1));
    render::onThreads(static_cast<std::size_t>(parts), [&](std::size_t thread) {
        const auto part = static_cast<std::int64_t>(thread);
        Region own = region;
        own.y0 = region.y0 + rows * part / parts;
        own.y1 = region.y0 + rows * (part + 1) / parts;
        Code* at =
            out + static_cast<std::size_t>(own.y0 - region.y0) * static_cast<std::size_t>(region.x1 - region.x0) * 3;
        fillPart(own, at);
    });
}

void Interlacer::fill(const Region& region, std::uint8_t* out, int threads) const
{
    fillThreaded(region, out, threads);
}

void Interlacer::fill(const Region& region, std::uint16_t* out, int threads) const
{
    fillThreaded(region, out, threads);
}

}  // namespace vitrine::printing
