// Interlacer compared with simple loops that do the same operations pixel by pixel: equal bits for any settings and
// with all instruction sets of the processor.

#include "exhibits/printing/interlace.h"
#include "exhibits/printing/sheet.h"
#include "exhibits/printing/view_weights.h"
#include "render/image/srgb.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace vitrine::printing {
namespace {

using Pixel = std::array<float, 3>;

std::vector<Instructions> allInstructions()
{
    std::vector<Instructions> all{Instructions::plain};
    if (bestInstructions() != Instructions::plain) all.push_back(Instructions::avx2);
    return all;
}

std::uint8_t code8(std::uint32_t linear)
{
    return render::srgb8FromLinear(static_cast<float>((static_cast<double>(linear / 8 * 8) + 3.5) / 65535));
}

std::uint16_t code16(std::uint32_t linear)
{
    return render::srgb16FromLinear(static_cast<float>(static_cast<double>(linear) / 65535));
}

std::uint32_t between(std::uint32_t a, std::uint32_t b, std::uint32_t part)
{
    return b > a ? a + (b - a) * part / 65536 : a - (a - b) * part / 65536;
}

/// Reference print, computed pixel by pixel.
class StraightforwardPrint {
public:
    StraightforwardPrint(const PrintLayout& layout, const ViewSet& views)
        : bordered_(layout), layout_(layout.withoutBorder()), views_(views)
    {
        if (layout.settings().compensate) compensation_ = compensation(viewMixing(layout_));
    }

    [[nodiscard]] std::uint16_t at16(std::int64_t x, std::int64_t y, std::size_t c)
    {
        return onPaper(x, y) ? std::uint16_t{65535}
                             : code16(linearAt(x - bordered_.borderX(), y - bordered_.borderY(), c));
    }
    [[nodiscard]] std::uint8_t at8(std::int64_t x, std::int64_t y, std::size_t c)
    {
        if (onPaper(x, y)) return 255;
        x -= bordered_.borderX();
        y -= bordered_.borderY();
        const std::uint32_t linear = linearAt(x, y, c);
        if (!layout_.settings().dither) return code8(linear);
        const auto grain = static_cast<std::uint32_t>(ditherAt(x, y, static_cast<int>(c)) * 65536);
        return static_cast<std::uint8_t>((code16(linear) + 257 * grain / 65536) / 257);
    }

private:
    [[nodiscard]] bool onPaper(std::int64_t x, std::int64_t y) const
    {
        x -= bordered_.borderX();
        y -= bordered_.borderY();
        return x < 0 || y < 0 || x >= layout_.width() || y >= layout_.height();
    }

    std::uint32_t linearAt(std::int64_t x, std::int64_t y, std::size_t c)
    {
        if (x != x_ || y != y_) {
            x_ = x;
            y_ = y;
            pixel_ = layout_.vertical() ? vertical(x, y) : slanted(x, y);
        }
        return pixel_.at(c);
    }

    /// Returns the color that a lens shows of a row of a view.
    Pixel lensOf(int k, std::int64_t lens, int row)
    {
        const auto printWidth = static_cast<double>(layout_.width());
        const int width = views_.view(k).width;
        const double scale = width / printWidth;
        const double axis =
            (static_cast<double>(lens) - layout_.settings().phase) / layout_.lensesPerPixelX() + printWidth / 2;
        boxTaps(axis * scale, scale / layout_.lensesPerPixelX(), width, box_);
        Pixel even{};
        Pixel odd{};
        for (std::size_t i = 0; i < box_.weights.size(); ++i) {
            const std::uint16_t* at = views_.row(k, row) + (static_cast<std::size_t>(box_.first) + i) * 3;
            Pixel& sum = i % 2 == 0 ? even : odd;
            for (std::size_t c = 0; c < 3; ++c) sum.at(c) += static_cast<float>(at[c]) * box_.weights[i];
        }
        for (std::size_t c = 0; c < 3; ++c) even.at(c) += odd.at(c);
        return even;
    }

    /// Returns the same with the compensation of other views.
    Pixel compensatedLens(int view, std::int64_t lens, int row)
    {
        if (compensation_.weights.empty()) return lensOf(view, lens, row);
        Pixel sum{};
        for (int k = 0; k < views_.count(); ++k) {
            const Pixel own = lensOf(k, lens, row);
            const auto weight = static_cast<float>(compensation_.at(view, k));
            for (std::size_t c = 0; c < 3; ++c) sum.at(c) += weight * own.at(c);
        }
        for (float& channel : sum) channel = std::clamp(channel, 0.0F, 65535.0F);
        return sum;
    }

