#pragma once

#include "exhibits/kit/sdf_exhibit.h"
#include "render/files/asset_store.h"
#include "render/glsl/std140.h"

#include <memory>
#include <string_view>

namespace vitrine {

#include "shaders/kit/sdf/object_block.glsl"

/// A field at one moment, at its place: what its passes are planned from.
struct SdfScene {
    std::string_view exhibit;  ///< Passes are "EXHIBIT/march", images "EXHIBIT.cone".
    const SdfRows& table;
    bool glass;  ///< Rays go through it.
    bool rough;  ///< It is glass that spreads them.
    const PlanContext& context;
    const SdfBody& body;
    render::Box box;  ///< The rays are marched in it.
    std::shared_ptr<const render::ShaderSources> sources;
};

/// A pass "EXHIBIT/STEP" with the body's values, block, buffers, permutations and shaders, without draws.
[[nodiscard]] render::Pass sdfPass(const SdfScene&, const char* step, std::string reason, std::string vertex,
                                   std::string fragment);
/// A mesh, or nothing for a triangle over the picture, with the body's place as its block.
[[nodiscard]] render::Draw sdfDraw(const SdfScene&, std::shared_ptr<const render::Mesh>);
/// What a pass that asks kit/sdf/shade.glsl for shadows has to define.
[[nodiscard]] std::string shadowDefine(const SdfScene&);
/// The sun's own rays find the body, and write where they did: its shadow has its true outline.
void planSdfShadow(const SdfScene&, render::FramePlan&);
/// March and cone pre-pass, counts, mesh and overlay, or why not. `mesh` is shown in place of the march where the
/// values ask for it; it may be null where they do not. Where it could not be made, the body is marched.
void planSdf(const SdfScene&, const render::Asset<render::Mesh>* mesh, render::FramePlan&);

}  // namespace vitrine
