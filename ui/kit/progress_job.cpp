#include "ui/kit/progress_job.h"

#include "ui/kit/message_of.h"
#include "ui/kit/time_left.h"

#include <exception>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr qint64 tellEvery = 50;  // Milliseconds between progress reports.

}  // namespace

ProgressJob::ProgressJob(QObject* parent) : QObject(parent)
{
    pool_.setMaxThreadCount(1);
}

ProgressJob::~ProgressJob()
{
    if (stopping_) *stopping_ = true;
    pool_.waitForDone();
}

void ProgressJob::start(Work work)
{
    if (!running_) {
        run(std::move(work));
        return;
    }
    *stopping_ = true;
    ++turn_;
    next_ = std::move(work);
}

void ProgressJob::stop()
{
    next_ = {};
    if (running_) *stopping_ = true;
}

void ProgressJob::run(Work work)
{
    running_ = true;
    elapsed_.start();
    stopping_ = std::make_shared<std::atomic<bool>>(false);
    pool_.start([this, turn = turn_, stopping = stopping_, work = std::move(work)] {
        Outcome outcome;
        QString why;
        bool stopped = false;
        QElapsedTimer told;
        try {
            outcome = work([&](double part) {
                if (!told.isValid() || told.elapsed() >= tellEvery) {
                    told.start();
                    QMetaObject::invokeMethod(
                        this,
                        [this, turn, part] {
                            if (turn == turn_) emit progressed(part, secondsLeft(part, elapsed_));
                        },
                        Qt::QueuedConnection);
                }
                return !stopping->load();
            });
        } catch (const std::exception& failure) {
            stopped = stopping->load();  // An exception after a stop is expected and not reported.
            if (!stopped) why = messageOf(failure);
        }
        QMetaObject::invokeMethod(
            this, [this, turn, outcome, why, stopped] { end(turn, outcome, why, stopped); }, Qt::QueuedConnection);
    });
}

void ProgressJob::end(int turn, const Outcome& outcome, const QString& why, bool stopped)
{
    running_ = false;
    if (next_) run(std::exchange(next_, {}));
    if (turn != turn_) return;
    if (stopped)
        emit this->stopped();
    else if (!why.isEmpty())
        emit failed(why);
    else if (outcome)
        outcome();
}

}  // namespace vitrine::ui

#include "moc_progress_job.cpp"