    std::array<std::uint32_t, 3> interlaced(std::int64_t x, int row)
    {
        const std::int64_t front = layout_.settings().mirror ? layout_.width() - 1 - x : x;
        viewWeightsAt(layout_, static_cast<double>(front) + 0.5, 0, taps_);
        Pixel sum{};
        for (const ViewWeight& tap : taps_) {
            const Pixel lens = compensatedLens(tap.view, tap.lens, row);
            for (std::size_t c = 0; c < 3; ++c) sum.at(c) += lens.at(c) * static_cast<float>(tap.weight);
        }
        std::array<std::uint32_t, 3> codes{};
        for (std::size_t c = 0; c < 3; ++c) codes.at(c) = static_cast<std::uint32_t>(sum.at(c) + 0.5F);
        return codes;
    }

    std::array<std::uint32_t, 3> vertical(std::int64_t x, std::int64_t y)
    {
        const int height = views_.height();
        const double scale = static_cast<double>(height) / static_cast<double>(layout_.height());
        std::array<std::uint32_t, 3> mixed{};
        if (scale > 1) {  // Mean of several rows.
            const double from = static_cast<double>(y) * scale;
            const double to = std::min<double>(height, static_cast<double>(y + 1) * scale);
            Pixel sum{0.5F, 0.5F, 0.5F};
            for (int r = static_cast<int>(from); r < std::min(height, static_cast<int>(std::ceil(to))); ++r) {
                const auto weight =
                    static_cast<float>((std::min<double>(to, r + 1) - std::max<double>(from, r)) / (to - from));
                const std::array<std::uint32_t, 3> row = interlaced(x, r);
                for (std::size_t c = 0; c < 3; ++c) sum.at(c) += weight * static_cast<float>(row.at(c));
            }
            for (std::size_t c = 0; c < 3; ++c) mixed.at(c) = static_cast<std::uint32_t>(std::min(sum.at(c), 65535.0F));
            return mixed;
        }
        const double center = (static_cast<double>(y) + 0.5) * scale;
        if (layout_.settings().method == Method::nearest)
            return interlaced(x, std::min(static_cast<int>(center), height - 1));
        const double at = std::clamp(center - 0.5, 0.0, static_cast<double>(height - 1));
        const int first = std::min(static_cast<int>(at), height - 1);
        const auto part = static_cast<std::uint32_t>(std::min(std::round((at - first) * 65536), 65535.0));
        if (part == 0) return interlaced(x, first);
        const std::array<std::uint32_t, 3> a = interlaced(x, first);
        const std::array<std::uint32_t, 3> b = interlaced(x, first + 1);
        for (std::size_t c = 0; c < 3; ++c) mixed.at(c) = between(a.at(c), b.at(c), part);
        return mixed;
    }

    /// Adds view k around a place of the raster: over one lens across the lenses, over one pixel along them.
    void addSample(int k, double x, double y, float weight, Pixel& sum)
    {
        const bool acrossX = std::abs(layout_.lensesPerPixelX()) >= std::abs(layout_.lensesPerPixelY());
        const int width = views_.view(k).width;
        const double scaleX = width / static_cast<double>(layout_.width());
        const double scaleY = views_.height() / static_cast<double>(layout_.height());
        boxTaps(x * scaleX, (acrossX ? 1 / std::abs(layout_.lensesPerPixelX()) : 1) * scaleX, width, box_);
        boxTaps(y * scaleY, (acrossX ? 1 : 1 / std::abs(layout_.lensesPerPixelY())) * scaleY, views_.height(), rows_);
        for (std::size_t r = 0; r < rows_.weights.size(); ++r)
            for (std::size_t i = 0; i < box_.weights.size(); ++i) {
                const std::uint16_t* at =
                    views_.row(k, rows_.first + static_cast<int>(r)) + (static_cast<std::size_t>(box_.first) + i) * 3;
                for (std::size_t c = 0; c < 3; ++c)
                    sum.at(c) += weight * rows_.weights[r] * box_.weights[i] * static_cast<float>(at[c]);
            }
    }

