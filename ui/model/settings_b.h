#pragma once

#include "ui/model/history.h"

#include <QString>

#include <functional>
#include <optional>
#include <string>

namespace vitrine::ui {

/// Settings B: a second complete set of values beside the window's own, which are A. Views of B listen to `changed`.
/// Copying values between A and B is one undo step; choosing the settings B is none. The camera of B
/// is not used.
class SettingsB final : public QObject {
    Q_OBJECT

public:
    /// The history must outlive this object.
    explicit SettingsB(History&, QObject* parent = nullptr);

    [[nodiscard]] bool isSet() const { return sceneState_.has_value(); }
    /// Returns the settings B. Call only while `isSet()`.
    [[nodiscard]] const SceneState& sceneState() const { return *sceneState_; }
    /// Returns the name of B for people: "Old gold", with " *" if B was edited since.
    [[nodiscard]] QString name() const;

    /// Sets B to these settings, under this name.
    void set(const SceneState&, const QString& name);
    /// Function that makes the settings B from the settings A.
    using Following = std::function<SceneState(const SceneState& a)>;
    /// Makes B follow A: it is recomputed by the function whenever A changes, until B itself is edited.
    void follow(Following, const QString& name);
    [[nodiscard]] bool follows() const { return static_cast<bool>(following_); }
    /// Replaces B by the same settings with files that were read again. Call only while `isSet()`.
    void readAgain(const SceneState&);
    void letGo();

    // Call the following functions only while `isSet()`.
    void swap();
    /// Copies all values of B to A, or all values of A to B.
    void takeAll();
    void giveAll();
    /// Copies one parameter from B to A, or from A to B. Does nothing if either lacks it.
    void take(std::size_t exhibit, const std::string& row);
    void give(std::size_t exhibit, const std::string& row);

signals:
    void changed();

private:
    struct State {
        std::optional<SceneState> sceneState;
        QString name;
        bool edited = false;
        Following following = {};
    };
    /// Adds one undo step that sets A to `a` and B to `b`.
    void record(const QString& text, const SceneState& a, const State& b);
    void show(const State&);
    void catchUp();

    History& history_;
    std::optional<SceneState> sceneState_;
    QString name_;
    bool edited_ = false;
    Following following_;
};

}  // namespace vitrine::ui
