#pragma once

#include "exhibits/museum/museum.h"

#include <optional>

namespace vitrine::ui {

/// Cache of the prepared scene for queries to the museum: made once for each time and scene state. Waits for no file.
/// While files are still being read, it is prepared again after each `lookAgain`.
class PreparedState {
public:
    /// `museum` must outlive this object.
    explicit PreparedState(const Museum& museum) : museum_(museum) {}

    /// Returns the prepared scene. `number` identifies the scene state; `wanted` gives the time and the camera.
    const Prepared& of(const SceneState&, long long number, FrameRequest wanted);
    /// Missing files may have been read: the next query prepares again.
    void lookAgain() { asked_ = false; }
    [[nodiscard]] long long preparations() const { return preparations_; }

private:
    const Museum& museum_;
    std::optional<Prepared> prepared_;
    glm::dvec3 eye_{0};  ///< Eye position of the preparation: animations may depend on the visitor's distance.
    long long number_ = 0;
    bool asked_ = false;  ///< Prepared since `lookAgain`.
    long long preparations_ = 0;
};

}  // namespace vitrine::ui
