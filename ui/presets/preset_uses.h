#pragma once

#include "exhibits/framework/preset_store.h"

#include <filesystem>
#include <string>
#include <vector>

class QUndoCommand;
class QUndoStack;

namespace vitrine::ui {

/// Which preset each exhibit was loaded from or saved to, from which step of the history on: undo brings back the one
/// before.
class PresetUses {
public:
    /// The steps must outlive it.
    explicit PresetUses(const QUndoStack& steps) : steps_(steps) {}

    /// Null where none was loaded or saved up to the present step.
    [[nodiscard]] const StoredPreset* of(const std::string& exhibit) const;
    /// From the present step on.
    void add(StoredPreset);
    void forget(const std::filesystem::path&);
    /// The file has another name, and may hold another one.
    void renamed(const std::filesystem::path& before, const StoredPreset& after);
    /// Drops what belongs to steps that are no longer in the history. Call whenever the history's index changes.
    void prune();

private:
    struct Use {
        const QUndoCommand* since = nullptr;  // Null: from the start.
        StoredPreset stored;
    };
    const QUndoStack& steps_;
    std::vector<Use> uses_;  // The last one last.
};

}  // namespace vitrine::ui
