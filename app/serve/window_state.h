#pragma once

#include "app/serve/served_state.h"
#include "render/files/descriptor.h"
#include "ui/model/outside_changes.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>

namespace vitrine::ui {
class History;
}

namespace vitrine::app {

/// Scene state of an open window, for a service on another thread. Made and destroyed on the window's thread, where
/// every call is carried out; the service's thread waits for it. After `end`, calls throw RpcFailure.
class WindowState final : public ServedState {
public:
    /// The history must outlive it. `visit` lets the visitor go to a subject, on the window's thread.
    WindowState(ui::History&, std::function<void(std::size_t subject)> visit);
    ~WindowState() override;

    [[nodiscard]] SceneState current() override;
    void change(const SceneState& before, const SceneState& after) override;
    void visit(std::size_t subject, const render::Camera& camera) override;
    [[nodiscard]] int changedDescriptor() const override { return changed_.get(); }
    void takeChanged() override;

    /// Ends all calls that wait, and all later ones. Call on the window's thread.
    void end();

private:
    struct Gate;
    /// Calls a function on the window's thread, and waits. Throws what it throws.
    void call(const std::function<void()>&);

    ui::History& history_;
    ui::OutsideChanges changes_;
    std::function<void(std::size_t)> visit_;
    std::shared_ptr<Gate> gate_;  ///< Shared with the calls that are under way.
    render::Descriptor changed_;
    QTimer soon_;   ///< Limits how often the service is told of changes.
    QObject here_;  ///< Receives calls. Declared last, so that it is destroyed first.
};

}  // namespace vitrine::app
