#include "exhibits/kit/blue_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace vitrine {
namespace {

constexpr int side = 64;
constexpr int count = side * side;
constexpr double sigma = 1.9;  ///< Texels; Ulichney recommends 1.5, but a little more is better at this size.

using Four = float __attribute__((vector_size(16)));
using FourInts = std::int32_t __attribute__((vector_size(16)));

/// Set texels, and the density of every texel: a sum of Gaussians around the set ones, which wraps around.
class Pattern {
public:
    Pattern()
    {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const double dx = std::min(x, side - x);
                const double dy = std::min(y, side - y);
                auto bump = static_cast<float>(std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)));
                // Processors add denormal numbers slowly, and these change no sum that is compared.
                if (bump < std::numeric_limits<float>::min()) bump = 0;
                bump_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = bump;
                bump_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x + side)] = bump;
            }
        }
    }

    void flip(int at)
    {
        const float sign = isSet(at) ? -1.0F : 1.0F;
        set_[static_cast<std::size_t>(at)] = isSet(at) ? 0 : -1;
        const int ax = at % side;
        const int ay = at / side;
        for (int y = 0; y < side; ++y) {
            const float* bump = bump_[static_cast<std::size_t>((y - ay + side) % side)].data() + (side - ax);
            float* crowd = crowd_.data() + static_cast<std::ptrdiff_t>(y) * side;
            for (int x = 0; x < side; x += 4) {
                Four four, bumps;
                std::memcpy(&four, crowd + x, sizeof four);
                std::memcpy(&bumps, bump + x, sizeof bumps);
                four += sign * bumps;
                std::memcpy(crowd + x, &four, sizeof four);
            }
        }
    }

    /// Returns the set texel in the tightest cluster, or the free one in the largest void; the first of equal ones.
    [[nodiscard]] int extreme(bool set) const
    {
        // Four texels at a time: a start of the program waits for some thousand calls.
        const Four worst = Four{} + (set ? -1.0F : std::numeric_limits<float>::max());
        const FourInts sought = FourInts{} - (set ? 1 : 0);
        Four best = worst;
        for (int i = 0; i < count; i += 4) {
            Four crowd;
            FourInts isSet;
            std::memcpy(&crowd, crowd_.data() + i, sizeof crowd);
            std::memcpy(&isSet, set_.data() + i, sizeof isSet);
            crowd = isSet == sought ? crowd : worst;
            best = (set ? crowd > best : crowd < best) ? crowd : best;
        }
        float value = best[0];
        for (int lane = 1; lane < 4; ++lane) value = set ? std::max(value, best[lane]) : std::min(value, best[lane]);
        for (int i = 0; i < count; ++i)
            if (isSet(i) == set && crowd_[static_cast<std::size_t>(i)] == value) return i;
        return -1;
    }

private:
    [[nodiscard]] bool isSet(int at) const { return set_[static_cast<std::size_t>(at)] != 0; }

    std::array<std::int32_t, count> set_{};  ///< -1: set, 0: free.
    std::array<float, count> crowd_{};
    std::array<std::array<float, std::size_t(2) * side>, side>
        bump_{};  ///< Each row twice, so that it can wrap around.
};

std::vector<int> ranks()
{
    Pattern pattern;
    std::uint32_t state = 1;
    int ones = 0;
    std::array<bool, count> chosen{};
    while (ones < count / 10) {
        state = state * 747796405U + 2891336453U;
        const int at = static_cast<int>(state >> 20U);
        if (chosen[static_cast<std::size_t>(at)]) continue;
        chosen[static_cast<std::size_t>(at)] = true;
        pattern.flip(at);
        ++ones;
    }
    // Spreads the first points: the tightest cluster moves into the largest void, until that is where it came from.
    for (int i = 0; i < count; ++i) {
        const int from = pattern.extreme(true);
        pattern.flip(from);
        const int to = pattern.extreme(false);
        pattern.flip(to);
        if (to == from) break;
    }
    std::vector<int> rank(count);
    Pattern shrinking = pattern;
    for (int i = ones - 1; i >= 0; --i) {
        const int at = shrinking.extreme(true);
        shrinking.flip(at);
        rank[static_cast<std::size_t>(at)] = i;
    }
    for (int i = ones; i < count; ++i) {
        const int at = pattern.extreme(false);
        pattern.flip(at);
        rank[static_cast<std::size_t>(at)] = i;
    }
    return rank;
}

}  // namespace

std::shared_ptr<const render::Texture> blueNoise()
{
    static const std::shared_ptr<const render::Texture> made = [] {
        auto texture = std::make_shared<render::Texture>();
        texture->name = "blue noise";
        texture->width = texture->height = side;
        texture->channels = 1;
        texture->mipmaps = false;
        for (const int rank : ranks()) texture->bytes.push_back(static_cast<std::uint8_t>(rank * 256 / count));
        return texture;
    }();
    return made;
}

}  // namespace vitrine
