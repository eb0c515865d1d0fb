#include "ui/presets/preset_uses.h"

#include <QUndoStack>

namespace vitrine::ui {

const StoredPreset* PresetUses::of(const std::string& exhibit) const
{
    for (int i = steps_.index(); i >= 0; --i) {
        const QUndoCommand* step = i > 0 ? steps_.command(i - 1) : nullptr;
        for (auto use = uses_.rbegin(); use != uses_.rend(); ++use)
            if (use->since == step && use->stored.preset.exhibit == exhibit) return &use->stored;
    }
    return nullptr;
}

void PresetUses::add(StoredPreset stored)
{
    const QUndoCommand* last = steps_.index() > 0 ? steps_.command(steps_.index() - 1) : nullptr;
    std::erase_if(
        uses_, [&](const Use& use) { return use.since == last && use.stored.preset.exhibit == stored.preset.exhibit; });
    uses_.push_back({last, std::move(stored)});
}

void PresetUses::forget(const std::filesystem::path& path)
{
    std::erase_if(uses_, [&](const Use& use) { return use.stored.path == path; });
}

void PresetUses::renamed(const std::filesystem::path& before, const StoredPreset& after)
{
    for (Use& use : uses_)
        if (use.stored.path == before) use.stored = after;
}

void PresetUses::prune()
{
    std::erase_if(uses_, [&](const Use& use) {
        for (int i = 0; i < steps_.count(); ++i)
            if (steps_.command(i) == use.since) return false;
        return use.since != nullptr;
    });
}

}  // namespace vitrine::ui
