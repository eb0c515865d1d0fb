#include "app/kit/command.h"
#include "app/kit/report.h"
#include "app/kit/say.h"
#include "app/kit/useless_option.h"
#include "app/queue/study_in_parts.h"
#include "app/study/study_folder.h"
#include "app/study/study_options.h"

#include "exhibits/exhibits.h"
#include "exhibits/framework/files/preset.h"
#include "exhibits/study/study_situation.h"
#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numeric>
#include <optional>

namespace vitrine::app {
namespace {

/// Progress line that is overwritten while the study runs. Prints nothing if `watched` is false.
class StudyLine {
public:
    explicit StudyLine(bool watched) : watched_(watched) {}
    ~StudyLine()
    {
        if (shown_ >= 0) std::fprintf(stderr, "\r\033[K");
    }
    StudyLine(const StudyLine&) = delete;
    StudyLine& operator=(const StudyLine&) = delete;

    void show(double progress, const std::string& doing)
    {
        const int percent = static_cast<int>(100 * progress);
        if (!watched_ || percent == shown_) return;
        shown_ = percent;
        std::fprintf(stderr, "\r\033[K%3d %%  %s", percent, doing.c_str());
        std::fflush(stderr);
    }

private:
    bool watched_;
    int shown_ = -1;
};

void printTable(Subjects subjects, const StudyRequest& request, const StudyResult& result, CostAxis axis)
{
    const StudyCosts costs = costsAlong(axis, request, result);
    std::printf("%-44s %12s %14s %12s %10s\n", "setting", std::string(toString(request.metric)).c_str(),
                costTitle(result.costName).c_str(), "ms, median", "spread");
    // A curve is sorted by its parameter. A search lists the front and the present setting by cost.
    std::vector<std::size_t> shown(result.points.size());
    std::iota(shown.begin(), shown.end(), std::size_t{0});
    if (request.axes.size() > 2) {
        std::erase_if(shown, [&](std::size_t i) { return result.points[i].dominated && result.present != i; });
        std::sort(shown.begin(), shown.end(),
                  [&](std::size_t a, std::size_t b) { return result.points[a].cost < result.points[b].cost; });
    }
    for (const std::size_t i : shown) {
        const StudyPoint& p = result.points[i];
        std::string marks;
        if (costs.knee == i) marks += " knee";
        if (result.present == i) marks += " present";
        if (costs.settings[i].cost > 0 && !costs.onFront(i)) marks += " dominated";
        if (p.uncertain) marks += " uncertain";
        std::printf("%-44s %12.4g %14.8g ", pointText(subjects, request, p).c_str(), p.error, p.cost);
        if (p.time)
            std::printf("%12.3f %10.3f%s\n", p.time->median, p.time->spread, marks.c_str());
        else
            std::printf("%12s %10s%s\n", "-", "-", marks.c_str());
    }
    std::printf("Clock: %s, %s; taking a time adds %.4f ms to a picture.\n%s\n", result.clock.c_str(),
                result.clockTrusted ? "trusted" : "not trusted", result.overheadMilliseconds,
                result.convergence.c_str());
    std::vector<std::string> sentences = situationSentences(subjects, request, result);
    sentences.push_back(lawSentence(costs));
    sentences.push_back(choiceSentence(subjects, request, result));
    for (const std::string& sentence : sentences)
        if (!sentence.empty()) std::printf("%s\n", sentence.c_str());
}

/// Returns the chosen values as a preset of the exhibit; for the hall, as an exhibition.
std::string chosenPreset(const Museum& museum, const Study& study)
{
    const StudyResult& result = study.result();
    if (!result.choice || !result.choice->holds) return {};
    const SceneState sceneState = study.sceneStateOf(result.points[result.choice->point]);
    const std::size_t subject = study.request().subject;
    const std::string name = "Chosen by a study";
    for (const StudyAxis& axis : study.request().axes)
        if (axis.subject != subject)
            return exhibitionText({name, namedValues(museum.subjects(), sceneState.values), sceneState.camera});
    return presetText(
        Preset{std::string(museum.subject(subject).name()), name, sceneState.values[subject], std::nullopt});
}

StudyRequest requestOf(const Museum& museum, const StudyOptions& options)
{
    std::vector<std::string> notes;
    StudyRequest request = studyRequest(museum, options, notes);
    for (const std::string& note : notes) say(note);
    return request;
}

/// Measured study with its museum and renderer. `parts` is passed to Study.
struct MeasuredStudy {
    MeasuredStudy(const StudyOptions& options, StudyParts* parts)
        : study(museum, renderer, requestOf(museum, options), parts)
    {
        StudyLine line(isatty(STDERR_FILENO) != 0);
        while (study.step()) line.show(study.progress(), study.doing());
    }

    render::gl::HeadlessContext context;
    Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    Study study;
};

int makePart(const StudyOptions& options)
{
    return runPart(options.out, parseShard(options.part.shard), [&](Parts& parts) {
        StudyInParts kept(parts, true);
        return std::optional(MeasuredStudy(options, &kept).context.info().renderer);
    });
}

void refuseUselessOptions(const CLI::App& command, const StudyOptions& o)
{
    const std::size_t named = o.parameters.size();
    refuseOn(command, "--points", !o.values.empty(), "a study of --values");
    refuseOn(command, "--settings", named == 1 || named == 2, "a study of one or two parameters");
    refuseOn(command, "--alone", o.subject == "hall", "the hall as a whole");
}

int runStudy(const StudyOptions& options)
{
    requireStudyFolder(options.out);
    const std::optional<CostAxis> asked = costAxisOption(options.cost);
    if (!options.part.shard.empty()) return makePart(options);
    std::optional<Parts> parts;
    if (options.part.fromParts) parts.emplace(std::filesystem::path(options.out));
    std::optional<StudyInParts> found;
    if (parts) found.emplace(*parts, false);
    const MeasuredStudy measured(options, found ? &*found : nullptr);
    const Museum& museum = measured.museum;
    const Study& study = measured.study;
    const std::string preset = chosenPreset(museum, study);
    const CostAxis costs = chartCosts(study.result(), asked);
    writeStudyFolder(options.out, museum.subjects(), study, machineJson(measured.context.info()), preset, costs);
    printTable(museum.subjects(), study.request(), study.result(), costs);
    std::printf("The study is in %s/index.html\n", options.out.c_str());
    if (!options.maxError && !options.maxMilliseconds) return 0;
    if (!preset.empty()) {
        std::printf("The preset is %s/preset.json\n", options.out.c_str());
        return 0;
    }
    say(choiceSentence(museum.subjects(), study.request(), study.result()) +
        " Nothing was chosen; allow more, or study other parameters.");
    return static_cast<int>(Blame::check);
}

}  // namespace

void addStudyCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command =
        parser.add_subcommand("study", "Measure what accuracy costs: error over work and time, with pictures");
    auto options = std::make_shared<StudyOptions>();
    addStudyOptions(*command, *options);
    command->add_option("--cost", options->cost,
                        "Cost in chart.svg and chart.png: ms (milliseconds per picture) or work (counted). Default: ms "
                        "if the clock is reliable. The page shows both");
    addPartOptions(*command, options->part);
    command->callback([&chosen, options, command] {
        chosen = [options, command] {
            refuseUselessOptions(*command, *options);
            return runStudy(*options);
        };
    });
}

}  // namespace vitrine::app
