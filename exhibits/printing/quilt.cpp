#include "exhibits/printing/quilt.h"

#include "render/files/number_text.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <regex>

namespace vitrine::printing {
namespace quilts {
namespace {

/// Name, columns, rows and aspect ratio.
const std::regex& suffix()
{
    static const std::regex pattern("(.*)_qs([0-9]{1,4})x([0-9]{1,4})a([0-9]*\\.?[0-9]+)");
    return pattern;
}

}  // namespace
}  // namespace quilts

std::optional<QuiltGrid> quiltNamed(const std::filesystem::path& path)
{
    std::smatch found;
    const std::string name = path.stem().string();
    if (!std::regex_match(name, found, quilts::suffix())) return std::nullopt;
    const auto number = [&](std::size_t i) {
        const std::string text = found[i].str();
        return render::parseNumber(text.front() == '.' ? '0' + text : text).value_or(0);
    };
    constexpr double most = 1000;
    const double columns = number(2), rows = number(3), aspect = number(4);
    if (columns < 1 || columns > most || rows < 1 || rows > most || !(aspect > 0)) return std::nullopt;
    return QuiltGrid{static_cast<int>(columns), static_cast<int>(rows), aspect};
}

std::filesystem::path quiltPath(const std::filesystem::path& path, const QuiltGrid& grid)
{
    std::smatch found;
    std::string name = path.stem().string();
    if (std::string plain = name; std::regex_match(plain, found, quilts::suffix())) name = found[1].str();
    const double aspect = std::round(grid.aspect * 1e4) / 1e4;
    name +=
        "_qs" + std::to_string(grid.columns) + 'x' + std::to_string(grid.rows) + 'a' + render::shortestNumber(aspect);
    return path.parent_path() / (name + path.extension().string());
}

render::Camera quiltCamera(const render::Camera& middle, int k, int count, double cone)
{
    const double part = count > 1 ? static_cast<double>(k) / (count - 1) - 0.5 : 0;
    const double tangent = std::tan(part * cone);
    const render::View view = render::makeView(middle, {});
    const glm::dvec3 right(glm::transpose(glm::dmat3(view.viewFromWorld))[0]);
    const glm::dvec3 move = right * (tangent * glm::length(middle.target - middle.eye));
    render::Camera camera = middle;
    camera.eye += move;
    camera.target += move;
    camera.lensShift.x -= tangent;
    return camera;
}

void placeInQuilt(render::Image& quilt, const render::Image& view, const QuiltGrid& grid, int k)
{
    assert(quilt.width == grid.columns * view.width && quilt.height == grid.rows * view.height);
    assert(quilt.channels == view.channels && k >= 0 && k < grid.count());
    const int left = k % grid.columns * view.width;
    const int top = (grid.rows - 1 - k / grid.columns) * view.height;
    for (int y = 0; y < view.height; ++y) {
        const auto from = view.pixels.begin() + static_cast<std::ptrdiff_t>(view.index(0, y));
        std::copy(from, from + static_cast<std::ptrdiff_t>(view.width) * view.channels,
                  quilt.pixels.begin() + static_cast<std::ptrdiff_t>(quilt.index(left, top + y)));
    }
}

}  // namespace vitrine::printing
