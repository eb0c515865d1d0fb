#pragma once

#include "ui/model/history.h"

#include <QElapsedTimer>

#include <set>
#include <string>
#include <utility>

namespace vitrine::ui {

/// Changes of the window's scene state by something that has a copy of it, such as a service.
class OutsideChanges {
public:
    /// Milliseconds within which further changes of the same parameters are one undo step with the last.
    static constexpr int sameStep = 1000;

    /// The history must outlive it.
    explicit OutsideChanges(History& history) : history_(history) {}

    /// Makes the difference between two states in the window's state, as one undo step. The camera and parameters that
    /// do not differ keep their present values.
    void make(const SceneState& before, const SceneState& after);

private:
    using Places = std::set<std::pair<std::size_t, std::string>>;
    [[nodiscard]] static Places differing(const SceneState& before, const SceneState& after);

    History& history_;
    Gesture gesture_ = 0;
    Places last_;  ///< Exhibits and parameters of the last change; an empty name stands for all of an exhibit.
    QElapsedTimer since_;
};

}  // namespace vitrine::ui
