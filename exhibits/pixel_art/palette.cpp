#include "exhibits/pixel_art/palette.h"

#include "render/image/oklab.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace vitrine::pixel_art {
namespace {

float luminance(const glm::vec3& linear)
{
    return glm::dot(linear, glm::vec3(0.2126F, 0.7152F, 0.0722F));
}

Rgb8 codeOf(const glm::vec3& linear)
{
    return {render::srgb8FromLinear(linear.r), render::srgb8FromLinear(linear.g), render::srgb8FromLinear(linear.b)};
}

/// Pixels of one cell of the median cut.
struct Cell {
    std::size_t begin, end;
};

/// Returns the axis along which a cell has the largest spread, and the spread.
std::pair<int, double> spread(std::span<const glm::vec3> lab, std::span<const std::uint32_t> order, const Cell& cell)
{
    glm::dvec3 sum(0), squares(0);
    for (std::size_t i = cell.begin; i < cell.end; ++i) {
        const glm::dvec3 p(lab[order[i]]);
        sum += p;
        squares += p * p;
    }
    const double n = static_cast<double>(cell.end - cell.begin);
    const glm::dvec3 total = squares - sum * sum / n;
    const int axis = total.x >= total.y && total.x >= total.z ? 0 : total.y >= total.z ? 1 : 2;
    return {axis, total[axis]};
}

std::vector<glm::vec3> medianCut(std::span<const glm::vec3> lab, int count)
{
    std::vector<std::uint32_t> order(lab.size());
    std::iota(order.begin(), order.end(), 0U);
    std::vector<Cell> cells{{0, lab.size()}};
    while (static_cast<int>(cells.size()) < count) {
        std::size_t widest = 0;
        std::pair<int, double> most{0, 0};
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (const auto s = spread(lab, order, cells[i]); s.second > most.second + 1e-9) {
                most = s;
                widest = i;
            }
        if (!(most.second > 1e-7)) break;
        Cell& cell = cells[widest];
        const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
        std::sort(at(cell.begin), at(cell.end), [&](std::uint32_t a, std::uint32_t b) {
            return lab[a][most.first] != lab[b][most.first] ? lab[a][most.first] < lab[b][most.first] : a < b;
        });
        const std::size_t middle = (cell.begin + cell.end) / 2;
        const Cell upper{middle, cell.end};
        cell.end = middle;
        cells.push_back(upper);
    }
    std::vector<glm::vec3> means;
    for (const Cell& cell : cells) {
        glm::dvec3 sum(0);
        for (std::size_t i = cell.begin; i < cell.end; ++i) sum += glm::dvec3(lab[order[i]]);
        means.emplace_back(sum / static_cast<double>(std::max<std::size_t>(cell.end - cell.begin, 1)));
    }
    return means;
}

std::size_t nearestIn(std::span<const glm::vec3> centers, const glm::vec3& p)
{
    std::size_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < centers.size(); ++i) {
        const glm::vec3 d = centers[i] - p;
        if (const float square = glm::dot(d, d); square < least) {
            least = square;
            best = i;
        }
    }
    return best;
}

}  // namespace

glm::vec3 oklab(const glm::vec3& c)
{
    return render::oklabFromLinear(c);
}

glm::vec3 linearOf(const Rgb8& c)
{
    const auto one = [](std::uint8_t code) { return static_cast<float>(render::linearFromSrgb(code / 255.0)); };
    return {one(c.r), one(c.g), one(c.b)};
}

int nearestColor(std::span<const Rgb8> palette, const glm::vec3& linear)
{
    std::vector<glm::vec3> lab;
    lab.reserve(palette.size());
    for (const Rgb8& c : palette) lab.push_back(oklab(linearOf(c)));
    return static_cast<int>(nearestIn(lab, oklab(linear)));
}

std::vector<Rgb8> mainColors(std::span<const glm::vec3> pixels, int count)
{
    if (pixels.empty()) return {};
    std::vector<glm::vec3> lab;
    lab.reserve(pixels.size());
    for (const glm::vec3& p : pixels) lab.push_back(oklab(glm::clamp(p, 0.0F, 1.0F)));
    std::vector<glm::vec3> centers = medianCut(lab, count);
    std::vector<glm::dvec3> linear;
    for (int round = 0; round < 6; ++round) {
        std::vector<glm::dvec3> sum(centers.size(), glm::dvec3(0));
        std::vector<glm::dvec3> light(centers.size(), glm::dvec3(0));
        std::vector<double> weight(centers.size(), 0);
        for (std::size_t i = 0; i < lab.size(); ++i) {
            const std::size_t c = nearestIn(centers, lab[i]);
            sum[c] += glm::dvec3(lab[i]);
            light[c] += glm::dvec3(glm::clamp(pixels[i], 0.0F, 1.0F));
            weight[c] += 1;
        }
        linear.clear();
        for (std::size_t c = 0; c < centers.size(); ++c)
            if (weight[c] > 0) {
                centers[c] = glm::vec3(sum[c] / weight[c]);
                linear.push_back(light[c] / weight[c]);
            }
    }
    std::vector<Rgb8> colors;
    for (const glm::dvec3& c : linear)
        if (const Rgb8 code = codeOf(glm::vec3(c)); std::find(colors.begin(), colors.end(), code) == colors.end())
            colors.push_back(code);
    return colors;
}

std::vector<Rgb8> mainColors(const render::Image& image, int count)
{
    const std::size_t all = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const std::size_t stride = std::max<std::size_t>(all / 65536, 1);
    std::vector<glm::vec3> pixels;
    for (std::size_t i = 0; i < all; i += stride) {
        const float* p = image.pixels.data() + i * static_cast<std::size_t>(image.channels);
        const int last = image.channels >= 3 ? 1 : 0;
        pixels.emplace_back(p[0], p[last], p[2 * last]);
    }
    return mainColors(pixels, count);
}

PaletteTextures paletteTextures(std::vector<Rgb8> colors)
{
    std::stable_sort(colors.begin(), colors.end(),
                     [](const Rgb8& a, const Rgb8& b) { return luminance(linearOf(a)) < luminance(linearOf(b)); });
    PaletteTextures made;
    made.colors = std::move(colors);
    auto linear = std::make_shared<render::Texture>();
    linear->name = "palette";
    linear->width = static_cast<int>(made.colors.size());
    linear->height = 1;
    linear->repeat = linear->mipmaps = false;
    std::vector<glm::vec3> lab;
    for (const Rgb8& c : made.colors) {
        const glm::vec3 l = linearOf(c);
        lab.push_back(oklab(l));
        linear->floats.insert(linear->floats.end(), {l.r, l.g, l.b, 1});
    }
    auto nearest = std::make_shared<render::Texture>();
    nearest->name = "nearest of the palette";
    nearest->width = nearest->height = nearest->layers = 32;
    nearest->channels = 1;
    nearest->repeat = nearest->mipmaps = false;
    for (int b = 0; b < 32; ++b)
        for (int g = 0; g < 32; ++g)
            for (int r = 0; r < 32; ++r) {
                const auto light = [](int step) { return static_cast<float>(render::linearFromSrgb(step / 31.0)); };
                nearest->bytes.push_back(
                    static_cast<std::uint8_t>(nearestIn(lab, oklab({light(r), light(g), light(b)}))));
            }
    made.linear = std::move(linear);
    made.nearest = std::move(nearest);
    return made;
}

}  // namespace vitrine::pixel_art
