#pragma once

#include "exhibits/framework/files/preset_store.h"

#include <filesystem>
#include <string>
#include <vector>

class QUndoCommand;
class QUndoStack;

namespace vitrine::ui {

/// For each exhibit, the preset that was loaded or saved last, with the history step of that. Undo brings back the
/// preset from before.
class PresetUses {
public:
    /// The stack must outlive this object.
    explicit PresetUses(const QUndoStack& steps) : steps_(steps) {}

    /// Returns the exhibit's preset at the present step; null if none was loaded or saved before.
    [[nodiscard]] const StoredPreset* of(const std::string& exhibit) const;
    /// Sets the preset that is in use from the present step on.
    void add(StoredPreset);
    void forget(const std::filesystem::path&);
    /// Updates uses of a file that was renamed, or whose content changed.
    void renamed(const std::filesystem::path& before, const StoredPreset& after);
    /// Removes uses that belong to steps no longer in the history. Call whenever the history's index changes.
    void prune();

private:
    struct Use {
        const QUndoCommand* since = nullptr;  // Null: since the start.
        StoredPreset stored;
    };
    const QUndoStack& steps_;
    std::vector<Use> uses_;  // Oldest first.
};

}  // namespace vitrine::ui
