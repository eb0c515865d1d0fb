#pragma once

#include "exhibits/museum/scene_state.h"

#include <cstddef>
#include <utility>

namespace vitrine::app {

/// Scene state that a service reads and changes. Called on the service's thread only.
class ServedState {
public:
    virtual ~ServedState() = default;

    [[nodiscard]] virtual SceneState current() = 0;
    /// Makes the difference between the two states in the present one. Camera and parameters that do not differ stay.
    virtual void change(const SceneState& before, const SceneState& after) = 0;
    /// Lets the visitor go to an exhibit, or to the hall. `camera`: its best view.
    virtual void visit(std::size_t subject, const render::Camera& camera) = 0;
    /// Returns a descriptor to poll, readable once something else than the service changed the state; -1: nothing else
    /// does.
    [[nodiscard]] virtual int changedDescriptor() const { return -1; }
    /// Makes that descriptor unreadable until the next change.
    virtual void takeChanged() {}
};

/// Scene state of a service without a window.
class OwnState final : public ServedState {
public:
    explicit OwnState(SceneState start) : state_(std::move(start)) {}
    [[nodiscard]] SceneState current() override { return state_; }
    void change(const SceneState&, const SceneState& after) override { state_ = after; }
    void visit(std::size_t, const render::Camera& camera) override { state_.camera = camera; }

private:
    SceneState state_;
};

}  // namespace vitrine::app
