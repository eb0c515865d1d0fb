#pragma once

#include "exhibits/sprites/sprite_shots.h"
#include "render/files/file_ops.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine {

/// What these values (of `SpriteTable`) ask to draw.
[[nodiscard]] SpriteRequest spriteRequest(const ParameterValues&, const std::string& animation);

/// The object that they name: a file is read. Throws Failure as SpriteSubject does.
[[nodiscard]] std::shared_ptr<const SpriteSubject> spriteSubject(const ParameterValues&);

/// The frames of these values as a sheet of that file name.
[[nodiscard]] SpriteSheet sheetOf(const std::vector<SpriteFrame>&, const ParameterValues&, const std::string& animation,
                                  const SpriteSubject&, const std::string& imageName);

/// The files of a sheet that is written to `out` ("hero.png": also "hero_normal.png", "hero_depth.png", "hero.json").
[[nodiscard]] std::vector<std::filesystem::path> sheetFiles(const ParameterValues&, const std::filesystem::path& out);

/// The preset of the look in which a sheet was drawn (values of `spriteLookName`), for `SpriteSheet::settings`.
[[nodiscard]] std::string lookPreset(const ParameterValues& look);

/// Writes them all, or leaves all as they were. Throws Failure naming file and cause.
void writeSheet(const SpriteSheet&, const ParameterValues&, const std::filesystem::path& out,
                render::FileOps& = render::systemFileOps());

}  // namespace vitrine
