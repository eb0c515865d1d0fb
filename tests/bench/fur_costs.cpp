// What a coat costs: samples, time and error of the picture against shell count, silhouette, order and level
// of detail. Rows are measured in turn in each round, so that a noisy machine disturbs all alike. Prints
// tables and what they come to; passes or fails nothing.
//   bench_fur_costs [--size 640x360] [--rounds 5] [--only motion|calls|bodies|samples|counts|gaps|distance]

#include "exhibits/exhibits.h"
#include "exhibits/fur/bounce.h"
#include "exhibits/fur/fur.h"
#include "exhibits/museum/museum.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "render/measure/clock.h"
#include "tests/support/planned.h"

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
    double outline =
        0;  ///< Share of the pixels that only this picture or only the reference covers, of all that it covers.
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

/// Pixels that one picture covers and the other does not, over those that the second covers.
double outlineDifference(const render::Image& a, const render::Image& truth)
{
    int wrong = 0, covered = 0;
    for (std::size_t i = 3; i < truth.pixels.size(); i += 4) {
        wrong += (a.pixels[i] > 0.5F) != (truth.pixels[i] > 0.5F);
        covered += truth.pixels[i] > 0.5F;
    }
    return covered > 0 ? static_cast<double>(wrong) / covered : 0;
}

class Bench {
public:
    Bench(glm::ivec2 size, int rounds)
        : rounds_(rounds), fur_(*museum_.find("fur")), sceneState_(museum_.initialSceneState())
    {
        request_.alone = fur_;
        request_.camera = museum_.subject(fur_).bestView(sceneState_.values[fur_]);
        request_.raster.size = size;
        request_.transparent = true;
        renderer_.timeSteps(true);
        std::printf(
            "Picture: %d x %d, %d rounds in turn after 2 warm-up frames; times are medians of process CPU time.\n",
            size.x, size.y, rounds);
    }
    [[nodiscard]] const FurTable& table() const { return static_cast<const Fur&>(museum_.exhibit(fur_)).parameters(); }
    [[nodiscard]] Row row(std::string name, const std::function<void(ParameterValues&)>& change) const
    {
        Row row{std::move(name), museum_.initialSceneState().values[fur_], {}, {}, {}, {}, 0};
        change(row.values);
        return row;
    }
    void see(const render::Camera& camera) { request_.camera = camera; }
    /// Errors are against 16 samples per pixel of `reference`'s picture.
    std::vector<Row> run(const char* title, std::vector<Row> rows, const ParameterValues& reference)
    {
        draw(reference, 0, 1);
        const render::Image outline = renderer_.read("frame");
        const render::Image truth = average(reference);
        for (Row& row : rows) {
            // The order changes nothing in the picture (tested), only its cost.
            ParameterValues drawn = row.values;
            drawn.set(table().drawOrder, FurOrder::outerFirst);
            row.error = difference(average(drawn), truth);
            draw(row.values, 0, 1);
            row.outline = outlineDifference(renderer_.read("frame"), outline);
        }
        for (int i = 0; i < rounds_; ++i) {
            for (Row& row : rows) {
                row.last = draw(row.values, 0, 1);
                row.coat.push_back(millisecondsOf(row.last, "fur/coat") + millisecondsOf(row.last, "fur/fins"));
                row.shade.push_back(millisecondsOf(row.last, "fur/shade"));
                row.frame.push_back(row.last.milliseconds);
            }
        }
        std::printf("\n### %s\n\n| what | shells drawn | samples passed | coat, ms | light, ms | coat and light, ms | "
                    "frame, ms | error, 16 samples | outline wrong, %% |\n|---|---|---|---|---|---|---|---|---|\n",
                    title);
        for (const Row& row : rows)
            std::printf("| %s | %lld | %lld | %.1f | %.1f | %.1f | %.1f | %.4f | %.2f |\n", row.name.c_str(),
                        static_cast<long long>(row.last.counters.at("shells")),
                        static_cast<long long>(row.last.counters.at("samples")), median(row.coat), median(row.shade),
                        median(row.coat) + median(row.shade), median(row.frame), row.error, 100 * row.outline);
        std::fflush(stdout);
        return rows;
    }

