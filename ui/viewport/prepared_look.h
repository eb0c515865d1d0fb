#pragma once

#include "exhibits/museum/museum.h"

#include <optional>

namespace vitrine::ui {

/// What is to be seen, prepared for questions to the museum: once for one moment of one look, however many are asked.
/// It waits for no file; while some are still being read, it is prepared anew after each `lookAgain`.
class PreparedLook {
public:
    /// Must outlive it.
    explicit PreparedLook(const Museum& museum) : museum_(museum) {}

    /// `number` is another one for every other look; `wanted` tells the moment.
    const Prepared& of(const SceneState&, long long number, FrameRequest wanted);
    /// What is missing may be there by now.
    void lookAgain() { asked_ = false; }
    [[nodiscard]] long long preparations() const { return preparations_; }

private:
    const Museum& museum_;
    std::optional<Prepared> prepared_;
    glm::dvec3 eye_{0};  ///< Where it was asked from: rows may move by the visitor's distance.
    long long number_ = 0;
    bool asked_ = false;  ///< Since `lookAgain`.
    long long preparations_ = 0;
};

}  // namespace vitrine::ui
