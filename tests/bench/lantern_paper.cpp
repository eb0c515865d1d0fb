// What light goes through a lantern's paper, and what comes back: sheets by several ways to reckon them against light
// that is followed scattering by scattering in three dimensions at float64. Prints Markdown.
//   bench_lantern_paper [photons of the reference]

#include "exhibits/paper_lanterns/paper_lanterns_cpu.h"
#include "tests/exhibits/paper_lanterns/traced_sheet.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

namespace {

using namespace vitrine;

/// Scattering and absorption times thickness, as the exhibit's rows name them.
struct Paper {
    const char* name;
    double scatter, absorb;
};

/// The paper of the first look in red and in blue, a dyed one, thin, thick, and one that absorbs nothing.
constexpr Paper papers[] = {{"as it opens, red", 1.6, 0.0007},
                            {"as it opens, blue", 1.6, 0.4},
                            {"dyed", 1.6, 0.85},
                            {"thin", 0.4, 0.05},
                            {"thick", 6, 0.5},
                            {"absorbs nothing", 2.5, 0}};

using Shares = test::SheetShares;

Shares traced(const Paper& paper, std::uint64_t photons, std::uint64_t seed)
{
    return test::tracedSlab(paper.scatter, paper.absorb, photons, seed);
}

/// What is not absorbed goes on: paper that does not scatter.
Shares absorptionAlone(const Paper& paper)
{
    return {std::exp(-paper.absorb), 0, 1};
}

/// As the source has it: all light on both sides.
Shares allOnBothSides(const Paper&)
{
    return {1, 1, 0};
}

/// Light is scattered once, half of it back, and then goes on straight.
Shares scatteredOnce(const Paper& paper)
{
    const double through = std::exp(-paper.absorb - paper.scatter);
    const double once = std::exp(-paper.absorb) - through;
    return {through + 0.5 * once, 0.5 * once, 2};
}

/// The exhibit's.
Shares twoStreams(const Paper& paper)
{
    const auto sheet = glsl::sheetOf(paper.scatter, paper.absorb);
    return {sheet.transmitted, sheet.reflected, 2};
}

using Way = std::function<Shares(const Paper&)>;

void row(const char* name, const Way& way, const std::vector<Shares>& truth, int repeats)
{
    double worst = 0, squares = 0, work = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const Shares found = way(papers[i]);
        const double t = found.transmitted - truth[i].transmitted, r = found.reflected - truth[i].reflected;
        worst = std::max({worst, std::abs(t), std::abs(r)});
        squares += (t * t + r * r) / static_cast<double>(2 * truth.size());
        work += static_cast<double>(found.work) / static_cast<double>(truth.size());
    }
    const auto begun = std::chrono::steady_clock::now();
    double kept = 0;
    for (int i = 0; i < repeats; ++i) kept += way(papers[static_cast<std::size_t>(i) % std::size(papers)]).transmitted;
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begun;
    std::printf("| %s | %.4f | %.4f | %.0f | %.3g |\n", name, std::sqrt(squares), worst, work,
                kept >= 0 ? took.count() / repeats : 0);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv)
{
    const std::uint64_t photons = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 20000000;
    std::vector<Shares> truth;
    std::printf("\n## Sheets\n\nTraced: %.0f million photons each, float64, three dimensions, even scattering, light "
                "from all directions.\n\n| paper | scatters | absorbs | transmitted, traced | by two streams | "
                "reflected, traced | by two streams |\n|---|---|---|---|---|---|---|\n",
                static_cast<double>(photons) * 1e-6);
    for (const Paper& paper : papers) {
        truth.push_back(traced(paper, photons, 1));
        const Shares ours = twoStreams(paper);
        std::printf("| %s | %.2f | %.4f | %.4f | %.4f | %.4f | %.4f |\n", paper.name, paper.scatter, paper.absorb,
                    truth.back().transmitted, ours.transmitted, truth.back().reflected, ours.reflected);
        std::fflush(stdout);
    }
    std::printf("\n## Ways to reckon a sheet\n\nErrors of what is transmitted and reflected, over all papers above. "
                "Work: scatterings followed, or exponentials.\n\n| way | RMSE | largest error | work per sheet | "
                "microseconds per sheet |\n|---|---|---|---|---|\n");
    row("all light on both sides, as in the source", allOnBothSides, truth, 1000000);
    row("absorption alone", absorptionAlone, truth, 1000000);
    row("scattered once", scatteredOnce, truth, 1000000);
    row("two streams in closed form (ours)", twoStreams, truth, 1000000);
    for (const std::uint64_t count : {100U, 1000U, 10000U, 100000U}) {
        char name[64];
        std::snprintf(name, sizeof(name), "traced, %d photons", static_cast<int>(count));
        row(
            name, [&](const Paper& paper) { return traced(paper, count, 2); }, truth, 12);
    }
    return 0;
}