    /// What a step of the bodies costs, and a thousand bodies' springs.
    void motion() const
    {
        std::printf("\n### Motion\n\n| what | microseconds, wall |\n|---|---|\n");
        const ParameterValues values = sceneState_.values[fur_];
        std::vector<double> perStep;
        for (int toss = 1; toss <= 5; ++toss) {
            ParameterValues tossed = values;
            tossed.set(table().toss, toss);
            Bounce bounce(bounceSettings(table(), tossed, nullptr, 0));
            const double start = render::wallSeconds();
            (void)bounce.at(2.0);
            perStep.push_back(1e6 * (render::wallSeconds() - start) / static_cast<double>(bounce.steps()));
        }
        std::printf("| one step of three bodies and their springs, first 2 s of a jump | %.1f |\n", median(perStep));
        for (const FurSpring method : {FurSpring::explicitEuler, FurSpring::semiImplicit, FurSpring::closedForm}) {
            std::vector<SpringState> springs(2000, SpringState{{1, 0.3, -0.2}, {4, 0, 1}});
            std::vector<double> times;
            for (int round = 0; round < 50; ++round) {
                const double start = render::wallSeconds();
                for (SpringState& s : springs) s = limited(advance(s, {0, -0.3, 0}, {14, 0.3}, 1.0 / 60, method), 2);
                times.push_back(1e6 * (render::wallSeconds() - start));
            }
            const char* const names[] = {"explicit Euler", "semi-implicit", "closed form"};
            std::printf("| two springs each of 1000 bodies, %s | %.1f |\n", names[static_cast<int>(method)],
                        median(times));
        }
        SpringState s{{1, 0, 0}, {0, 9, 0}};
        const double start = render::wallSeconds();
        s = advance(s, {}, {14, 0.3}, 3600, FurSpring::closedForm);
        std::printf("| an hour asleep, caught up (value left: %g) | %.2f |\n", s.value.x,
                    1e6 * (render::wallSeconds() - start));
    }
    /// One instanced draw for each body against one draw for each shell: the same picture.
    void calls()
    {
        std::printf("\n### Draw calls, 64 shells\n\n| what | draws | coat, ms |\n|---|---|---|\n");
        sceneState_.values[fur_].set(table().shellCount, 64);
        sceneState_.values[fur_].set(table().levelOfDetail, false);
        const render::FramePlan instanced = test::planned(museum_, sceneState_, request_, renderer_.persistentState());
        const render::FramePlan single = changed(instanced, [](render::Pass& pass) {
            if (pass.name != "fur/coat") return;
            const std::vector<render::Draw> whole = std::move(pass.draws);
            pass.draws.clear();
            for (const render::Draw& draw : whole) {
                for (int shell = 0; shell < draw.instances; ++shell) {
                    render::Draw one = draw;
                    one.instances = 1;
                    std::memcpy(one.object.data() + render::std140Offset<FurBody>("firstShell"), &shell, sizeof shell);
                    pass.draws.push_back(std::move(one));
                }
            }
        });
        std::vector<double> times[2];
        std::size_t draws[2] = {};
        for (int round = 0; round < rounds_ + 1; ++round) {
            int k = 0;
            for (const render::FramePlan* plan : {&instanced, &single}) {
                const double ms = millisecondsOf(renderer_.draw(*plan), "fur/coat");
                if (round > 0) times[k].push_back(ms);
                draws[k++] = plan->find("fur/coat")->draws.size();
            }
        }
        std::printf("| one instanced draw for each body | %zu | %.1f |\n| one draw for each shell | %zu | %.1f |\n",
                    draws[0], median(times[0]), draws[1], median(times[1]));
        sceneState_ = museum_.initialSceneState();
    }
    /// What each body costs as it stands in the best view, without the other two.
    void bodies()
    {
        std::printf(
            "\n### Cost of each body, as it stands\n\n| body | shells | coat, ms | light, ms |\n|---|---|---|---|\n");
        const render::FramePlan all = test::planned(museum_, sceneState_, request_, renderer_.persistentState());
        const char* const names[] = {"ball", "roll", "ring", "all three"};
        std::vector<double> coat[4], light[4];
        int shells[4] = {};
        for (int round = 0; round < rounds_ + 1; ++round) {
            for (std::size_t i = 0; i < 4; ++i) {
                shells[i] = 0;
                const render::FrameReport report = renderer_.draw(changed(all, [&](render::Pass& pass) {
                    if (pass.name != "fur/coat" && pass.name != "fur/shade") return;
                    if (i < 3) pass.draws = {pass.draws.at(i)};
                    if (pass.name == "fur/coat")
                        for (const render::Draw& draw : pass.draws) shells[i] += draw.instances;
                }));
                if (round == 0) continue;
                coat[i].push_back(millisecondsOf(report, "fur/coat"));
                light[i].push_back(millisecondsOf(report, "fur/shade"));
            }
        }
        for (std::size_t i = 0; i < 4; ++i)
            std::printf("| %s | %d | %.1f | %.1f |\n", names[i], shells[i], median(coat[i]), median(light[i]));
    }

private:
    static render::FramePlan changed(const render::FramePlan& plan, const std::function<void(render::Pass&)>& change)
    {
        render::FramePlan result;
        result.view = plan.view;
        for (const auto& [name, info] : plan.images()) result.image(info);
        for (render::Pass pass : plan.passes()) {
            change(pass);
            result.add(std::move(pass));
        }
        return result;
    }
    render::FrameReport draw(const ParameterValues& values, int sample, int samples)
    {
        sceneState_.values[fur_] = values;
        FrameRequest request = request_;
        request.sample = sample;
        request.samples = samples;
        return renderer_.draw(test::planned(museum_, sceneState_, request, renderer_.persistentState()));
    }
    render::Image average(const ParameterValues& values)
    {
        for (int i = 0; i < 16; ++i) draw(values, i, 16);
        return renderer_.read("frame");
    }

