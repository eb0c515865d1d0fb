#pragma once

#include "ui/model/value_ref.h"

#include <QObject>

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::ui {

/// Edits of one exhibit's values. Groups of one kind ("coats") can be edited together: a change of one parameter is
/// then made in all of them, in the same undo step.
class GroupEdits final : public QObject, public ValueOwner {
    Q_OBJECT

public:
    /// The history must outlive this object.
    GroupEdits(History&, std::size_t exhibit, QObject* parent);

    [[nodiscard]] const ParameterValues& currentValues() const override
    {
        return history_.sceneState().values[exhibit_];
    }
    void setValue(std::size_t row, const Value&, Gesture, const QString& text) override;
    /// Sets each parameter to its own initial value.
    void reset(std::size_t row, Gesture, const QString& text) override;
    /// Sets or ends the animation of a parameter and sets its base value, also in groups that are edited together.
    void setMotion(std::size_t row, const QString& text, const std::optional<Motion>&, const Value& base);

    [[nodiscard]] bool together(std::string_view array) const { return together_.contains(array); }
    void setTogether(std::string_view array, bool together);
    /// Returns the parameter itself and, while groups are edited together, the same parameter of the other groups.
    [[nodiscard]] std::vector<std::size_t> parametersWith(std::size_t row) const;

    /// One group of an array.
    struct Group {
        std::size_t element = 0;
        std::string heading;
    };
    /// Returns the groups of an array in their order.
    [[nodiscard]] std::vector<Group> groupsOf(std::string_view array) const;
    /// Copies all values and animations of one group to another, as one undo step.
    void copy(std::string_view array, std::size_t from, std::size_t to);
    /// Copies them to all other groups.
    void copyToOthers(std::string_view array, std::size_t from);
    /// Returns whether all parameters of two groups have equal values.
    [[nodiscard]] bool alike(std::string_view array, std::size_t a, std::size_t b) const;

signals:
    /// Emitted when other groups are edited together.
    void changed();

private:
    /// Returns the same parameter of another group, if it has one of that kind.
    [[nodiscard]] std::optional<std::size_t> twinOf(std::size_t row, std::size_t element) const;
    void copyInto(ParameterValues&, std::string_view array, std::size_t from, std::size_t to) const;

    History& history_;
    std::size_t exhibit_;
    std::set<std::string, std::less<>> together_;
};

}  // namespace vitrine::ui
