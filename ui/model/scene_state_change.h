#pragma once

#include "exhibits/museum/scene_state.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::ui {

/// What turns one look into another, but for the camera. Keeps the rows that differ (looks are large, and an afternoon
/// has thousands of steps), and all values of an exhibit whose table is another one, too, or whose rows move otherwise.
class SceneStateChange {
public:
    SceneStateChange() = default;
    SceneStateChange(const SceneState& before, const SceneState& after);
    /// Of one row; `after` is legal.
    SceneStateChange(const SceneState& before, std::size_t exhibit, std::size_t row, const Value& after);

    [[nodiscard]] bool empty() const { return rows_.empty() && tables_.empty(); }
    /// Exhibit and row of this look, where no other value changes.
    [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> onlyRow(const SceneState&) const;

    void apply(SceneState& sceneState) const;
    void revert(SceneState& sceneState) const;
    /// This, and then a later one. What comes out as it was before is no change any more.
    void append(const SceneStateChange& later);

private:
    struct Row {
        std::size_t exhibit = 0, row = 0;
        std::shared_ptr<const Parameters> table;  ///< In which it is that row.
        Value before, after;
    };
    /// Of an exhibit that has no entry in `rows_`: with all its motions.
    struct Table {
        std::size_t exhibit = 0;
        ParameterValues before, after;
    };
    static void set(ParameterValues&, const Row&, const Value&);
    void appendRow(const Row& later);
    void appendTable(const Table& later);

    std::vector<Row> rows_;
    std::vector<Table> tables_;
};

}  // namespace vitrine::ui
