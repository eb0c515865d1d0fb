#pragma once

#include "exhibits/hall/hall_model.h"
#include "render/scene/mesh.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vitrine {

struct ExhibitSlot;

/// The texts of all plaques as meshes of glyph quads over a distance-field atlas.
class PlaqueText {
public:
    struct Plaque {
        glm::dmat4 worldFromPlaque{1};
        std::shared_ptr<const render::Mesh> mesh;
    };

    /// Reads assets/fonts and sets the text of every place that has a plaque: its number, title, one line
    /// and what to try; "In preparation" where no slot stands. In the language of the program. Throws Failure
    /// (Blame::file).
    PlaqueText(const HallModel&, const std::vector<ExhibitSlot>&);

    [[nodiscard]] const std::vector<Plaque>& plaques() const { return plaques_; }
    [[nodiscard]] std::shared_ptr<const render::Texture> atlas() const { return atlas_; }
    /// Texels from an outline to the end of the distance field.
    [[nodiscard]] double spread() const { return spread_; }

private:
    struct Glyph {
        double advance = 0, left = 0, bottom = 0, width = 0, height = 0;  ///< em
        glm::vec2 uv0{0}, uv1{0};
    };
    struct Paragraph {
        std::u32string text;
        double size;           ///< Meters.
        std::u32string label;  ///< Before it, or empty.
    };
    void readFont();
    [[nodiscard]] const Glyph& glyph(char32_t) const;
    [[nodiscard]] double widthOf(const std::u32string&) const;
    [[nodiscard]] std::vector<std::u32string> broken(const std::u32string& text, double widest) const;
    void append(render::Mesh&, const std::u32string&, glm::dvec2 pen, double size) const;
    /// Sets them at so many times their sizes, or only measures where `mesh` is null. Returns the last base line's
    /// height.
    double lay(const std::vector<Paragraph>&, double scale, render::Mesh* mesh) const;
    [[nodiscard]] std::shared_ptr<const render::Mesh> set(int number, const ExhibitSlot*) const;

    std::shared_ptr<const render::Texture> atlas_;
    double spread_ = 6;
    double lineHeight_ = 1.3;
    std::map<char32_t, Glyph> glyphs_;
    std::vector<Plaque> plaques_;
};

}  // namespace vitrine
