#pragma once

#include "exhibits/kit/sdf_exhibit.h"
#include "render/files/asset_store.h"
#include "render/glsl/std140.h"

#include <memory>
#include <string_view>

namespace vitrine {

#include "shaders/kit/sdf/object_block.glsl"

/// A field at one time and place, from which its passes are planned.
struct SdfScene {
    std::string_view exhibit;  ///< Passes are "EXHIBIT/march", images "EXHIBIT.cone".
    const SdfParameters& table;
    bool glass;    ///< Whether rays pass through it.
    bool rough;    ///< Whether it is glass that scatters them.
    bool mirrors;  ///< Whether it is a mirror.
    const PlanContext& context;
    const SdfBody& body;
    render::Box box;  ///< Rays are marched inside it.
    std::shared_ptr<const render::ShaderSources> sources;
};

/// Returns a pass "EXHIBIT/STEP" with the body's values, block, buffers, permutations and shaders, without draws.
[[nodiscard]] render::Pass sdfPass(const SdfScene&, const char* step, std::string reason, std::string vertex,
                                   std::string fragment);
/// Returns a draw with the body's place as its block. A null mesh means a triangle over the picture.
[[nodiscard]] render::Draw sdfDraw(const SdfScene&, std::shared_ptr<const render::Mesh>);
/// Returns the define for passes that use shadows of kit/sdf/shade.glsl.
[[nodiscard]] std::string shadowDefine(const SdfScene&);
/// Plans the shadow: rays of the sun are marched, and their hits written, so its outline is exact.
void planSdfShadow(const SdfScene&, render::FramePlan&);
/// Plans march and cone pre-pass, counts, mesh and overlay, or the reasons for skipping them. `mesh` replaces the march
/// if the values say so; otherwise it may be null. If it could not be made, the body is marched.
void planSdf(const SdfScene&, const render::Asset<render::Mesh>* mesh, render::FramePlan&);

}  // namespace vitrine
