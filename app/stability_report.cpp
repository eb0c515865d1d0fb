#include "app/stability_report.h"

#include "app/kit/progress.h"

#include "exhibits/exhibits.h"
#include "exhibits/stability/stability_cases.h"
#include "render/failure.h"
#include "render/files/strict_json.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "render/version.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace vitrine::app {
namespace {

using render::Json;

std::string measured(double x)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", x);
    return text;
}

void printTable(const render::gl::ContextInfo& gl, const std::vector<StabilityResult>& results)
{
    std::printf("vitrine   %s\nrenderer  %s\nversion   %s\n\n", render::programVersion().c_str(), gl.renderer.c_str(),
                gl.version.c_str());
    std::size_t width = 0;
    for (const StabilityResult& r : results) width = std::max(width, r.what.size());
    std::printf("%-5s %-*s %-6s %10s %10s\n", "case", static_cast<int>(width), "what", "result", "value", "limit");
    for (const StabilityResult& r : results) {
        std::printf("%-5s %-*s %-6s %10s %10s\n", r.number.c_str(), static_cast<int>(width), r.what.c_str(),
                    r.passed ? "holds" : "FAILS", measured(r.value).c_str(), measured(r.limit).c_str());
        if (!r.detail.empty()) std::printf("      %s\n", r.detail.c_str());
    }
    const auto failed =
        std::count_if(results.begin(), results.end(), [](const StabilityResult& r) { return !r.passed; });
    if (failed == 0)
        std::printf("\nEverything holds.\n");
    else
        std::printf("\n%d of %d do not hold. Please send this table to the people who make Vitrine.\n",
                    static_cast<int>(failed), static_cast<int>(results.size()));
}

Json asJson(const render::gl::ContextInfo& gl, const StabilityOptions& options,
            const std::vector<StabilityResult>& results)
{
    Json cases = Json::array();
    for (const StabilityResult& r : results)
        cases.push_back(Json{{"case", r.number},
                             {"what", r.what},
                             {"holds", r.passed},
                             {"value", std::isfinite(r.value) ? Json(r.value) : Json("infinite")},
                             {"limit", r.limit},
                             {"detail", r.detail}});
    return Json{
        {"version", render::programVersion()},
        {"opengl",
         Json{{"renderer", gl.renderer}, {"vendor", gl.vendor}, {"version", gl.version}, {"software", gl.software}}},
        {"presets", options.presets},
        {"firstSeed", options.firstSeed},
        {"cases", std::move(cases)}};
}

}  // namespace

int stabilityReport(const StabilityOptions& options)
{
    const render::gl::HeadlessContext context;
    const Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    std::fprintf(stderr, "vitrine: trying the hard cases, then %d random settings of each exhibit.\n", options.presets);
    std::vector<StabilityResult> results;
    {
        ProgressLine line("hard cases and random settings");
        line.estimate();
        const auto total = static_cast<double>(museum.subjects().size()) + 1;
        results = arithmeticCases(renderer);
        line.show(0.5 / total);
        for (StabilityResult& r : pictureCases(museum, renderer)) results.push_back(std::move(r));
        for (std::size_t i = 0; i < museum.subjects().size(); ++i)
            results.push_back(scanExhibit(museum, renderer, i, options.firstSeed, options.presets, [&](int drawn) {
                line.show((1 + static_cast<double>(i) + static_cast<double>(drawn) / options.presets) / total);
            }));
    }
    if (options.asJson)
        std::fputs(render::writeJson(asJson(context.info(), options, results)).c_str(), stdout);
    else
        printTable(context.info(), results);
    const bool good = std::all_of(results.begin(), results.end(), [](const StabilityResult& r) { return r.passed; });
    return good ? 0 : static_cast<int>(ErrorKind::check);
}

}  // namespace vitrine::app
