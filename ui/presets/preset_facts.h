#pragma once

#include "exhibits/framework/files/preset_store.h"
#include "ui/presets/preset_preview.h"

namespace vitrine::ui {

/// Returns the content of the large preview of an exhibit's preset. If the file cannot be read, it says why.
[[nodiscard]] PresetFacts presetFacts(const PresetStore&, const std::filesystem::path&, const std::string& exhibit,
                                      const Parameters&);

}  // namespace vitrine::ui