    const render::gl::HeadlessContext context_;
    render::gl::Renderer renderer_;
    const Museum museum_{allExhibits()};
    int rounds_;
    std::size_t fur_;
    SceneState sceneState_;
    FrameRequest request_;
};

}  // namespace

int main(int argc, char** argv)
{
    glm::ivec2 size(640, 360);
    int rounds = 5;
    const char* only = nullptr;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (std::strcmp(argv[i], "--only") == 0) only = argv[i + 1];
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
    const auto wanted = [only](const char* table) { return !only || std::strcmp(only, table) == 0; };
    if (wanted("motion")) bench.motion();
    if (wanted("calls")) bench.calls();
    if (wanted("bodies")) bench.bodies();
    const Row reference = bench.row("", [&](ParameterValues& v) {
        set(v, 256, FurSilhouette::march, FurOrder::outerFirst, false);
        v.set(t.samplesBetween, 32);
    });

    std::vector<Row> between{bench.row("as it stands", [](ParameterValues&) {})};
    for (const int shells : {8, 12, 16}) {
        for (const int samples : {1, 3, 5, 8}) {
            between.push_back(
                bench.row(std::to_string(shells) + " shells, up to " + std::to_string(samples) + " samples between",
                          [&](ParameterValues& v) {
                              set(v, shells, FurSilhouette::march, FurOrder::outerFirst, false);
                              v.set(t.samplesBetween, samples);
                          }));
        }
    }
    if (wanted("samples")) (void)bench.run("Samples between shells", between, reference.values);

    std::vector<Row> counts{bench.row("as it stands", [](ParameterValues&) {})};
    for (const int shells : {8, 10, 16, 32, 64, 128, 256}) {
        const std::string name = std::to_string(shells) + " shells";
        counts.push_back(bench.row(name + ", inner first", [&](ParameterValues& v) {
            set(v, shells, FurSilhouette::none, FurOrder::innerFirst, false);
        }));
        counts.push_back(bench.row(name + ", outer first", [&](ParameterValues& v) {
            set(v, shells, FurSilhouette::none, FurOrder::outerFirst, false);
        }));
        counts.push_back(bench.row(name + ", outer first, marched between", [&](ParameterValues& v) {
            set(v, shells, FurSilhouette::march, FurOrder::outerFirst, false);
        }));
    }
    if (wanted("counts")) {
        const std::vector<Row> rows = bench.run("Shell count, order, march", counts, reference.values);
        const Row& now = rows.front();
        const Row& bare = *std::find_if(rows.begin(), rows.end(),
                                        [](const Row& row) { return row.name == "64 shells, inner first"; });
        const auto samples = [](const Row& row) { return static_cast<double>(row.last.counters.at("samples")); };
        const auto time = [](const Row& row) { return median(row.coat) + median(row.shade); };
        std::printf("\nAs it stands, finding the strands of the three coats takes %.0f ms and lighting them %.0f ms "
                    "(goal: 60 together), with an error of %.3f. "
                    "64 bare shells drawn from inside out pass %.1f times the samples, take %.1f times as long, and "
                    "err by %.3f.\n",
                    median(now.coat), median(now.shade), now.error, samples(bare) / samples(now),
                    time(bare) / time(now), bare.error);
    }

    std::vector<Row> fringe;
    const char* const silhouettes[] = {"nothing", "fins", "shells by angle", "march"};
    for (const int shells : {10, 32})
        for (const FurSilhouette silhouette :
             {FurSilhouette::none, FurSilhouette::fins, FurSilhouette::byAngle, FurSilhouette::march})
            fringe.push_back(bench.row(
                std::to_string(shells) + " shells, gaps filled with " + silhouettes[static_cast<int>(silhouette)],
                [&](ParameterValues& v) { set(v, shells, silhouette, FurOrder::outerFirst, false); }));
    fringe.push_back(bench.row("40 shells, gaps filled with nothing", [&](ParameterValues& v) {
        set(v, 40, FurSilhouette::none, FurOrder::outerFirst, false);
    }));
    if (wanted("gaps")) {
        (void)bench.run("Gaps between shells, best view", fringe, reference.values);
        bench.see({{-1.05, 0.75, 1.1}, {-1.0, 0.62, 0}, 0.42});
        (void)bench.run("Gaps between shells, at the ball's silhouette", fringe, reference.values);
    }

    std::vector<Row> far;
    bench.see({{-0.3, 2.4, 8}, {0, 0.3, 0}, 0.62});
    for (const bool lod : {false, true})
        far.push_back(bench.row(lod ? "8 m away, level of detail" : "8 m away, all shells",
                                [&](ParameterValues& v) { v.set(t.levelOfDetail, lod); }));
    if (wanted("distance")) (void)bench.run("Level of detail", far, reference.values);
    return 0;
}
