#include "app/kit/command.h"
#include "app/kit/findings.h"
#include "app/study/study_comparison_folder.h"

#include "exhibits/study/study_store.h"
#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/text/joined.h"
#include "ui/study/comparison_chart.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

using study::ComparedCurve;
using study::compareStudies;
using study::KeptStudy;
using study::labelsOf;
using study::nameOfStudyFile;
using study::parseStudies;
using study::sharedCosts;
using study::StudyAndJson;
using study::StudyComparison;
using study::StudyDifference;
using study::studyLimits;
using study::TimesDiffer;
using study::timesDiffer;

constexpr std::size_t mostStudies = 8;

struct ComparisonOptions {
    std::vector<std::string> files;
    std::string cost;
    std::string out;
    bool asJson = false;
};

std::vector<KeptStudy> readAll(const std::vector<std::string>& files)
{
    std::vector<KeptStudy> studies;
    for (const std::string& file : files) {
        std::vector<StudyAndJson> found = parseStudies(render::readJson(file, studyLimits));
        for (StudyAndJson& each : found) {
            // Files of `vitrine study` have no name inside, so the file name is used.
            if (each.study.name.empty() && found.size() == 1) each.study.name = nameOfStudyFile(file);
            studies.push_back(std::move(each.study));
        }
    }
    if (studies.size() < 2 || studies.size() > mostStudies)
        throw Failure(ErrorKind::usage, "compare-studies: give files of two to " + std::to_string(mostStudies) +
                                            " studies; there are " + std::to_string(studies.size()) + '.');
    return studies;
}

std::string costOf(const std::vector<KeptStudy>& studies, const std::string& wanted)
{
    const std::vector<std::string> costs = sharedCosts(studies);
    if (costs.empty())
        throw Failure(
            ErrorKind::check,
            "These studies share no count of work that tells their settings apart" +
                std::string(timesDiffer(studies) == TimesDiffer::no ? "" : ", and their times cannot be compared") +
                "; measure them by the same counter.");
    if (wanted.empty()) return costs.front();
    if (wanted == "work") {
        const auto work =
            std::find_if(costs.begin(), costs.end(), [](const std::string& cost) { return cost != "ms"; });
        if (work == costs.end())
            throw Failure(ErrorKind::check, "--cost work: these studies share no count of work; give ms.");
        return *work;
    }
    if (std::find(costs.begin(), costs.end(), wanted) != costs.end()) return wanted;
    const std::string why = wanted == "ms" ? ui::timesDifferText(timesDiffer(studies)).toStdString() + " Give"
                                           : "these studies do not share it; give";
    throw Failure(wanted == "ms" ? ErrorKind::check : ErrorKind::usage,
                  "--cost " + wanted + ": " + why + " one of " + joined(costs) + '.');
}

/// Returns the comparisons by this cost, and then by time and by the most telling count of work, if they differ from
/// it.
std::vector<StudyComparison> comparisons(const std::vector<KeptStudy>& studies, const std::string& cost)
{
    std::vector<std::string> costs{cost};
    bool hasWork = cost != "ms";
    for (const std::string& each : sharedCosts(studies)) {
        if (each == cost || (each != "ms" && hasWork)) continue;
        hasWork = hasWork || each != "ms";
        costs.push_back(each);
    }
    std::vector<StudyComparison> all;
    for (const std::string& each : costs) all.push_back(compareStudies(studies, labelsOf(studies), each));
    return all;
}

void printDifferences(const StudyComparison& comparison)
{
    using render::shortNumber;
    std::printf("%-28s %-28s %12s %12s %14s %14s\n", "compared with", "setting of the first", "cost", "error",
                "error at cost", "cost at error");
    for (const StudyDifference& d : comparison.differences)
        std::printf("%-28s %-28s %12s %12s %14s %14s%s\n", comparison.curves[d.study].label.c_str(), d.text.c_str(),
                    shortNumber(d.cost).c_str(), shortNumber(d.error).c_str(),
                    d.errorAtCost ? shortNumber(*d.errorAtCost).c_str() : "-",
                    d.costAtError ? shortNumber(*d.costAtError).c_str() : "-", d.uncertain ? " uncertain" : "");
}

/// Returns the document of `--json` (assets/schemas/study-differences.schema.json). null: nothing comparable was
/// measured.
render::Json differencesJson(const StudyComparison& comparison, const std::string& timesDiffer, const std::string& out)
{
    const auto number = [](const std::optional<double>& x) { return x ? render::Json(*x) : render::Json(nullptr); };
    render::Json document = newDocument("vitrine-study-differences");
    document["cost"] = comparison.cost;
    document["baseline"] = comparison.curves.front().label;
    document["differences"] = render::Json::array();
    for (const StudyDifference& d : comparison.differences)
        document["differences"].push_back({{"comparedWith", comparison.curves[d.study].label},
                                           {"setting", d.text},
                                           {"cost", d.cost},
                                           {"error", d.error},
                                           {"errorAtCost", number(d.errorAtCost)},
                                           {"costAtError", number(d.costAtError)},
                                           {"uncertain", d.uncertain}});
    document["leftOut"] = render::Json::array();
    for (const ComparedCurve& curve : comparison.curves)
        if (curve.leftOut) document["leftOut"].push_back(curve.label);
    document["timesDiffer"] = timesDiffer.empty() ? render::Json(nullptr) : render::Json(timesDiffer);
    document["page"] = out + "/index.html";
    return document;
}

int compareStudyFiles(const ComparisonOptions& options)
{
    requireStudyComparisonFolder(options.out);
    const std::vector<KeptStudy> studies = readAll(options.files);
    const std::vector<StudyComparison> all = comparisons(studies, costOf(studies, options.cost));
    const StudyComparison& comparison = all.front();
    writeStudyComparisonFolder(options.out, studies, all);
    const std::string why = ui::timesDifferText(timesDiffer(studies)).toStdString();
    if (options.asJson) {
        std::fputs(render::writeJson(differencesJson(comparison, why, options.out)).c_str(), stdout);
        return 0;
    }
    printDifferences(comparison);
    if (!why.empty()) std::printf("%s\n", why.c_str());
    for (const ComparedCurve& curve : comparison.curves)
        if (curve.leftOut) std::printf("%s was left out: its errors are of another metric.\n", curve.label.c_str());
    std::printf("The comparison is in %s/index.html\n", options.out.c_str());
    return 0;
}

}  // namespace

void addCompareStudiesCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand(
        "compare-studies", "Compare studies on one page: their best settings in one chart, and how they differ");
    auto options = std::make_shared<ComparisonOptions>();
    command->add_option("files", options->files, "Two or more study.json files; the first is the baseline")
        ->required()
        ->expected(1, -1);
    command->add_option("--cost", options->cost,
                        "Cost to compare: ms (time), work (the counter that differs most), or one counter such as "
                        "evaluations. Default: ms if the times are comparable, else work. The page shows both");
    command->add_option("--out", options->out, "Output folder for the page; an older comparison in it is replaced")
        ->required();
    command->add_flag("--json", options->asJson, "Print the differences as JSON");
    command->callback([&chosen, options] { chosen = [options] { return compareStudyFiles(*options); }; });
}

}  // namespace vitrine::app
