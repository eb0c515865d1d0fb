#pragma once

#include "ui/model/value_ref.h"

#include <QObject>

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::ui {

/// Edits the values of one exhibit, whose groups of one kind ("coats") can be edited together: then a change to a row
/// changes the same row of all of them, in the same undo step.
class GroupEdits final : public QObject, public ValueHolder {
    Q_OBJECT

public:
    /// The history must outlive it.
    GroupEdits(History&, std::size_t exhibit, QObject* parent);

    [[nodiscard]] const ParameterValues& heldValues() const override { return history_.sceneState().values[exhibit_]; }
    void hold(std::size_t row, const Value&, Gesture, const QString& text) override;
    /// Each row to the initial value of its own.
    void reset(std::size_t row, Gesture, const QString& text) override;
    /// Lets the row move, or not, and gives it this value; the others likewise.
    void setMotion(std::size_t row, const QString& text, const std::optional<Motion>&, const Value& base);

    [[nodiscard]] bool together(std::string_view array) const { return together_.contains(array); }
    void setTogether(std::string_view array, bool together);
    /// The row itself, and the same row of the other groups while they are edited together.
    [[nodiscard]] std::vector<std::size_t> rowsWith(std::size_t row) const;

    /// One group of an array.
    struct Group {
        std::size_t element = 0;
        std::string heading;
    };
    /// Those of an array, in their order.
    [[nodiscard]] std::vector<Group> groupsOf(std::string_view array) const;
    /// The rows of one group become as those of another, with their motions; one undo step.
    void copy(std::string_view array, std::size_t from, std::size_t to);
    /// The same to all others.
    void copyToOthers(std::string_view array, std::size_t from);
    /// Whether each row of one group is as that of the other.
    [[nodiscard]] bool alike(std::string_view array, std::size_t a, std::size_t b) const;

signals:
    /// What is edited together.
    void changed();

private:
    /// The same row of another group; nothing: it has none of that kind.
    [[nodiscard]] std::optional<std::size_t> twinOf(std::size_t row, std::size_t element) const;
    void copyInto(ParameterValues&, std::string_view array, std::size_t from, std::size_t to) const;

    History& history_;
    std::size_t exhibit_;
    std::set<std::string, std::less<>> together_;
};

}  // namespace vitrine::ui
