// How still a picture in motion stands: the camera turns by exactly one pixel from frame to frame, and each picture is
// held against the one before, shifted back; and against a picture at rest of 64 samples. Prints Markdown.
//   bench_motion [--size 640x360]

#include "exhibits/hall/hall_table.h"
#include "tests/bench/bench_frame.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace {

using namespace vitrine;

const HallTable table;
constexpr int frames = 14;

/// Turned to the right about its own upright axis, by so many pixels in the middle of the picture.
render::Camera turned(const render::Camera& camera, double pixels, int rows)
{
    const double angle = std::atan(2 * std::tan(camera.fovY / 2) / rows) * pixels;
    const glm::dvec3 ahead = camera.target - camera.eye;
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0, 1, 0)));
    render::Camera result = camera;
    result.target = camera.eye + std::cos(angle) * ahead + std::sin(angle) * glm::length(ahead) * right;
    return result;
}

double levelOf(float linear)
{
    const double x = std::clamp(static_cast<double>(linear), 0.0, 1.0);
    return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

/// Over the middle part of the columns, where a turn shifts by whole pixels: percent of the pixels that differ by more
/// than 16 and than 48 levels in a channel, and the root mean square of all differences.
std::array<double, 3> difference(const render::Image& a, const render::Image& b, int shift)
{
    double over16 = 0;
    double over48 = 0;
    double squares = 0;
    double all = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = a.width * 35 / 100; x < a.width * 65 / 100; ++x, ++all) {
            double most = 0;
            for (int c = 0; c < 3; ++c) {
                const double d = std::abs(levelOf(a.at(x + shift, y, c)) - levelOf(b.at(x, y, c)));
                most = std::max(most, d);
                squares += d * d / 3;
            }
            over16 += most > 16 ? 1 : 0;
            over48 += most > 48 ? 1 : 0;
        }
    }
    return {100 * over16 / all, 100 * over48 / all, std::sqrt(squares / all)};
}

void line(bench::BenchFrame& bench, const render::Image& truth, int historyFrames)
{
    bench.sceneState.hall().set(table.temporalAntialiasing, historyFrames > 1);
    bench.sceneState.hall().set(table.historyFrames, historyFrames);
    bench.renderer.timeSteps(true);
    render::Image before;
    render::Image last;
    std::vector<double> shares;
    std::vector<double> times;
    for (int i = 1; i <= frames; ++i) {
        FrameRequest request;
        request.raster.size = bench.size;
        request.camera = turned(bench.museum.bestView(bench.exhibit, bench.values()), i - frames, bench.size.y);
        request.movingFrame = i;
        request.cut = i == 1;
        request.finished = true;
        const render::FrameReport report = bench.renderer.draw(bench.plan(request));
        before = std::move(last);
        last = bench.renderer.read("frame");
        double pass = 0;
        double whole = 0;
        for (const render::StepReport& step : report.ran) {
            whole += step.milliseconds;
            if (step.name == "antialias") pass += step.milliseconds;
        }
        times.push_back(pass);
        shares.push_back(100 * pass / whole);
    }
    std::sort(times.begin(), times.end());
    std::sort(shares.begin(), shares.end());
    const auto [over16, over48, unused] = difference(before, last, 1);
    std::printf("| %s | %d | %.2f | %.2f | %.2f | %.1f | %.1f %% |\n",
                std::string(bench.museum.subject(bench.exhibit).name()).c_str(), historyFrames, over16, over48,
                difference(truth, last, 0)[2], times[frames / 2], shares[frames / 2]);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv)
{
    glm::ivec2 size(640, 360);
    if (argc == 3 && std::strcmp(argv[1], "--size") == 0) std::sscanf(argv[2], "%dx%d", &size.x, &size.y);
    std::printf(
        "%d × %d, the last of %d frames. History: frames averaged over, 1 is none. Over 16, over 48: percent of "
        "the pixels in the middle that differ by more levels of 255 from the frame before, shifted back. Error: "
        "root mean square in levels against 64 samples at rest. Time: of the pass, and its share of the frame, "
        "medians.\n\n| view | history | over 16 | over 48 | error | ms | share |\n|---|---|---|---|---|---|---|\n",
        size.x, size.y, frames);
    for (const char* name : {"hall", "fur", "sdf_morph", "crepuscular_rays", "noise", "paper_lanterns"}) {
        bench::BenchFrame bench(name, size);
        PictureRequest atRest;
        atRest.frame.camera = bench.museum.bestView(bench.exhibit, bench.values());
        atRest.frame.raster.size = size;
        atRest.samples = 64;
        PictureMaker maker(bench.museum, bench.renderer, bench.sceneState, atRest);
        while (maker.step()) {
        }
        for (const int history : {1, 4, 8, 16, 32}) line(bench, maker.picture(), history);
    }
    return 0;
}
