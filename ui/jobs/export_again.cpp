#include "ui/jobs/export_again.h"

#include "exhibits/jobs.h"
#include "ui/kit/replace_question.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

#include <algorithm>
#include <utility>

namespace vitrine::ui {

ExportAgain::ExportAgain(Workbench& window, SceneSource scene, QObject& parent)
    : QObject(&parent), window_(window), scene_(std::move(scene)),
      runner_(window.renderers(), window.viewport().renderThread(), this)
{
    connect(&runner_, &JobRunner::finished, this, [this](const JobRunner::Run& run) {
        const QString written = QString::fromStdString(run->report().files.front().string());
        window_.say(MessageStrip::Mood::notice, tr("Picture saved to %1.").arg(written),
                    tr("%1 pictures saved, the last one to %2."), written, written);
        goOn();
        emit ended(true);
    });
    connect(&runner_, &JobRunner::failed, this, [this](const QString& why) {
        window_.say(MessageStrip::Mood::problem, why);
        goOn();
        emit ended(false);
    });
}

void ExportAgain::note(const ParameterValues& values, const QString& path)
{
    values_ = values;
    last_ = path;
    emit noted();
}

void ExportAgain::run()
{
    if (!values_) return;
    // The path must also differ from those of exports that wait.
    const auto isPromised = [this](const QString& path) {
        return std::any_of(orders_.begin(), orders_.end(), [&](const jobs::JobOrder& each) {
            return QString::fromStdString(each.out.string()) == path;
        });
    };
    do last_ = nextFreePath(last_);
    while (isPromised(last_));
    const jobs::Job& job = *jobs::findJob("render");
    jobs::JobOrder order{*values_, job.sceneFor(*values_, scene_(job)), job.read(*values_)};
    order.out = last_.toStdString();
    orders_.push_back(std::move(order));
    if (orders_.size() == 1) runner_.start(job, orders_.front());
}

void ExportAgain::goOn()
{
    if (!orders_.empty()) orders_.pop_front();
    if (!orders_.empty()) runner_.start(*jobs::findJob("render"), orders_.front());
}

QStringList ExportAgain::unfinished() const
{
    QStringList files;
    for (const jobs::JobOrder& order : orders_) files << QString::fromStdString(order.out.filename().string());
    return files;
}

void ExportAgain::stop()
{
    orders_.clear();
    runner_.cancel();
}

}  // namespace vitrine::ui

#include "moc_export_again.cpp"
