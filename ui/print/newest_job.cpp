#include "ui/print/newest_job.h"

#include "ui/kit/message_of.h"

#include <exception>
#include <utility>

namespace vitrine::ui {

NewestJob::NewestJob(QObject* parent) : QObject(parent)
{
    pool_.setMaxThreadCount(1);
}

NewestJob::~NewestJob()
{
    pool_.waitForDone();
}

void NewestJob::ask(std::function<Outcome()> work)
{
    if (running_)
        next_ = std::move(work);
    else
        start(std::move(work));
}

void NewestJob::forget()
{
    next_ = {};
    ++turn_;
}

void NewestJob::start(std::function<Outcome()> work)
{
    running_ = true;
    pool_.start([this, turn = turn_, work = std::move(work)] {
        Outcome outcome;
        QString why;
        try {
            outcome = work();
        } catch (const std::exception& failure) {
            why = messageOf(failure);
        }
        QMetaObject::invokeMethod(
            this, [this, turn, outcome, why] { take(turn, outcome, why); }, Qt::QueuedConnection);
    });
}

void NewestJob::take(int turn, const Outcome& outcome, const QString& why)
{
    running_ = false;
    if (next_) start(std::exchange(next_, {}));
    if (turn != turn_) return;
    if (!why.isEmpty())
        emit failed(why);
    else if (outcome)
        outcome();
}

}  // namespace vitrine::ui

#include "moc_newest_job.cpp"
