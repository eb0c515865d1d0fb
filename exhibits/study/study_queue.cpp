#include "exhibits/study/study_queue.h"

#include <utility>

namespace vitrine::study {

void StudyQueue::add(std::string key, std::string name, Measuring measure, std::function<void(StudyMeasure)> take)
{
    const bool makes = !parts_ || parts_->makes(added_);
    ++added_;
    jobs_.push_back({std::move(key), std::move(name), makes, std::move(measure), std::move(take)});
}

void StudyQueue::step()
{
    doing_ = jobs_.front().name;
    if (!advance(jobs_.front())) return;
    jobs_.pop_front();
    ++done_;
}

bool StudyQueue::advance(Job& job)
{
    if (!job.makes) return true;
    std::optional<StudyMeasure> found;
    if (parts_ && !isPart()) found = parts_->find(job.key);
    if (!found) found = job.measure();
    if (!found) return false;
    if (isPart())
        parts_->keep(job.key, *found);
    else
        job.take(std::move(*found));
    return true;
}

}  // namespace vitrine::study