    std::array<std::uint32_t, 3> slanted(std::int64_t x, std::int64_t y)
    {
        const PrintSettings& s = layout_.settings();
        const double px = static_cast<double>(s.mirror ? layout_.width() - 1 - x : x) + 0.5;
        const double py = static_cast<double>(y) + 0.5;
        viewWeightsAt(layout_, px, py, taps_);
        const double u = layout_.lensAt(px, py);
        Pixel sum{0.5F, 0.5F, 0.5F};
        for (const ViewWeight& tap : taps_) {
            const double off = static_cast<double>(tap.lens) + 0.5 - u;
            const double footX = px + off * (layout_.printPitch() * s.dpiX / 25.4 * layout_.cosine());
            const double footY = py + off * (layout_.printPitch() * s.dpiY / 25.4 * layout_.sine());
            const auto weight = static_cast<float>(tap.weight);
            if (compensation_.weights.empty()) {
                addSample(tap.view, footX, footY, weight, sum);
                continue;
            }
            Pixel combined{};
            for (int k = 0; k < views_.count(); ++k) {
                const double share = compensation_.at(tap.view, k);
                if (std::abs(share) > 1e-5) addSample(k, footX, footY, static_cast<float>(share), combined);
            }
            for (std::size_t c = 0; c < 3; ++c) sum.at(c) += weight * std::clamp(combined.at(c), 0.0F, 65535.0F);
        }
        std::array<std::uint32_t, 3> codes{};
        for (std::size_t c = 0; c < 3; ++c) codes.at(c) = static_cast<std::uint32_t>(std::min(sum.at(c), 65535.0F));
        return codes;
    }

