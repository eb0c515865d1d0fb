#pragma once

#include "ui/kit/quiet_dialog.h"
#include "ui/model/value_ref.h"

#include <string>
#include <vector>

namespace vitrine::ui {

class ParameterRow;
class ValueEditor;

/// How one row moves. What is changed is on show at once, all of it one undo step; Cancel brings back what was before.
/// Closes when the row stops elsewhere.
class MotionDialog final : public QuietDialog {
    Q_OBJECT

public:
    /// Lets the first of these rows move where it stood still; the others, which are edited together with it, move as
    /// it does from the first change on. The history must outlive it.
    MotionDialog(History&, std::size_t exhibit, const std::vector<std::size_t>& rows, QWidget* parent);
    ~MotionDialog() override;

    /// What a motion has by this name ("period"); null where its kind does not go by it, or it is none.
    [[nodiscard]] ParameterRow* row(std::string_view name) const;

public slots:
    void reject() override;

private:
    class Numbers;
    class End;

    void addEnd(End&, const QString& name);
    void addNumbers();
    /// The row's motion in the history; null: it does not move, or is not there.
    [[nodiscard]] const Motion* present() const;
    void change(const Motion&);
    void refresh();

    History& history_;
    std::size_t exhibit_;
    std::string name_;                 ///< Of the row: a file may give the table others meanwhile.
    std::vector<std::string> others_;  ///< That move with it.
    Gesture gesture_ = newGesture();
    SceneState before_;
    std::unique_ptr<Numbers> numbers_;
    std::unique_ptr<End> from_, to_;
    std::vector<ParameterRow*> rows_;
};

/// Where a row begins to move: there and back, from its value to the end of its comfortable range that is farther away.
[[nodiscard]] Motion usualMotion(const ParameterInfo&, const Value& now);

}  // namespace vitrine::ui
