#include "ui/print/print_planner.h"

#include "render/failure.h"

namespace vitrine::ui {

PrintPlanner::PrintPlanner(QObject* parent) : QObject(parent), preview_(this), count_(this)
{
    for (NewestJob* job : {&preview_, &count_}) connect(job, &NewestJob::failed, this, &PrintPlanner::failed);
}

void PrintPlanner::refresh(const Request& request)
{
    preview(request);
    count(request);
}

void PrintPlanner::preview(const Request& request)
{
    preview_.ask([this, values = request.values, views = request.views, chart = request.chart]() -> NewestJob::Outcome {
        std::shared_ptr<const printing::PrintPreview> made;
        try {
            if (chart || views) made = printing::printPreview(values, views);
        } catch (const Failure&) {  // The plan gives the reason.
        }
        return [this, made, distance = printing::viewingDistance(values)] { emit previewed(made, distance); };
    });
}

void PrintPlanner::count(const Request& request)
{
    const int turn = ++asked_;
    count_.ask(
        [this, turn, file = request.file, values = request.values, views = request.counted]() -> NewestJob::Outcome {
            return [this, turn, plan = printing::printPlan(values, views.get(), file)] {
                plan_ = plan;
                shown_ = turn;
                emit planned();
            };
        });
}

}  // namespace vitrine::ui

#include "moc_print_planner.cpp"
