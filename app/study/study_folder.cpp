#include "app/study/study_folder.h"

#include "app/kit/say.h"
#include "app/study/offscreen_charts.h"
#include "app/study/study_page.h"
#include "exhibits/jobs/kit/part_folder.h"
#include "exhibits/jobs/study/study_job.h"
#include "exhibits/study/study_situation.h"
#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/image/image_io.h"
#include "render/measure/distance.h"
#include "ui/kit/picture_file.h"
#include "ui/study/study_chart.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace vitrine::app {
namespace {

using study::choiceSentence;
using study::CostAxis;
using study::costsAlong;
using study::costTitle;
using study::lawSentence;
using study::pointText;
using study::settingParts;
using study::settingText;
using study::situationSentences;
using study::Study;
using study::StudyCosts;
using study::studyCsv;
using study::StudyPoint;
using study::StudyRequest;
using study::StudyResult;

namespace fs = std::filesystem;

render::Image colorOf(const render::Image& picture)
{
    render::Image color(picture.width, picture.height, 3);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c) color.at(x, y, c) = picture.at(x, y, c);
    return color;
}

/// Returns whether a point is shown: all points for one or two parameters, only those worth choosing for a search.
bool isShown(const StudyRequest& request, const StudyResult& result, std::size_t point)
{
    if (request.axes.size() <= 2) return true;
    return result.present == point || (result.choice && result.choice->point == point) ||
           std::find(result.front.begin(), result.front.end(), point) != result.front.end();
}

std::vector<StudyPagePoint> writePictures(const fs::path& folder, Subjects subjects, const Study& study)
{
    const StudyResult& result = study.result();
    for (std::size_t v = 0; v < result.references.size(); ++v)
        render::writePicture(folder / ("reference-" + std::to_string(v + 1) + ".png"), colorOf(result.references[v]),
                             render::PictureFormat::png8);
    // All heat maps of a view have the same scale, so that they can be compared.
    std::vector<StudyPagePoint> points;
    for (std::size_t v = 0; v < result.references.size(); ++v) {
        std::map<std::size_t, render::Image> maps;
        double full = 0;
        for (std::size_t i = 0; i < result.points.size(); ++i) {
            if (!isShown(study.request(), result, i)) continue;
            const std::optional<render::Image> errors =
                render::errorMap(study.request().metric, result.references[v], result.points[i].shots[v].picture,
                                 study.request().pixelsPerDegree);
            maps[i] = errors ? *errors : render::differenceMap(result.references[v], result.points[i].shots[v].picture);
            if (result.points[i].shots[v].errors.at(render::Metric::rmse) > 0)
                full = std::max(full, render::fullScale(study.request().metric, maps[i]));
        }
        for (const auto& [i, map] : maps) {
            const std::string name = "point-" + std::to_string(i + 1) + "-view-" + std::to_string(v + 1);
            render::writePicture(folder / (name + ".png"), colorOf(result.points[i].shots[v].picture),
                                 render::PictureFormat::png8);
            render::writePicture(folder / (name + "-heat.png"), render::heatMap(map, full > 0 ? full : 1),
                                 render::PictureFormat::png8);
        }
    }
    for (std::size_t i = 0; i < result.points.size(); ++i)
        points.push_back({settingText(settingParts(subjects, study.request(), result.points[i])),
                          isShown(study.request(), result, i)});
    return points;
}

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

const jobs::StudyRun& studyRun(const jobs::JobRun& run)
{
    return static_cast<const jobs::StudyRun&>(run);
}

}  // namespace

void requireStudyFolder(const fs::path& folder)
{
    jobs::requireFolderFor(folder, "study.json", "a study");
}

void writeStudyFolder(const fs::path& folder, const jobs::JobRun& run)
{
    requireStudyFolder(folder);
    const Study& study = studyRun(run).study();
    const Subjects subjects = studyRun(run).subjects();
    const CostAxis costs = studyRun(run).costs();
    const StudyRequest& request = study.request();
    const StudyResult& result = study.result();
    jobs::PartFolder part(folder);
    std::vector<StudyPagePoint> points = writePictures(part.path() / "pictures", subjects, study);

    prepareOffscreenCharts();
    std::vector<StudyPageChart> charts;
    QByteArray png;
    std::string svg;
    for (const CostAxis axis : {CostAxis::time, CostAxis::work}) {
        const std::string name = costsAlong(axis, request, result).name;
        if (axis != costs && name.empty()) continue;  // The chart would have no points.
        ui::StudyChart chart;
        chart.showStudy(ui::charted(subjects, request, result, axis));
        const std::string words = axis == CostAxis::time ? "milliseconds" : "counted work: " + costTitle(name);
        StudyPageChart made{axis, chart.svg(studyChartSize).toStdString(), {}, {name, words, axis == costs}};
        for (std::size_t i = 0; i < points.size(); ++i) {
            const QPointF at = chart.placeOf(i);
            const bool shown = chart.points()[i].cost > 0;
            made.places.push_back(shown ? std::optional(glm::dvec2(at.x(), at.y())) : std::nullopt);
        }
        if (made.cost.shown) {
            svg = made.svg;
            png = ui::pngOf(chart.picture(studyChartSize, studyChartScale));
            requireChart(png, folder);
        }
        charts.push_back(std::move(made));
    }

    render::atomicWrite(part.path() / "study.json", render::writeJson(run.answer()));
    render::atomicWrite(part.path() / "study.csv", studyCsv(subjects, request, result));
    render::atomicWrite(part.path() / "chart.svg", svg);
    render::atomicWrite(part.path() / "chart.png", png.toStdString());
    render::atomicWrite(
        part.path() / "index.html",
        studyPage(subjects, request, result, charts, {studyChartSize.width(), studyChartSize.height()}, points));
    const std::string preset = studyRun(run).chosenPreset();
    if (!preset.empty()) render::atomicWrite(part.path() / "preset.json", preset);
    part.publish();
}

int tellStudy(const fs::path& folder, const jobs::JobRun& run, bool quietly)
{
    const Study& study = studyRun(run).study();
    const StudyRequest& request = study.request();
    const Subjects subjects = studyRun(run).subjects();
    if (!quietly) {
        printTable(subjects, request, study.result(), studyRun(run).costs());
        std::printf("The study is in %s/index.html\n", folder.c_str());
    }
    if (!request.maxError && !request.maxMilliseconds) return 0;
    if (!studyRun(run).chosenPreset().empty()) {
        if (!quietly) std::printf("The preset is %s/preset.json\n", folder.c_str());
        return 0;
    }
    say(choiceSentence(subjects, request, study.result()) +
        " Nothing was chosen; allow more, or study other parameters.");
    return static_cast<int>(ErrorKind::check);
}

}  // namespace vitrine::app