    PrintLayout bordered_, layout_;
    const ViewSet& views_;
    ViewMatrix compensation_;
    std::vector<ViewWeight> taps_;
    BoxTaps box_, rows_;
    std::int64_t x_ = -1, y_ = -1;
    std::array<std::uint32_t, 3> pixel_{};
};

double part()
{
    return *rc::gen::inRange(0, 1000) / 1000.0;
}

/// Returns views of noise, with black and white at some places.
ViewSet anyViews(int count)
{
    const int width = *rc::gen::inRange(1, 180);
    const int height = *rc::gen::inRange(1, 24);
    const int widths = *rc::gen::element(1, 1, 3);
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    ViewSet views(*rc::gen::element(std::size_t{0}, ViewSet::usualMemory, ViewSet::usualMemory));
    for (int k = 0; k < count; ++k) {
        render::Image image(width + k % widths, height, 3);
        for (float& sample : image.pixels)
            sample = std::clamp(static_cast<float>(random() % 65536) / 52000.0F - 0.1F, 0.0F, 1.0F);
        views.add(image);
    }
    return views;
}

PrintSettings anySettings(int views, bool vertical)
{
    PrintSettings s;
    const double lpi = *rc::gen::inRange(10, 150) + part();
    s.sheet = derivedSheet("test", lpi, 40);
    s.dpiX = lpi * (1.2 + 30 * part());
    s.dpiY = vertical ? lpi * (1 + 20 * part()) : s.dpiX * (1 + part());
    s.width = *rc::gen::inRange(1, vertical ? 240 : 60) / s.dpiX * 25.4;
    s.height = *rc::gen::inRange(1, vertical ? 30 : 20) / s.dpiY * 25.4;
    s.border = *rc::gen::element(0, 0, 3) / s.dpiX * 25.4;
    s.phase = 2 * part() - 1;
    s.direction = vertical ? 0 : *rc::gen::element(90.0, 12.3, -33.3, -90.0, 70.0);
    s.reverse = *rc::gen::arbitrary<bool>();
    s.mirror = *rc::gen::arbitrary<bool>();
    s.views = views;
    s.method = *rc::gen::element(Method::nearest, Method::area, Method::guard);
    s.guard = part();
    s.dither = *rc::gen::inRange(0, 4) == 0;
    s.compensate = views <= 12 && *rc::gen::inRange(0, 4) == 0;
    return s;
}

/// Requires equal bits with all instruction sets, for the whole raster and a part of it, with both code sizes.
void requireSameBits(const PrintLayout& layout, const ViewSet& views)
{
    StraightforwardPrint print(layout, views);
    const std::int64_t x0 = *rc::gen::inRange<std::int64_t>(0, layout.width());
    const std::int64_t y0 = *rc::gen::inRange<std::int64_t>(0, layout.height());
    const Region piece{x0, y0, *rc::gen::inRange<std::int64_t>(x0, layout.width()) + 1,
                       *rc::gen::inRange<std::int64_t>(y0, layout.height()) + 1};
    const int threads = *rc::gen::inRange(1, 4);
    for (const Region& region : {Region{0, 0, layout.width(), layout.height()}, piece}) {
        std::vector<std::uint8_t> eight;
        std::vector<std::uint16_t> sixteen;
        for (std::int64_t y = region.y0; y < region.y1; ++y)
            for (std::int64_t x = region.x0; x < region.x1; ++x)
                for (std::size_t c = 0; c < 3; ++c) {
                    eight.push_back(print.at8(x, y, c));
                    sixteen.push_back(print.at16(x, y, c));
                }
        for (const Instructions instructions : allInstructions()) {
            const Interlacer maker(layout, views, instructions);
            // Starts at an odd address, with a guard byte behind.
            std::vector<std::uint8_t> out(eight.size() + 2, 99);
            maker.fill(region, out.data() + 1, threads);
            RC_ASSERT(std::equal(eight.begin(), eight.end(), out.begin() + 1));
            RC_ASSERT(out.front() == 99);
            RC_ASSERT(out.back() == 99);
            std::vector<std::uint16_t> out16(sixteen.size() + 1, 99);
            maker.fill(region, out16.data(), threads);
            out16.pop_back();
            RC_ASSERT(out16 == sixteen);
        }
    }
}

RC_GTEST_PROP(InterlacerProperty, VerticalLensesGiveTheBitsOfAStraightforwardLoop, ())
{
    const int views = *rc::gen::inRange(1, 61);
    requireSameBits(PrintLayout(anySettings(views, true)), anyViews(views));
}

RC_GTEST_PROP(InterlacerProperty, OtherLensesGiveTheBitsOfAStraightforwardLoop, ())
{
    const int views = *rc::gen::inRange(1, 61);
    requireSameBits(PrintLayout(anySettings(views, false)), anyViews(views));
}

TEST(InterlacerKernels, EveryLinearValueHasTheSameCodeByAllInstructions)
{
    std::vector<std::uint16_t> linear(65536);
    std::vector<std::uint8_t> eight(linear.size());
    std::vector<std::uint16_t> sixteen(linear.size());
    for (std::size_t i = 0; i < linear.size(); ++i) {
        linear[i] = static_cast<std::uint16_t>(i);
        eight[i] = code8(static_cast<std::uint32_t>(i));
        sixteen[i] = code16(static_cast<std::uint32_t>(i));
    }
    for (const Instructions instructions : allInstructions()) {
        const kernels::Kernels& kernels = kernels::kernelsFor(instructions);
        std::vector<std::uint8_t> out(linear.size());
        kernels.encode8(linear.data(), linear.data(), 0, linear.size(), out.data());
        EXPECT_EQ(out, eight);
        std::vector<std::uint16_t> out16(linear.size());
        kernels.encode16(linear.data(), linear.data(), 0, linear.size(), out16.data());
        EXPECT_EQ(out16, sixteen);
    }
}

TEST(InterlacerKernels, BlendsOfAnyLengthAndPlaceAreTheSameByAllInstructions)
{
    std::mt19937 random(5);
    std::vector<std::uint16_t> a(400);
    std::vector<std::uint16_t> b(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = static_cast<std::uint16_t>(random());
        b[i] = i % 3 == 0 ? a[i] : static_cast<std::uint16_t>(random());
    }
    for (std::size_t count = 1; count < 300; count += 1 + count / 20)
        for (const std::uint16_t part : {std::uint16_t{1}, std::uint16_t{32768}, std::uint16_t{65535}}) {
            const std::size_t from = random() % 64;
            std::vector<std::uint8_t> expected(a.size() + 1, 7);
            for (std::size_t i = 0; i < count; ++i) expected[from + i] = code8(between(a[i + 1], b[i + 1], part));
            for (const Instructions instructions : allInstructions()) {
                std::vector<std::uint8_t> out(expected.size(), 7);
                kernels::kernelsFor(instructions).encode8(a.data() + 1, b.data() + 1, part, count, out.data() + from);
                EXPECT_EQ(out, expected) << count << ' ' << part;
            }
        }
}

}  // namespace
}  // namespace vitrine::printing
