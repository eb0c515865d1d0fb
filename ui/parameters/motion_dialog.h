#pragma once

#include "ui/kit/inline_dialog.h"
#include "ui/model/value_ref.h"

#include <string>
#include <vector>

namespace vitrine::ui {

class ParameterRow;
class ValueEditor;

/// Dialog for the animation of one parameter. Changes are applied at once, as one undo step; Cancel restores the state
/// from before. Closes when the animation is ended elsewhere.
class MotionDialog final : public InlineDialog {
    Q_OBJECT

public:
    /// Animates the first of these parameters if it is not animated yet. The others, which are edited together with it,
    /// get the same animation from the first change on. The history must outlive the dialog.
    MotionDialog(History&, std::size_t exhibit, const std::vector<std::size_t>& rows, QWidget* parent);
    ~MotionDialog() override;

    /// Returns the control of an animation parameter ("period"). Null if the animation's kind does not use it, or there
    /// is none.
    [[nodiscard]] ParameterRow* row(std::string_view name) const;

public slots:
    void reject() override;

private:
    class Numbers;
    class End;

    void addEnd(End&, const QString& name);
    void addNumbers();
    /// Returns the present animation in the history. Null if the parameter is not animated or does not exist.
    [[nodiscard]] const Motion* present() const;
    void change(const Motion&);
    void refresh();

    History& history_;
    std::size_t exhibit_;
    std::string name_;                 ///< Name of the parameter: a file may change the table, and with it the index.
    std::vector<std::string> others_;  ///< Names of the parameters that are animated together with it.
    Gesture gesture_ = newGesture();
    SceneState before_;
    std::unique_ptr<Numbers> numbers_;
    std::unique_ptr<End> from_, to_;
    std::vector<ParameterRow*> rows_;
};

/// Returns the initial animation of a parameter: there and back, from its value to the farther end of its comfortable
/// range.
[[nodiscard]] Motion usualMotion(const ParameterInfo&, const Value& now);

}  // namespace vitrine::ui
