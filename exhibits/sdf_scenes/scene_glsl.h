#pragma once

#include "exhibits/sdf_scenes/scene_program.h"
#include "render/glsl/shader_key.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::scenes {

/// Path under which shaders include a generated field.
inline constexpr const char* generatedField = "sdf_scenes/generated_field.glsl";

/// Member of the uniform block after the scene's numbers, used by the shader around the field.
struct FurtherMember {
    std::string file;         ///< File that declares the type; included before the block.
    std::string declaration;  ///< "SceneStage stage".
};

/// Generates GLSL for one scene, step by step, with only the code that the scene needs:
///
///     float fieldDistance(vec3 p);         // meters, 1-Lipschitz
///     SceneSurface sceneSurface(vec3 p);   // shaders/sdf_scenes/material.glsl
///
/// Its numbers are read from the uniform block at BLOCK_EXHIBIT (`sceneBlock`), so that changing them needs no
/// compilation. Choices, such as the profile of a blend, are part of the text.
[[nodiscard]] std::string sceneGlsl(const SceneProgram&, const FurtherMember& = {});

/// Returns whether the numbers exceed the size of a uniform block. They are then read from the buffer at
/// STORAGE_EXHIBIT_A, and the block contains only the further member.
[[nodiscard]] bool isInBuffer(const SceneProgram&);

/// The same with the numbers marked in `steady` folded, and the others read from the block or buffer of
/// `sceneGlsl`: both programs draw from the same inputs.
[[nodiscard]] std::string restingSceneGlsl(const SceneProgram&, const SceneConstants&, const std::vector<char>& steady,
                                           const FurtherMember& = {});

/// Returns whether the shape or change of a kind is a sum of octaves of noise.
[[nodiscard]] bool isNoise(const NodeKind&);

/// Returns a text in the form that `SdfShaders::generated` takes.
[[nodiscard]] std::shared_ptr<const render::ShaderSources> generatedSources(std::string glsl);

/// Returns the content of the uniform block up to the further member, or of the buffer.
[[nodiscard]] std::vector<std::byte> sceneBlock(const SceneConstants&);

}  // namespace vitrine::scenes
