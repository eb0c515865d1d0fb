#pragma once

#include "app/queue/parts.h"
#include "exhibits/study/study_parts.h"

namespace vitrine::app {

/// Measurements of a study in OUT.parts.
class StudyInParts final : public study::StudyParts {
public:
    /// `parts` must outlive this object. `isPart`: this process makes one part; otherwise all parts are made.
    StudyInParts(Parts& parts, bool isPart) : parts_(parts), isPart_(isPart) {}

    [[nodiscard]] bool isPart() const override { return isPart_; }
    [[nodiscard]] bool makes(std::size_t number) const override { return !isPart_ || parts_.shard().makes(number); }
    void keep(const std::string& key, const study::StudyMeasure&) override;
    [[nodiscard]] std::optional<study::StudyMeasure> find(const std::string& key) const override;

private:
    Parts& parts_;
    bool isPart_;
};

}  // namespace vitrine::app
