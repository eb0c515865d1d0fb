#include "app/stability_report.h"

#include "app/kit/progress.h"

#include "exhibits/exhibits.h"
#include "exhibits/stability/stability_cases.h"
#include "render/failure.h"
#include "render/files/strict_json.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "render/measure/clock.h"
#include "render/version.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace vitrine::app {
namespace {

using render::Json;
using stability::arithmeticCases;
using stability::pictureCases;
using stability::scanExhibit;
using stability::StabilityProgress;
using stability::StabilityResult;

std::string measured(double x)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", x);
    return text;
}

const char* resultText(const StabilityResult& r)
{
    if (!r.tried) return "not run";
    return r.passed ? "holds" : "FAILS";
}

/// Called for each result as soon as it is known.
using Tell = std::function<void(const StabilityResult&)>;

void printHead(const render::gl::ContextInfo& gl)
{
    std::printf("vitrine   %s\nrenderer  %s\nversion   %s\n\n", render::programVersion().c_str(), gl.renderer.c_str(),
                gl.version.c_str());
    // The texts are the last column, so that none is too long.
    std::printf("%-5s %-7s %10s %10s  %s\n", "case", "result", "value", "limit", "what");
}

/// Prints a line at once, so that a run that is ended early still tells what it tried.
void printLine(const StabilityResult& r)
{
    std::printf("%-5s %-7s %10s %10s  %s\n", r.number.c_str(), resultText(r), measured(r.value).c_str(),
                measured(r.limit).c_str(), r.what.c_str());
    if (!r.detail.empty()) std::printf("      %s\n", r.detail.c_str());
    std::fflush(stdout);
}

void printVerdict(const std::vector<StabilityResult>& results)
{
    const auto failed =
        std::count_if(results.begin(), results.end(), [](const StabilityResult& r) { return !r.passed; });
    const bool all = std::all_of(results.begin(), results.end(), [](const StabilityResult& r) { return r.tried; });
    if (failed == 0)
        std::printf("\nEverything%s holds.\n", all ? "" : " that was tried");
    else
        std::printf("\n%d of %d do not hold. Please send this table to the people who make Vitrine.\n",
                    static_cast<int>(failed), static_cast<int>(results.size()));
}

Json asJson(const render::gl::ContextInfo& gl, const StabilityOptions& options,
            const std::vector<StabilityResult>& results, bool limited)
{
    Json cases = Json::array();
    for (const StabilityResult& r : results)
        cases.push_back(Json{{"case", r.number},
                             {"what", r.what},
                             {"tried", r.tried},
                             {"holds", r.tried ? Json(r.passed) : Json(nullptr)},
                             {"value", std::isfinite(r.value) ? Json(r.value) : Json("infinite")},
                             {"limit", r.limit},
                             {"detail", r.detail}});
    return Json{
        {"version", render::programVersion()},
        {"opengl",
         Json{{"renderer", gl.renderer}, {"vendor", gl.vendor}, {"version", gl.version}, {"software", gl.software}}},
        {"presets", options.presets},
        {"firstSeed", options.firstSeed},
        {"minutes", options.minutes},
        {"limitedByTime", limited},
        {"cases", std::move(cases)}};
}

/// Shares the time among the steps of the report, and shows its progress.
class Budget {
public:
    explicit Budget(double minutes) : end_(render::wallSeconds() + 60 * minutes) { line_.estimate(); }

    /// Returns a callback for a step that may use this share of the time that is left. `from` and `to` are the parts of
    /// the whole report, 0 to 1, where the step begins and ends.
    [[nodiscard]] StabilityProgress step(double share, double from, double to)
    {
        const double now = render::wallSeconds();
        const double until = now + share * std::max(end_ - now, 0.0);
        return [this, until, from, to](double part) {
            line_.show(from + (to - from) * part);
            const bool over = render::wallSeconds() > until;
            limited_ = limited_ || (over && part < 1);
            return !over;
        };
    }
    [[nodiscard]] bool limited() const { return limited_; }  ///< Something was left out for lack of time.

private:
    ProgressLine line_{"hard cases and random settings"};
    double end_;
    bool limited_ = false;
};

/// Runs all cases. Returns whether something was left out for lack of time.
bool runCases(const StabilityOptions& options, const Tell& tell, std::vector<StabilityResult>& results)
{
    const auto add = [&](StabilityResult r) {
        tell(r);
        results.push_back(std::move(r));
    };
    const Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    Budget budget(options.minutes);
    const std::size_t count = museum.subjects().size();
    constexpr double pictures = 0.25;  // Part of the progress before the random settings.
    for (StabilityResult& r : arithmeticCases(renderer)) add(std::move(r));
    for (StabilityResult& r : pictureCases(museum, renderer, budget.step(0.5, 0.02, pictures))) add(std::move(r));
    const auto partAt = [&](std::size_t i) {
        return pictures + (1 - pictures) * static_cast<double>(i) / static_cast<double>(count);
    };
    for (std::size_t i = 0; i < count; ++i)
        add(scanExhibit(museum, renderer, i, options.firstSeed, options.presets,
                        budget.step(1 / static_cast<double>(count - i), partAt(i), partAt(i + 1))));
    return budget.limited();
}

}  // namespace

int stabilityReport(const StabilityOptions& options)
{
    std::fprintf(stderr,
                 "vitrine: trying the hard cases, then up to %d random settings of each exhibit, for %g minutes at "
                 "most.\n",
                 options.presets, options.minutes);
    const render::gl::HeadlessContext context;
    std::vector<StabilityResult> results;
    if (!options.asJson) printHead(context.info());
    const bool limited = runCases(options, options.asJson ? Tell([](const StabilityResult&) {}) : printLine, results);
    if (options.asJson)
        std::fputs(render::writeJson(asJson(context.info(), options, results, limited)).c_str(), stdout);
    else
        printVerdict(results);
    if (!options.asJson && limited)
        std::printf("The time of %g minutes was over before %d settings of each exhibit were tried; --minutes gives "
                    "more.\n",
                    options.minutes, options.presets);
    const bool good = std::all_of(results.begin(), results.end(), [](const StabilityResult& r) { return r.passed; });
    return good ? 0 : static_cast<int>(ErrorKind::check);
}

}  // namespace vitrine::app
