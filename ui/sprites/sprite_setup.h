#pragma once

#include "exhibits/sprites/sprite_table.h"
#include "ui/model/history.h"

#include <QObject>

#include <string>

namespace vitrine::ui {

/// What is set in the dialog for sprites, with undo; it comes back the next time.
class SpriteSetup final : public QObject {
    Q_OBJECT

public:
    explicit SpriteSetup(QObject* parent);

    [[nodiscard]] const ParameterValues& values() const { return history_.sceneState().values[0]; }
    /// By name; empty: the file's first one.
    [[nodiscard]] const std::string& animation() const { return animation_; }
    /// No step of its own.
    void setAnimation(const std::string&);
    /// `text` names the step for people.
    void change(const QString& text, const ParameterValues&);
    /// The values, for a panel.
    [[nodiscard]] History& history() { return history_; }

    /// Brings back what `remember` wrote, with nothing to undo. What is no value any more is left out.
    void recall();
    void remember() const;

signals:
    void changed();

private:
    History history_{SceneState{{spriteTable().initial()}, {}}};
    std::string animation_;
};

}  // namespace vitrine::ui
