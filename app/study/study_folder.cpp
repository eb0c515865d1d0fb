#include "app/study/study_folder.h"

#include "app/kit/part_folder.h"
#include "app/study/offscreen_charts.h"
#include "app/study/study_page.h"
#include "exhibits/study/study_text.h"
#include "render/files/atomic_write.h"
#include "render/image/image_io.h"
#include "render/measure/distance.h"
#include "ui/kit/picture_file.h"
#include "ui/study/study_chart.h"

#include <algorithm>

namespace vitrine::app {
namespace {

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

}  // namespace

CostAxis chartCosts(const StudyResult& result, std::optional<CostAxis> asked)
{
    if (asked) return *asked;
    return result.workName.empty() ? CostAxis::time : usualCostAxis(result.clockTrusted);
}

void requireStudyFolder(const fs::path& folder)
{
    requireFolderFor(folder, "study.json", "a study");
}

void writeStudyFolder(const fs::path& folder, Subjects subjects, const Study& study, const render::Json& machine,
                      const std::string& presetText, CostAxis costs)
{
    requireStudyFolder(folder);
    const StudyRequest& request = study.request();
    const StudyResult& result = study.result();
    PartFolder part(folder);
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

    const render::Json json = studyJson(subjects, request, result, machine);
    render::atomicWrite(part.path() / "study.json", render::writeJson(json));
    render::atomicWrite(part.path() / "study.csv", studyCsv(subjects, request, result));
    render::atomicWrite(part.path() / "chart.svg", svg);
    render::atomicWrite(part.path() / "chart.png", png.toStdString());
    render::atomicWrite(
        part.path() / "index.html",
        studyPage(subjects, request, result, charts, {studyChartSize.width(), studyChartSize.height()}, points));
    if (!presetText.empty()) render::atomicWrite(part.path() / "preset.json", presetText);
    part.publish();
}

}  // namespace vitrine::app
