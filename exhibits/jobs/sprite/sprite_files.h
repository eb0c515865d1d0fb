#pragma once

#include "exhibits/jobs/kit/job.h"
#include "exhibits/jobs/sprite/sprite_shots.h"
#include "render/files/atomic_write.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine {

/// Returns the views, frames and sizes to draw for these values of `SpriteTable`.
[[nodiscard]] SpriteRequest spriteRequest(const ParameterValues&, const SpriteSubject&);

/// Sentence on why there can be no such sheet; empty: there can.
[[nodiscard]] std::string whyNoSheet(const SpriteRequest&);

/// The object that they name: a file is read. Throws Failure as SpriteSubject does.
[[nodiscard]] std::shared_ptr<const SpriteSubject> spriteSubject(const ParameterValues&);

/// The frames of these values as a sheet of that file name.
[[nodiscard]] SpriteSheet sheetOf(const std::vector<SpriteFrame>&, const ParameterValues&, const SpriteSubject&,
                                  const std::string& imageName);

/// The files of a sheet that is written to `out` ("hero.png": also "hero_normal.png", "hero_depth.png", "hero.json").
[[nodiscard]] std::vector<jobs::PlannedFile> sheetFiles(const ParameterValues&, const std::filesystem::path& out);

/// The preset of the look in which a sheet was drawn (values of `spriteLookName`), for `SpriteSheet::settings`.
[[nodiscard]] std::string lookPreset(const ParameterValues& look);

/// The same files with their content.
[[nodiscard]] std::vector<render::NamedBytes> sheetBytes(const SpriteSheet&, const ParameterValues&,
                                                         const std::filesystem::path& out);

}  // namespace vitrine
