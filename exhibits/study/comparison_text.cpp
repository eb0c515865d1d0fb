#include "exhibits/study/csv_field.h"
#include "exhibits/study/study_comparison.h"
#include "render/files/number_text.h"
#include "render/version.h"

#include <cmath>

namespace vitrine::study {
namespace {

using render::Json;

Json optional(const std::optional<double>& x)
{
    return x && std::isfinite(*x) ? Json(*x) : Json(nullptr);
}

Json pointJson(const ComparedCurve::Point& point)
{
    return Json{{"setting", point.text},
                {"cost", point.cost},
                {"costInterval", Json::array({point.costLow, point.costHigh})},
                {"confidence", point.costConfidence},
                {"error", point.error},
                {"errorOverViews", Json::array({point.errorLow, point.errorHigh})},
                {"uncertain", point.uncertain},
                {"front", point.onFront}};
}

}  // namespace

Json comparisonJson(const std::vector<KeptStudy>& studies, const StudyComparison& comparison)
{
    Json curves = Json::array(), differences = Json::array();
    for (std::size_t i = 0; i < comparison.curves.size(); ++i) {
        const ComparedCurve& curve = comparison.curves[i];
        Json points = Json::array();
        for (const ComparedCurve::Point& point : curve.points) points.push_back(pointJson(point));
        curves.push_back(Json{{"name", curve.label},
                              {"exhibit", studies[i].exhibit},
                              {"parameters", studies[i].parameterNames()},
                              {"measured", studies[i].measured},
                              {"renderer", studies[i].renderer},
                              {"size", Json::array({studies[i].size.x, studies[i].size.y})},
                              {"metric", std::string(toString(studies[i].metric))},
                              {"leftOut", curve.leftOut},
                              {"points", points}});
    }
    for (const StudyDifference& each : comparison.differences) {
        Json json{{"study", each.study},
                  {"setting", each.text},
                  {"cost", each.cost},
                  {"error", each.error},
                  {"errorAtCost", optional(each.errorAtCost)},
                  {"costAtError", optional(each.costAtError)},
                  {"uncertain", each.uncertain}};
        if (each.costRatio)
            json["costRatio"] = Json{{"interval", Json::array({each.costRatio->low, each.costRatio->high})},
                                     {"confidence", each.costRatio->confidence}};
        differences.push_back(std::move(json));
    }
    return Json{{"format", "vitrine-study-comparison"},
                {"version", 1},
                {"app", render::programVersion()},
                {"metric", std::string(toString(comparison.metric))},
                {"cost", comparison.cost},
                {"costIsPer", comparison.cost == "ms" ? "picture" : "pixel"},
                {"studies", curves},
                {"differences", differences}};
}

std::string comparisonCsv(const StudyComparison& comparison)
{
    const auto number = [](const std::optional<double>& x) {
        return x && std::isfinite(*x) ? render::shortestNumber(*x) : std::string();
    };
    std::string text =
        "study,setting,cost,cost_low,cost_high,error,error_lowest_view,error_worst_view,front,uncertain\n";
    for (const ComparedCurve& curve : comparison.curves)
        for (const ComparedCurve::Point& p : curve.points) {
            text += csvField(curve.label) + ',' + csvField(p.text);
            for (const double x : {p.cost, p.costLow, p.costHigh, p.error, p.errorLow, p.errorHigh})
                text += ',' + number(x);
            text += std::string(p.onFront ? ",1" : ",0") + (p.uncertain ? ",1" : ",0") + '\n';
        }
    text += "\nfirst,other,setting of the first,cost,error,other's error at this cost,other's cost at this error,"
            "ratio of costs from,to,confidence,uncertain\n";
    for (const StudyDifference& d : comparison.differences) {
        text += csvField(comparison.curves[0].label) + ',' + csvField(comparison.curves[d.study].label) + ',' +
                csvField(d.text);
        for (const std::optional<double>& x :
             {std::optional(d.cost), std::optional(d.error), d.errorAtCost, d.costAtError})
            text += ',' + number(x);
        if (d.costRatio)
            for (const double x : {d.costRatio->low, d.costRatio->high, d.costRatio->confidence})
                text += ',' + number(x);
        else
            text += ",,,";
        text += std::string(d.uncertain ? ",1" : ",0") + '\n';
    }
    return text;
}

}  // namespace vitrine::study
