#pragma once

#include "ui/model/history.h"

#include <QString>

#include <functional>
#include <optional>
#include <string>

namespace vitrine::ui {

/// B: a second complete setting, beside those on show, which are A. Whoever shows B listens to `changed`. What moves
/// values between the two is one undo step; which settings are held as B is none. B has no camera of its own.
class OtherSettings final : public QObject {
    Q_OBJECT

public:
    /// The history must outlive it.
    explicit OtherSettings(History&, QObject* parent = nullptr);

    [[nodiscard]] bool held() const { return sceneState_.has_value(); }
    /// Only while held.
    [[nodiscard]] const SceneState& sceneState() const { return *sceneState_; }
    /// What B is, for people: "Old gold"; with " *" where it was changed since.
    [[nodiscard]] QString name() const;

    void hold(const SceneState&, const QString& name);
    /// What B makes of A.
    using Following = std::function<SceneState(const SceneState& a)>;
    /// B goes on being that of whatever A is, until it is edited itself.
    void follow(Following, const QString& name);
    [[nodiscard]] bool follows() const { return static_cast<bool>(following_); }
    /// The same settings, of files that are others now. Only while held.
    void readAgain(const SceneState&);
    void letGo();

    // Only while held:
    void swap();
    /// A becomes B, or B becomes A.
    void takeAll();
    void giveAll();
    /// The same of one row; nothing where one of them lacks it.
    void take(std::size_t exhibit, const std::string& row);
    void give(std::size_t exhibit, const std::string& row);

signals:
    void changed();

private:
    struct Held {
        std::optional<SceneState> sceneState;
        QString name;
        bool edited = false;
        Following following = {};
    };
    /// One step: A shows `a`, and B is `b`.
    void record(const QString& text, const SceneState& a, const Held& b);
    void show(const Held&);
    void catchUp();

    History& history_;
    std::optional<SceneState> sceneState_;
    QString name_;
    bool edited_ = false;
    Following following_;
};

}  // namespace vitrine::ui
