#include "ui/study/shown_kept_study.h"

#include "exhibits/study/study_costs.h"
#include "ui/study/point_caption.h"
#include "ui/study/study_chart.h"

#include <QCoreApplication>

#include <algorithm>

namespace vitrine::ui {

ShownKeptStudy::ShownKeptStudy(study::KeptStudy study, std::string json, QString title)
    : study_(std::move(study)), json_(std::move(json)), title_(std::move(title))
{
}

bool ShownKeptStudy::isTimed() const
{
    return std::any_of(study_.points.begin(), study_.points.end(),
                       [](const study::KeptPoint& point) { return point.time.has_value(); });
}

bool ShownKeptStudy::setPictures(const study::ContactSheet& sheet)
{
    if (sheet.points != study_.points.size() || sheet.views != study_.views.size()) return false;
    pictures_ = sheet;
    return true;
}

void ShownKeptStudy::findParameters(Subjects subjects, const SceneState& sceneState)
{
    parameters_ = study::parametersOf(study_, subjects, sceneState);
}

QString ShownKeptStudy::whyNotApplied() const
{
    if (!parameters_.missingExhibit.empty())
        return QCoreApplication::translate(
                   "StudyView", "There is no exhibit “%1” here, so its numbers are shown, but cannot be applied.")
            .arg(QString::fromStdString(parameters_.missingExhibit));
    if (!parameters_.missingParameter.empty())
        return QCoreApplication::translate(
                   "StudyView", "There is no parameter “%1” now, so its numbers are shown, but cannot be applied.")
            .arg(QString::fromStdString(parameters_.missingParameter));
    return {};
}

std::optional<std::size_t> ShownKeptStudy::presentPoint(const SceneState& sceneState) const
{
    if (!parameters_.all()) return std::nullopt;
    for (std::size_t i = 0; i < study_.points.size(); ++i) {
        std::string wrong;
        const std::optional<std::vector<Value>> values = study::valuesOf(study_, i, parameters_, sceneState, wrong);
        bool same = values.has_value();
        for (std::size_t r = 0; same && r < values->size(); ++r)
            same = sceneState.values[parameters_.rows[r].subject].row(parameters_.rows[r].row) == (*values)[r];
        if (same) return i;
    }
    return std::nullopt;
}

std::optional<std::string> ShownKeptStudy::apply(std::size_t point, SceneState& sceneState) const
{
    std::string wrong;
    const std::optional<std::vector<Value>> values = study::valuesOf(study_, point, parameters_, sceneState, wrong);
    if (!values) return wrong;
    for (std::size_t i = 0; i < values->size(); ++i)
        sceneState.values[parameters_.rows[i].subject].setParameter(parameters_.rows[i].row, (*values)[i]);
    return std::nullopt;
}

QString ShownKeptStudy::captionOf(std::size_t point) const
{
    const study::KeptPoint& p = study_.points[point];
    const QString setting = settingWords(study_.settingParts(point));
    if (!p.measured()) return QCoreApplication::translate("StudyView", "%1 was not measured.").arg(setting);
    PointNumbers numbers{.error = p.error, .modelError = p.modelError};
    if (p.time) numbers.time = PointNumbers::Time{p.time->median, p.time->interval.low, p.time->interval.high};
    numbers.workName = study::costsAlong(study::CostAxis::work, study_).name;
    if (const auto found = p.counters.find(numbers.workName); found != p.counters.end())
        numbers.work = static_cast<qlonglong>(found->second);
    const QString text = pointCaption(setting, numbers);
    return pictures_.empty() ? QCoreApplication::translate("StudyView", "%1. Its pictures were not kept.").arg(text)
                             : text;
}

}  // namespace vitrine::ui
