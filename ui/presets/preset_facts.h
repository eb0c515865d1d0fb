#pragma once

#include "exhibits/framework/preset_store.h"
#include "ui/presets/preset_preview.h"

namespace vitrine::ui {

/// What the large preview of this preset of this exhibit says; of one that cannot be read, why.
[[nodiscard]] PresetFacts presetFacts(const PresetStore&, const std::filesystem::path&, const std::string& exhibit,
                                      const Parameters&);

}  // namespace vitrine::ui
