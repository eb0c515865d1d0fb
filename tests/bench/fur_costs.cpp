// What a coat costs: samples, time and error of the picture against shell count, silhouette, order and level
// of detail. Rows are measured in turn in each round, so that a noisy machine disturbs all alike. Prints
// tables; passes or fails nothing.
//   bench_fur_costs [--size 640x360] [--rounds 5]

#include "exhibits/exhibits.h"
#include "exhibits/framework/museum.h"
#include "exhibits/fur/fur.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace vitrine;

struct Row {
    std::string name;
    ParameterValues values;
    std::vector<double> coat, shade, frame;
    render::FrameReport last;
    double error = 0;
};

double median(std::vector<double> values)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double millisecondsOf(const render::FrameReport& report, const char* pass)
{
    for (const render::StepReport& step : report.ran)
        if (step.name == pass) return step.milliseconds;
    return 0;
}

/// Root of the mean squared difference over the pixels that either picture covers.
double difference(const render::Image& a, const render::Image& b)
{
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
        if (a.pixels[i + 3] <= 0 && b.pixels[i + 3] <= 0) continue;
        for (std::size_t c = 0; c < 3; ++c) sum += std::pow(a.pixels[i + c] - b.pixels[i + c], 2);
        count += 3;
    }
    return count > 0 ? std::sqrt(sum / count) : 0;
}

class Bench {
public:
    Bench(glm::ivec2 size, int rounds) : rounds_(rounds), fur_(*museum_.find("fur")), look_(museum_.initialLook())
    {
        request_.alone = fur_;
        request_.camera = museum_.exhibits()[fur_]->bestView(look_.values[fur_]);
        request_.raster.size = size;
        request_.transparent = true;
        renderer_.timeSteps(true);
        std::printf("Renderer: %s\nSize: %d x %d, %d rounds in turn after 2 warm-up frames, medians\n", context_.info().renderer.c_str(), size.x, size.y, rounds);
    }
    [[nodiscard]] const FurTable& table() const { return static_cast<const Fur&>(*museum_.exhibits()[fur_]).parameters(); }
    [[nodiscard]] Row row(std::string name, const std::function<void(ParameterValues&)>& change) const
    {
        Row row{std::move(name), look_.values[fur_], {}, {}, {}, {}, 0};
        change(row.values);
        return row;
    }
    /// Errors are against 16 samples per pixel of `reference`'s picture.
    void run(const char* title, std::vector<Row> rows, const ParameterValues& reference)
    {
        const render::Image truth = average(reference);
        for (Row& row : rows) {
            row.error = difference(average(row.values), truth);
            draw(row.values, 0, 1);
        }
        for (int i = 0; i < rounds_; ++i) {
            for (Row& row : rows) {
                row.last = draw(row.values, 0, 1);
                row.coat.push_back(millisecondsOf(row.last, "fur/coat"));
                row.shade.push_back(millisecondsOf(row.last, "fur/shade"));
                row.frame.push_back(row.last.milliseconds);
            }
        }
        std::printf("\n### %s\n\n| what | shells drawn | samples passed | coat, ms | shade, ms | frame, ms | error, 16 samples |\n|---|---|---|---|---|---|---|\n", title);
        for (const Row& row : rows)
            std::printf("| %s | %lld | %lld | %.1f | %.1f | %.1f | %.4f |\n", row.name.c_str(), static_cast<long long>(row.last.counters.at("shells")),
                        static_cast<long long>(row.last.counters.at("samples")), median(row.coat), median(row.shade), median(row.frame), row.error);
        std::fflush(stdout);
    }

private:
    render::FrameReport draw(const ParameterValues& values, int sample, int samples)
    {
        look_.values[fur_] = values;
        FrameRequest request = request_;
        request.sample = sample;
        request.samples = samples;
        return renderer_.draw(museum_.plan(look_, request, renderer_.kept()));
    }
    render::Image average(const ParameterValues& values)
    {
        for (int i = 0; i < 16; ++i) draw(values, i, 16);
        return renderer_.read("frame");
    }

    const render::gl::HeadlessContext context_;
    render::gl::Renderer renderer_;
    const Museum museum_;
    int rounds_;
    std::size_t fur_;
    Look look_;
    FrameRequest request_;
};

}  // namespace

int main(int argc, char** argv)
{
    glm::ivec2 size(640, 360);
    int rounds = 5;
    bool brief = false;
    for (int i = 1; i < argc; ++i) brief = brief || std::strcmp(argv[i], "--brief") == 0;
    for (int i = 1; i + 1 < argc; ++i) {
        if (std::strcmp(argv[i], "--size") == 0) std::sscanf(argv[i + 1], "%dx%d", &size.x, &size.y);
        if (std::strcmp(argv[i], "--rounds") == 0) rounds = std::max(std::atoi(argv[i + 1]), 1);
    }
    Bench bench(size, rounds);
    const FurTable& t = bench.table();
    const auto set = [&t](ParameterValues& v, int shells, FurSilhouette silhouette, FurOrder order, bool lod) {
        v.set(t.shellCount, shells);
        v.set(t.silhouette, silhouette);
        v.set(t.drawOrder, order);
        v.set(t.levelOfDetail, lod);
    };
    const Row reference = bench.row("", [&](ParameterValues& v) { set(v, 256, FurSilhouette::march, FurOrder::outerFirst, false); v.set(t.samplesBetween, 32); });

    std::vector<Row> between{bench.row("as it stands", [](ParameterValues&) {})};
    for (const int shells : {8, 12, 16}) {
        for (const int samples : {1, 3, 5, 8}) {
            between.push_back(bench.row(std::to_string(shells) + " shells, up to " + std::to_string(samples) + " samples between", [&](ParameterValues& v) {
                set(v, shells, FurSilhouette::march, FurOrder::outerFirst, false);
                v.set(t.samplesBetween, samples);
            }));
        }
    }
    if (brief) between.erase(between.begin() + 1, between.end());
    bench.run("Samples between shells", between, reference.values);
    if (brief) return 0;

    std::vector<Row> counts{bench.row("as it stands", [](ParameterValues&) {})};
    for (const int shells : {8, 16, 32, 64, 128, 256}) {
        const std::string name = std::to_string(shells) + " shells";
        counts.push_back(bench.row(name + ", inner first", [&](ParameterValues& v) { set(v, shells, FurSilhouette::none, FurOrder::innerFirst, false); }));
        counts.push_back(bench.row(name + ", outer first", [&](ParameterValues& v) { set(v, shells, FurSilhouette::none, FurOrder::outerFirst, false); }));
        counts.push_back(bench.row(name + ", outer first, marched between", [&](ParameterValues& v) { set(v, shells, FurSilhouette::march, FurOrder::outerFirst, false); }));
    }
    bench.run("Shell count, order, march", counts, reference.values);
    return 0;
}
