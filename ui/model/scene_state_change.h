#pragma once

#include "exhibits/museum/scene_state.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace vitrine::ui {

/// Difference between two scene states, without their cameras. Holds only the parameters that differ, because states
/// are large and a session has thousands of steps. An exhibit with another parameter table or other animations is held
/// with all its values.
class SceneStateChange {
public:
    SceneStateChange() = default;
    SceneStateChange(const SceneState& before, const SceneState& after);
    /// Change of one parameter to `after`, which must be legal.
    SceneStateChange(const SceneState& before, std::size_t exhibit, std::size_t row, const Value& after);

    [[nodiscard]] bool empty() const { return rows_.empty() && tables_.empty(); }
    /// Returns the exhibit and parameter index in this state, if exactly one value changes.
    [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> onlyParameter(const SceneState&) const;

    /// Returns the indices of the exhibits whose values change.
    [[nodiscard]] std::set<std::size_t> exhibits() const;

    void apply(SceneState& sceneState) const;
    void revert(SceneState& sceneState) const;
    /// Appends a later change. Values that end as they began are dropped.
    void append(const SceneStateChange& later);

private:
    struct Row {
        std::size_t exhibit = 0, row = 0;
        std::shared_ptr<const Parameters> table;  ///< Table in which `row` is the parameter's index.
        Value before, after;
    };
    /// All values and animations of one exhibit, which then has no entries in `rows_`.
    struct Table {
        std::size_t exhibit = 0;
        ParameterValues before, after;
    };
    static void set(ParameterValues&, const Row&, const Value&);
    void appendParameter(const Row& later);
    void appendTable(const Table& later);

    std::vector<Row> rows_;
    std::vector<Table> tables_;
};

}  // namespace vitrine::ui
