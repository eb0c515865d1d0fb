#pragma once

#include "tests/render/scene/gltf_builder.h"
#include "tests/support/temporary_folder.h"

#include <string>

namespace vitrine::test {

/// Writes a triangle with two animations of two and three seconds: "walk" to the side, "jump" up. They end where they
/// begin, and have different positions at the same share of their duration. Returns the path.
inline std::string writeMovedModel(const TemporaryFolder& folder)
{
    GltfBuilder b;
    const int node = b.node({{"mesh", b.triangle()}});
    b.json["animations"] = render::Json::array();
    for (const bool up : {false, true}) {
        const float x = up ? 0.0F : 2.0F, y = up ? 3.0F : 0.0F, end = up ? 3.0F : 2.0F;
        b.json["animations"].push_back(
            {{"name", up ? "jump" : "walk"},
             {"samplers", render::Json::array({{{"input", b.floats({0, 0.6F * end, end}, "SCALAR")},
                                                {"output", b.floats({0, 0, 0, x, y, 0, 0, 0, 0}, "VEC3")}}})},
             {"channels",
              render::Json::array(
                  {{{"sampler", 0U}, {"target", {{"node", static_cast<unsigned>(node)}, {"path", "translation"}}}}})}});
    }
    const std::string path = (folder / "moved.glb").string();
    writeBytes(path, b.glb());
    return path;
}

}  // namespace vitrine::test
