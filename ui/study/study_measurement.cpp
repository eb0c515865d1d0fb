#include "ui/study/study_measurement.h"

#include "render/failure.h"
#include "render/measure/memory.h"

#include <QElapsedTimer>

namespace vitrine::ui {
namespace study_measurements {
namespace {

constexpr qint64 refreshTime = 200;  ///< Milliseconds between two intermediate results.

}  // namespace
}  // namespace study_measurements

struct StudyMeasurement::Work {
    Renderers& renderers;
    study::StudyRequest request;
    StudyJob job;
    QElapsedTimer shown;
};

StudyMeasurement::StudyMeasurement(Renderers& renderers, RenderThread& thread, QObject* parent)
    : QObject(parent), renderers_(renderers), thread_(thread)
{
}

bool StudyMeasurement::step(Work& work, const RenderThread::Notify& notify, const Take& take)
{
    if (!work.job.study) {
        work.job = work.renderers.makeStudy(work.request);
        work.shown.start();
        if (!work.job.study) throw Failure(ErrorKind::openGl, "Nothing can be measured: there is no graphics context.");
    }
    study::Study& study = *work.job.study;
    study.step();
    const bool done = study.finished();
    if (done || work.shown.elapsed() >= study_measurements::refreshTime) {
        auto progress = std::make_shared<StudyProgress>(StudyProgress{done ? study.takeResult() : study.result(),
                                                                      done ? 1.0 : study.progress(), study.doing(),
                                                                      work.job.machine});
        notify([take, progress = std::move(progress)] { take(progress); });
        work.shown.start();
    }
    if (done) {
        work.job = {};
        render::trimHeap();
    }
    return !done;
}

void StudyMeasurement::start(study::StudyRequest request)
{
    cancel();
    request_ = request;
    isRunning_ = true;
    auto work = std::make_shared<Work>(Work{renderers_, std::move(request), {}, {}});
    const Take take = [this](const std::shared_ptr<StudyProgress>& progress) { emit progressed(progress); };
    task_ = thread_.start([work, take](const RenderThread::Notify& notify) { return step(*work, notify, take); },
                          [this](const QString& failure) {
                              isRunning_ = false;
                              emit ended(failure);
                          });
}

void StudyMeasurement::cancel()
{
    task_.cancel();
    isRunning_ = false;
}

}  // namespace vitrine::ui

#include "moc_study_measurement.cpp"
