#pragma once

#include "exhibits/sdf_scenes/scene_program.h"
#include "render/plan/shader_key.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::scenes {

/// Where a generated field is included from.
inline constexpr const char* generatedField = "sdf_scenes/generated_field.glsl";

/// A member that the uniform block has behind the scene's numbers, for the shader around the field.
struct FurtherMember {
    std::string file;         ///< Included before: it declares the type.
    std::string declaration;  ///< "SceneStage stage".
};

/// GLSL of one scene, step by step, with nothing in it that the scene does not contain:
///
///     float fieldDistance(vec3 p);         // meters, 1-Lipschitz
///     SceneSurface sceneSurface(vec3 p);   // shaders/sdf_scenes/material.glsl
///
/// Its numbers come from the uniform block at BLOCK_EXHIBIT (`sceneBlock`), so that changing them compiles nothing.
/// Choices, such as the profile of a blend, are part of the text.
[[nodiscard]] std::string sceneGlsl(const SceneProgram&, const FurtherMember& = {});

/// Whether they are more than a uniform block holds: then they come from the buffer at STORAGE_EXHIBIT_A, and the block
/// has the further member alone.
[[nodiscard]] bool isInBuffer(const SceneProgram&);

/// The same with these numbers folded into the text: the block has the further member, or is not there.
[[nodiscard]] std::string foldedSceneGlsl(const SceneProgram&, const SceneWords&, const FurtherMember& = {});

/// The same with the steady words (`steadyWords`) folded and the others from the block or buffer, which is that of
/// `sceneGlsl`: either program draws from the same inputs.
[[nodiscard]] std::string restingSceneGlsl(const SceneProgram&, const SceneWords&, const std::vector<char>& steady,
                                           const FurtherMember& = {});

/// A text as `SdfShaders::generated` takes it.
[[nodiscard]] std::shared_ptr<const render::ShaderSources> generatedSources(std::string glsl);

/// What the uniform block holds, up to the further member; or the buffer.
[[nodiscard]] std::vector<std::byte> sceneBlock(const SceneWords&);

}  // namespace vitrine::scenes
