#pragma once

#include "exhibits/jobs/kit/job.h"
#include "exhibits/jobs/sprite/sprite_shots.h"
#include "render/files/atomic_write.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::jobs {

/// Returns the views, frames and sizes to draw for these values of `SpriteTable`.
[[nodiscard]] SpriteRequest spriteRequest(const ParameterValues&, const SpriteSubject&);

/// Returns a sentence that says why such a sheet is impossible; empty if it is possible.
[[nodiscard]] std::string whyNoSheet(const SpriteRequest&);

/// Returns the object that the values name; reads its file. Throws Failure like SpriteSubject.
[[nodiscard]] std::shared_ptr<const SpriteSubject> spriteSubject(const ParameterValues&);

/// Returns how a sheet of these values and that file name is made. `palette`: the colors of `paletteFile`.
[[nodiscard]] SpriteSheetOptions sheetOptions(const ParameterValues&, const SpriteSubject&,
                                              const std::vector<Rgb8>& palette, const std::string& imageName);

/// Returns the files of a sheet that is written to `out` ("hero.png": also "hero_normal.png", "hero_depth.png",
/// "hero.json"), without the animated picture.
[[nodiscard]] std::vector<jobs::PlannedFile> sheetFiles(const ParameterValues&, const std::filesystem::path& out);

/// Returns the file of the animated picture; empty if none is written.
[[nodiscard]] std::filesystem::path animationFile(const ParameterValues&, const std::filesystem::path& out);

/// Returns the preset with the settings of `spriteLookName` with which a sheet was drawn, for `SpriteSheet::settings`.
[[nodiscard]] std::string lookPreset(const ParameterValues& look);

/// Returns the same files with their content.
[[nodiscard]] std::vector<render::NamedBytes> sheetBytes(const SpriteSheet&, const ParameterValues&,
                                                         const std::filesystem::path& out);

}  // namespace vitrine::jobs
