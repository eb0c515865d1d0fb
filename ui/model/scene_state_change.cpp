#include "ui/model/scene_state_change.h"

#include <algorithm>

namespace vitrine::ui {

SceneStateChange::SceneStateChange(const SceneState& before, const SceneState& after)
{
    for (std::size_t e = 0; e < before.values.size(); ++e) {
        const ParameterValues &from = before.values[e], &to = after.values[e];
        if (from.sharedTable() != to.sharedTable() || from.pending() != to.pending() ||
            from.motions() != to.motions() || from.pendingMotions() != to.pendingMotions()) {
            tables_.push_back({e, from, to});
            continue;
        }
        for (std::size_t r = 0; r < from.rows().size(); ++r)
            if (from.row(r) != to.row(r)) rows_.push_back({e, r, from.sharedTable(), from.row(r), to.row(r)});
    }
}

SceneStateChange::SceneStateChange(const SceneState& before, std::size_t exhibit, std::size_t row, const Value& after)
    : rows_{{exhibit, row, before.values[exhibit].sharedTable(), before.values[exhibit].row(row), after}}
{
}

std::optional<std::pair<std::size_t, std::size_t>> SceneStateChange::onlyParameter(const SceneState& sceneState) const
{
    if (rows_.size() != 1 || !tables_.empty()) return std::nullopt;
    const Row& change = rows_.front();
    if (sceneState.values[change.exhibit].sharedTable() != change.table) return std::nullopt;
    return std::pair(change.exhibit, change.row);
}

std::set<std::size_t> SceneStateChange::exhibits() const
{
    std::set<std::size_t> all;
    for (const Row& change : rows_) all.insert(change.exhibit);
    for (const Table& change : tables_) all.insert(change.exhibit);
    return all;
}

void SceneStateChange::set(ParameterValues& values, const Row& change, const Value& value)
{
    if (values.sharedTable() == change.table) {
        values.setParameter(change.row, value);
        return;
    }
    // A file was read again since then: find the parameter by its name.
    const ParameterInfo& info = change.table->rows()[change.row];
    const std::optional<std::size_t> row = values.table().find(info.name);
    if (!row || values.rows()[*row].kind != info.kind) return;
    values.setParameter(*row, value == info.initial ? values.rows()[*row].initial : value);
}

void SceneStateChange::apply(SceneState& sceneState) const
{
    for (const Row& change : rows_) set(sceneState.values[change.exhibit], change, change.after);
    for (const Table& change : tables_) sceneState.values[change.exhibit] = change.after;
}

void SceneStateChange::revert(SceneState& sceneState) const
{
    for (auto change = rows_.rbegin(); change != rows_.rend(); ++change)
        set(sceneState.values[change->exhibit], *change, change->before);
    for (const Table& change : tables_) sceneState.values[change.exhibit] = change.before;
}

void SceneStateChange::append(const SceneStateChange& later)
{
    for (const Row& change : later.rows_) appendParameter(change);
    for (const Table& change : later.tables_) appendTable(change);
    std::erase_if(rows_, [](const Row& change) { return change.before == change.after; });
    std::erase_if(tables_, [](const Table& change) {
        return change.before.sharedTable() == change.after.sharedTable() && change.before == change.after;
    });
}

void SceneStateChange::appendParameter(const Row& later)
{
    for (Table& change : tables_)
        if (change.exhibit == later.exhibit) {
            set(change.after, later, later.after);
            return;
        }
    for (Row& change : rows_)
        if (change.exhibit == later.exhibit && change.row == later.row && change.table == later.table) {
            change.after = later.after;
            return;
        }
    rows_.push_back(later);
}

void SceneStateChange::appendTable(const Table& later)
{
    for (Table& change : tables_)
        if (change.exhibit == later.exhibit) {
            change.after = later.after;
            return;
        }
    Table change = later;
    for (auto row = rows_.rbegin(); row != rows_.rend(); ++row)
        if (row->exhibit == later.exhibit) set(change.before, *row, row->before);
    std::erase_if(rows_, [&](const Row& row) { return row.exhibit == later.exhibit; });
    tables_.push_back(std::move(change));
}

}  // namespace vitrine::ui
