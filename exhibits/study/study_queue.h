#pragma once

#include "exhibits/study/study_parts.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>

namespace vitrine::study {

/// Queue of a study's measuring jobs. In a study that is measured in parts, each job is numbered: a part makes its
/// share and keeps the measures; the study that judges takes them from the parts, and makes those that are missing.
class StudyQueue {
public:
    /// Makes one step of a measure; returns nothing until it is done.
    using Measuring = std::function<std::optional<StudyMeasure>()>;

    /// The parts must outlive this object. Null: everything is measured here.
    explicit StudyQueue(StudyParts* parts) : parts_(parts) {}

    /// Returns whether this is one part, which judges nothing.
    [[nodiscard]] bool isPart() const { return parts_ && parts_->isPart(); }
    /// Adds a job. `key` names its measure in the parts, `name` names it for people. `take` receives the measure,
    /// except in a part.
    void add(std::string key, std::string name, Measuring, std::function<void(StudyMeasure)> take);
    /// Makes one step of the first job. Call only while the queue is not empty.
    void step();

    [[nodiscard]] bool empty() const { return jobs_.empty(); }
    /// Returns the numbers of jobs that wait, and that are done.
    [[nodiscard]] std::size_t waiting() const { return jobs_.size(); }
    [[nodiscard]] std::size_t done() const { return done_; }
    /// Returns the name of the job of the last step.
    [[nodiscard]] const std::string& doing() const { return doing_; }

private:
    struct Job {
        std::string key, name;
        bool makes = true;  ///< The job is measured or taken here, and not left to another part.
        Measuring measure;
        std::function<void(StudyMeasure)> take;
    };
    /// Makes one step. Returns whether the job is done.
    [[nodiscard]] bool advance(Job&);

    StudyParts* parts_;
    std::size_t added_ = 0;
    std::deque<Job> jobs_;
    std::size_t done_ = 0;
    std::string doing_;
};

}  // namespace vitrine::study
