#include "exhibits/hall/plaque_text.h"

#include "exhibits/hall/hall_scene.h"
#include "render/files/assets.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "render/text/translation.h"

#include <algorithm>

namespace vitrine::hall {
namespace {

// Layout of a plate of 0.42 x 0.26 m, in meters. Sizes are those of the smallest letters, for the longest text.
constexpr double plateWidth = 0.42;
constexpr double plateHeight = 0.26;
constexpr double plateMargin = 0.022;
constexpr double numberSize = 0.040;
constexpr double titleSize = 0.038;
constexpr double bodySize = 0.0205;
constexpr double mostScale = 1.5;
constexpr double lift = 0.0006;  ///< Height above the plate, so letters pass the depth test.

std::u32string decodeUtf8(std::string_view text)
{
    std::u32string result;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        char32_t c = length == 1 ? lead : lead & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length && i + k < text.size(); ++k)
            c = (c << 6U) | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
        result.push_back(c);
        i += length;
    }
    return result;
}

/// Moves the letters to the center of the plate.
void center(render::Mesh& mesh)
{
    glm::vec2 low(1e9F), high(-1e9F);
    for (const render::Vertex& v : mesh.vertices) {
        low = glm::min(low, glm::vec2(v.position));
        high = glm::max(high, glm::vec2(v.position));
    }
    for (render::Vertex& v : mesh.vertices) v.position -= glm::vec3(0.5F * (low + high), 0);
}

}  // namespace

PlaqueText::PlaqueText(const HallModel& model, const std::vector<ExhibitSlot>& exhibits)
{
    readFont();
    for (const auto& [number, place] : model.places()) {
        if (!place.worldFromPlaque) continue;
        const auto slot =
            std::find_if(exhibits.begin(), exhibits.end(), [n = number](const ExhibitSlot& g) { return g.place == n; });
        plaques_.push_back({*place.worldFromPlaque, set(number, slot == exhibits.end() ? nullptr : &*slot)});
    }
}

void PlaqueText::readFont()
{
    const render::Json font = render::readJson(render::asset("fonts/font_atlas.json")).root();
    auto picture =
        std::make_shared<render::Texture>(*render::loadTexture(render::asset("fonts/font_atlas.png"), false, false));
    picture->mipmaps = true;
    atlas_ = picture;
    spread_ = font.value("spread", 6.0);
    lineHeight_ = font.value("lineHeight", 1.3);
    for (const auto& [code, row] : font.at("glyphs").items()) {
        const auto number = [&entry = row](const char* key) { return entry.value(key, 0.0); };
        Glyph g{number("advance"), number("left"), number("bottom"), number("width"), number("height"), {}, {}};
        g.uv0 = {static_cast<float>(number("u0")), static_cast<float>(number("v0"))};
        g.uv1 = {static_cast<float>(number("u1")), static_cast<float>(number("v1"))};
        glyphs_[static_cast<char32_t>(std::stoul(code))] = g;
    }
}

const PlaqueText::Glyph& PlaqueText::glyph(char32_t c) const
{
    static const Glyph none{0.25, 0, 0, 0, 0, {}, {}};
    const auto found = glyphs_.find(c);
    if (found != glyphs_.end()) return found->second;
    const auto question = glyphs_.find(U'?');
    return c == U' ' || question == glyphs_.end() ? none : question->second;
}

double PlaqueText::widthOf(const std::u32string& text) const
{
    double width = 0;
    for (const char32_t c : text) width += glyph(c).advance;
    return width;
}

std::vector<std::u32string> PlaqueText::broken(const std::u32string& text, double widest) const
{
    std::vector<std::u32string> lines(1);
    std::u32string word;
    const auto flush = [&] {
        if (word.empty()) return;
        std::u32string longer = lines.back().empty() ? word : lines.back() + U' ' + word;
        if (widthOf(longer) > widest && !lines.back().empty())
            lines.push_back(word);
        else
            lines.back() = std::move(longer);
        word.clear();
    };
    for (const char32_t c : text) {
        if (c == U' ')
            flush();
        else
            word.push_back(c);
    }
    flush();
    return lines;
}

void PlaqueText::append(render::Mesh& mesh, const std::u32string& text, glm::dvec2 pen, double size) const
{
    for (const char32_t c : text) {
        const Glyph& g = glyph(c);
        if (g.width > 0 && g.height > 0) {
            const glm::vec2 low(pen + size * glm::dvec2(g.left, g.bottom));
            const glm::vec2 high(low + static_cast<float>(size) * glm::vec2(g.width, g.height));
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            const auto corner = [&](float x, float y, float u, float v) {
                mesh.vertices.push_back({{x, y, static_cast<float>(lift)}, {0, 0, 1}, {1, 0, 0, 1}, {u, v}, {}});
            };
            // Texture rows run downwards, so v0 is the top of the glyph.
            corner(low.x, low.y, g.uv0.x, g.uv1.y);
            corner(high.x, low.y, g.uv1.x, g.uv1.y);
            corner(high.x, high.y, g.uv1.x, g.uv0.y);
            corner(low.x, high.y, g.uv0.x, g.uv0.y);
            mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
        }
        pen.x += size * g.advance;
    }
}

double PlaqueText::lay(const std::vector<Paragraph>& paragraphs, double scale, render::Mesh* mesh) const
{
    const double left = -plateWidth / 2 + plateMargin;
    const double width = plateWidth - 2 * plateMargin;
    double y = plateHeight / 2 - plateMargin - titleSize * scale * 0.78;
    double last = y;
    for (const Paragraph& paragraph : paragraphs) {
        const double size = paragraph.size * scale;
        const double indent = paragraph.label.empty() ? 0 : widthOf(paragraph.label) * numberSize * scale + 0.016;
        if (mesh) append(*mesh, paragraph.label, {left, y}, numberSize * scale);
        for (const std::u32string& line : broken(paragraph.text, (width - indent) / size)) {
            if (mesh) append(*mesh, line, {left + indent, y}, size);
            last = y;
            y -= size * lineHeight_ * 0.92;
        }
        y -= 0.008 * scale;
    }
    return last;
}

std::shared_ptr<const render::Mesh> PlaqueText::set(int number, const ExhibitSlot* slot) const
{
    auto mesh = std::make_shared<render::Mesh>();
    const bool isFree = number == freePlinthPlace;
    const std::string label = isFree ? "" : std::to_string(number);
    mesh->bounds = {{-plateWidth / 2, -plateHeight / 2, -0.01}, {plateWidth / 2, plateHeight / 2, 0.01}};
    mesh->name = "plaque " + (label.empty() ? "free" : label);
    const std::string title = translated(slot ? slot->title : isFree ? "Your own object" : "In preparation");
    const std::string summary = translated(slot     ? slot->summary
                                           : isFree ? "Drop a glTF file on the window and it stands here."
                                                    : "This place waits for an exhibit.");
    std::vector<Paragraph> paragraphs{{decodeUtf8(title), titleSize, decodeUtf8(label)},
                                      {decodeUtf8(summary), bodySize, {}}};
    if (slot && !slot->tryThis.empty())
        paragraphs.push_back({decodeUtf8(translated("Try: " + slot->tryThis)), bodySize, {}});
    // The text is as large as the plate allows.
    double scale = mostScale;
    while (scale > 1 && lay(paragraphs, scale, nullptr) < -plateHeight / 2 + plateMargin) scale -= 0.02;
    lay(paragraphs, scale, mesh.get());
    center(*mesh);
    return mesh;
}

}  // namespace vitrine::hall
