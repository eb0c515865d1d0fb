#pragma once

#include "ui/model/history.h"

namespace vitrine::ui {

/// One value of the look on show, as a control reads and sets it. The history must outlive it.
class ValueRef {
public:
    ValueRef(History& history, std::size_t exhibit, std::size_t row) : history_(&history), exhibit_(exhibit), row_(row)
    {
    }

    [[nodiscard]] const ParameterInfo& info() const { return values().rows()[row_]; }
    [[nodiscard]] const Value& value() const { return values().row(row_); }
    /// As `History::set`.
    void set(const Value& value, Gesture gesture, const QString& text = {}) const
    {
        history_->set(exhibit_, row_, value, gesture, text);
    }

private:
    [[nodiscard]] const ParameterValues& values() const { return history_->sceneState().values[exhibit_]; }

    History* history_;
    std::size_t exhibit_, row_;
};

}  // namespace vitrine::ui
