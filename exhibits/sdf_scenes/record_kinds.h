#pragma once

#include "exhibits/sdf_scenes/node_kinds.h"

namespace vitrine::scenes {

/// Description of a kind of record: what a scene has besides its nodes.
struct RecordKind {
    std::string_view name;
    std::string_view help;
    std::vector<Field> fields;
    std::vector<std::string_view> files{};  ///< Keys of file names, all required.
};

/// Kinds of a record, and the key that selects one; no key if there is only one kind.
struct RecordTable {
    std::string_view key;
    std::vector<RecordKind> kinds;
};

/// "model": phong, that of the reference, or pbr.
[[nodiscard]] const RecordTable& materialTable();
/// "kind": point, sun or area.
[[nodiscard]] const RecordTable& lightTable();
/// "kind": sky, panorama or faces.
[[nodiscard]] const RecordTable& environmentTable();
[[nodiscard]] const RecordTable& cameraTable();
/// Lighting and shading of the scene.
[[nodiscard]] const RecordTable& lookTable();
/// Fields of every node: translate, rotate, scale.
[[nodiscard]] const std::vector<Field>& placeFields();

}  // namespace vitrine::scenes
