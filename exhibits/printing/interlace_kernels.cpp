#include "exhibits/printing/interlace_kernels.h"

#include "exhibits/printing/kernel_sets.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <cstring>
#include <memory>

namespace vitrine::printing {

Instructions bestInstructions()
{
#if defined(__x86_64__)
    static const Instructions best = [] {
        return __builtin_cpu_supports("avx2") != 0 ? Instructions::avx2 : Instructions::plain;
    }();
    return best;
#else
    return Instructions::plain;
#endif
}

namespace kernels {
namespace {

using Four = float __attribute__((vector_size(16)));
using FourCodes = std::uint16_t __attribute__((vector_size(8)));
using FourInts = std::int32_t __attribute__((vector_size(16)));

/// Loads three floats that are used and one that is not.
Four load(const float* at)
{
    Four four;
    std::memcpy(&four, at, sizeof four);
    return four;
}

Four samples(const std::uint16_t* at)
{
    FourCodes codes;
    std::memcpy(&codes, at, sizeof codes);
    return __builtin_convertvector(__builtin_convertvector(codes, FourInts), Four);
}

void filterLenses(const LensPlan& plan, const std::uint16_t* const* rows, LensPlan::Lenses lenses, float* slots)
{
    for (std::size_t lens = lenses.first; lens < lenses.last; ++lens) {
        float* out = slots + lens * plan.views * 3;
        for (std::size_t slot = 0; slot < plan.views; ++slot, out += 3) {
            const LensPlan::Span span = plan.spans[plan.spansOf[slot] + lens];
            const std::uint16_t* at = rows[slot] + static_cast<std::size_t>(span.column) * 3;
            const float* w = plan.weights.data() + span.first;
            Four even{};
            Four odd{};
            for (int pair = 0; pair < span.pairs; ++pair, at += 6, w += 8) {
                even += samples(at) * w[0];
                odd += samples(at + 3) * w[3];
            }
            const Four mean = even + odd;
            std::memcpy(out, &mean, sizeof mean);
        }
    }
}

void mixColumns(const LensPlan& plan, const float* slots, std::size_t x0, std::size_t x1, std::uint16_t* out)
{
    const float* weight = plan.tapWeights.data() + x0 * plan.taps;
    for (std::size_t x = x0; x < x1; ++x, out += 3) {
        const float* slot = slots + static_cast<std::size_t>(plan.firstSlot[x]) * 3;
        Four sum = load(slot) * *weight++;
        for (std::size_t tap = 1; tap < plan.taps; ++tap) sum += load(slot + tap * 3) * *weight++;
        const FourCodes codes = __builtin_convertvector(__builtin_convertvector(sum + 0.5F, FourInts), FourCodes);
        std::memcpy(out, &codes, sizeof codes);
    }
}

void blend(const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, int drop, std::size_t count,
           std::uint16_t* out)
{
    for (std::size_t i = 0; i < count; ++i) out[i] = blended(a[i], b[i], part, drop);
}

}  // namespace

const Codes8& codes8()
{
    static const auto table = [] {
        Codes8 t{};
        for (std::size_t i = 0; i < t.size(); ++i)
            t.at(i) = render::srgb8FromLinear(static_cast<float>((static_cast<double>(i << dropped) + 3.5) / 65535));
        return t;
    }();
    return table;
}

const Codes16& codes16()
{
    static const auto table = [] {
        auto t = std::make_unique<Codes16>();
        for (std::size_t i = 0; i < t->size(); ++i)
            t->at(i) = render::srgb16FromLinear(static_cast<float>(static_cast<double>(i) / 65535));
        return t;
    }();
    return *table;
}

const Kernels plainKernels = {
    filterLenses, mixColumns,
    [](const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count, std::uint8_t* out) {
        blendAndLookUp<blend, dropped>(a, b, part, codes8().data(), count, out);
    },
    [](const std::uint16_t* a, const std::uint16_t* b, std::uint16_t part, std::size_t count, std::uint16_t* out) {
        blendAndLookUp<blend, 0>(a, b, part, codes16().data(), count, out);
    }};

const Kernels& kernelsFor(Instructions instructions)
{
#if defined(__x86_64__)
    if (instructions == Instructions::avx2) return avx2Kernels;
#endif
    (void)instructions;
    return plainKernels;
}

void combineViews(const LensPlan& plan, const float* slots, const std::vector<double>& matrix, LensPlan::Lenses lenses,
                  float* out)
{
    const std::size_t views = plan.views;
    std::vector<std::size_t> slotOf(views);
    for (std::size_t slot = 0; slot < views; ++slot) slotOf[static_cast<std::size_t>(plan.viewOfSlot[slot])] = slot;
    for (std::size_t lens = lenses.first; lens < lenses.last; ++lens) {
        const float* from = slots + lens * views * 3;
        float* to = out + lens * views * 3;
        for (std::size_t slot = 0; slot < views; ++slot, to += 3) {
            const double* row = matrix.data() + static_cast<std::size_t>(plan.viewOfSlot[slot]) * views;
            Four sum{};
            for (std::size_t k = 0; k < views; ++k) sum += load(from + slotOf[k] * 3) * static_cast<float>(row[k]);
            for (std::size_t c = 0; c < 3; ++c) to[c] = std::clamp(sum[static_cast<int>(c)], 0.0F, 65535.0F);
        }
    }
}

}  // namespace kernels
}  // namespace vitrine::printing
