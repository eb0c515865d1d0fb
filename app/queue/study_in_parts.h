#pragma once

#include "app/queue/parts.h"
#include "exhibits/study/study_parts.h"

namespace vitrine::app {

/// The measures of a study in OUT.parts.
class StudyInParts final : public StudyParts {
public:
    /// `parts` must outlive it. `isPart`: it is being made; otherwise all were made.
    StudyInParts(Parts& parts, bool isPart) : parts_(parts), isPart_(isPart) {}

    [[nodiscard]] bool isPart() const override { return isPart_; }
    [[nodiscard]] bool makes(std::size_t number) const override { return !isPart_ || parts_.shard().makes(number); }
    void keep(const std::string& key, const StudyMeasure&) override;
    [[nodiscard]] std::optional<StudyMeasure> find(const std::string& key) const override;

private:
    Parts& parts_;
    bool isPart_;
};

}  // namespace vitrine::app
