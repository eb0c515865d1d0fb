#pragma once

#include "ui/model/history.h"

namespace vitrine::ui {

/// Owner of parameter values that are kept outside of the history. It records their changes as undo steps itself.
class ValueOwner {
public:
    virtual ~ValueOwner() = default;
    [[nodiscard]] virtual const ParameterValues& currentValues() const = 0;
    /// Sets one value, with the arguments of `History::set`.
    virtual void setValue(std::size_t row, const Value&, Gesture, const QString& text) = 0;
    /// Sets the value back to its initial value.
    virtual void reset(std::size_t row, Gesture gesture, const QString& text)
    {
        setValue(row, currentValues().rows()[row].initial, gesture, text);
    }
};

/// Reference to one parameter value, through which a control reads and sets it. The history or the owner must outlive
/// it.
class ValueRef {
public:
    ValueRef(History& history, std::size_t exhibit, std::size_t row) : history_(&history), exhibit_(exhibit), row_(row)
    {
    }
    ValueRef(ValueOwner& owner, std::size_t row) : owner_(&owner), row_(row) {}

    [[nodiscard]] const ParameterInfo& info() const { return values().rows()[row_]; }
    [[nodiscard]] const Value& value() const { return values().row(row_); }
    /// Sets the value, with the arguments of `History::set`.
    void set(const Value& value, Gesture gesture, const QString& text = {}) const
    {
        if (owner_)
            owner_->setValue(row_, value, gesture, text);
        else
            history_->set(exhibit_, row_, value, gesture, text);
    }
    /// Sets the value back to its initial value.
    void reset(Gesture gesture, const QString& text) const
    {
        if (owner_)
            owner_->reset(row_, gesture, text);
        else
            history_->set(exhibit_, row_, info().initial, gesture, text);
    }

private:
    [[nodiscard]] const ParameterValues& values() const
    {
        return owner_ ? owner_->currentValues() : history_->sceneState().values[exhibit_];
    }

    History* history_ = nullptr;
    ValueOwner* owner_ = nullptr;
    std::size_t exhibit_ = 0, row_ = 0;
};

}  // namespace vitrine::ui
