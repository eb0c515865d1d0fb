#pragma once

#include "exhibits/sdf_scenes/node_kinds.h"

namespace vitrine::scenes {

/// A row of the tables of what a scene has beside its nodes.
struct RecordKind {
    std::string_view name;
    std::string_view help;
    std::vector<Field> fields;
    std::vector<std::string_view> files{};  ///< Keys that name files, all required.
};

/// Which record a table is of, and the key that says its kind; no key where there is one kind.
struct RecordTable {
    std::string_view key;
    std::vector<RecordKind> kinds;
};

/// "model": phong, the source's own, or pbr.
[[nodiscard]] const RecordTable& materialTable();
/// "kind": point, sun or area.
[[nodiscard]] const RecordTable& lightTable();
/// "kind": sky, panorama or faces.
[[nodiscard]] const RecordTable& environmentTable();
[[nodiscard]] const RecordTable& cameraTable();
/// How the scene is lit and reflected.
[[nodiscard]] const RecordTable& lookTable();
/// Of every node: translate, rotate, scale.
[[nodiscard]] const std::vector<Field>& placeFields();

}  // namespace vitrine::scenes
