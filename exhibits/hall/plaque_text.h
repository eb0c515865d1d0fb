#pragma once

#include "exhibits/hall/hall_model.h"
#include "render/scene/mesh.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::hall {

struct ExhibitSlot;

/// Texts of all plaques, as meshes of glyph quads with a distance-field atlas.
class PlaqueText {
public:
    struct Plaque {
        glm::dmat4 worldFromPlaque{1};
        std::shared_ptr<const render::Mesh> mesh;
    };

    /// Reads assets/fonts and sets the texts of all plaques, in the language of the program: number, title, summary and
    /// what to try. A place without a slot says "In preparation". Throws Failure (ErrorKind::file).
    PlaqueText(const HallModel&, const std::vector<ExhibitSlot>&);

    [[nodiscard]] const std::vector<Plaque>& plaques() const { return plaques_; }
    [[nodiscard]] std::shared_ptr<const render::Texture> atlas() const { return atlas_; }
    /// Returns the number of texels from an outline to the end of the distance field.
    [[nodiscard]] double spread() const { return spread_; }

private:
    struct Glyph {
        double advance = 0, left = 0, bottom = 0, width = 0, height = 0;  ///< em
        glm::vec2 uv0{0}, uv1{0};
    };
    struct Paragraph {
        std::u32string text;
        double size;           ///< Meters.
        std::u32string label;  ///< Text before the paragraph, or empty.
    };
    void readFont();
    [[nodiscard]] const Glyph& glyph(char32_t) const;
    [[nodiscard]] double widthOf(const std::u32string&) const;
    [[nodiscard]] std::vector<std::u32string> broken(const std::u32string& text, double widest) const;
    void append(render::Mesh&, const std::u32string&, glm::dvec2 pen, double size) const;
    /// Sets the paragraphs at `scale` times their sizes; only measures them if `mesh` is null. Returns the height of
    /// the last baseline.
    double lay(const std::vector<Paragraph>&, double scale, render::Mesh* mesh) const;
    [[nodiscard]] std::shared_ptr<const render::Mesh> set(int number, const ExhibitSlot*) const;

    std::shared_ptr<const render::Texture> atlas_;
    double spread_ = 6;
    double lineHeight_ = 1.3;
    std::map<char32_t, Glyph> glyphs_;
    std::vector<Plaque> plaques_;
};

}  // namespace vitrine::hall
