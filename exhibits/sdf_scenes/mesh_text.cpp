#include "exhibits/sdf_scenes/mesh_text.h"

#include "render/files/zip_file.h"
#include "render/image/srgb.h"
#include "render/text/escaped.h"
#include "render/version.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

namespace vitrine::scenes {
namespace {

/// Appends the shortest text that reads back as the same number.
template <typename Number> void putNumber(std::string& text, Number x)
{
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr;
    text.append(digits.data(), end);
}

void putVector(std::string& text, const glm::vec3& v)
{
    for (int i = 0; i < 3; ++i) {
        text += ' ';
        putNumber(text, v[i]);
    }
}

std::array<std::uint8_t, 3> codesOf(const glm::vec3& color)
{
    return {render::srgb8FromLinear(color.x), render::srgb8FromLinear(color.y), render::srgb8FromLinear(color.z)};
}

std::string onOneLine(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return text;
}

/// Colors of a mesh, each once, and the index of that of each vertex.
struct Colors {
    std::vector<std::array<std::uint8_t, 3>> all;
    std::vector<std::size_t> ofVertex;
};
Colors colorsOf(const SceneMesh& mesh)
{
    Colors colors;
    std::map<std::array<std::uint8_t, 3>, std::size_t> known;
    for (const MeshVertex& vertex : mesh.vertices) {
        const auto [found, isNew] = known.emplace(codesOf(vertex.color), colors.all.size());
        if (isNew) colors.all.push_back(found->first);
        colors.ofVertex.push_back(found->second);
    }
    return colors;
}

std::string hexColor(const std::array<std::uint8_t, 3>& codes)
{
    constexpr const char* digits = "0123456789ABCDEF";
    std::string text = "#";
    for (const std::uint8_t code : codes) (text += digits[code >> 4U]) += digits[code & 15U];
    return text;
}

/// Millimeters, z up.
glm::vec3 onPlate(const glm::vec3& meters)
{
    return 1000.0F * glm::vec3(meters.x, -meters.z, meters.y);
}

void putAttribute(std::string& xml, const char* name, auto value)
{
    ((xml += ' ') += name) += "=\"";
    putNumber(xml, value);
    xml += '"';
}

std::string meshXml(const SceneMesh& mesh, const Colors& colors)
{
    std::string xml = "<mesh><vertices>\n";
    for (const MeshVertex& vertex : mesh.vertices) {
        const glm::vec3 at = onPlate(vertex.position);
        xml += "<vertex";
        putAttribute(xml, "x", at.x);
        putAttribute(xml, "y", at.y);
        putAttribute(xml, "z", at.z);
        xml += "/>\n";
    }
    xml += "</vertices><triangles>\n";
    constexpr std::array<std::array<const char*, 2>, 3> corners{{{"v1", "p1"}, {"v2", "p2"}, {"v3", "p3"}}};
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        xml += "<triangle";
        for (std::size_t k = 0; k < 3; ++k) putAttribute(xml, corners.at(k)[0], mesh.indices[i + k]);
        xml += " pid=\"1\"";
        for (std::size_t k = 0; k < 3; ++k) putAttribute(xml, corners.at(k)[1], colors.ofVertex[mesh.indices[i + k]]);
        xml += "/>\n";
    }
    return xml + "</triangles></mesh>";
}

std::string modelXml(const SceneMesh& mesh, const std::string& name)
{
    glm::vec3 low(0);
    if (!mesh.vertices.empty()) low = onPlate(mesh.vertices.front().position);
    for (const MeshVertex& vertex : mesh.vertices) low = glm::min(low, onPlate(vertex.position));
    const Colors colors = colorsOf(mesh);
    std::string xml =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
        "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n<metadata name=\"Title\">" +
        escaped(onOneLine(name)) + "</metadata>\n<metadata name=\"Application\">Vitrine " +
        escaped(render::programVersion()) + "</metadata>\n<resources>\n<m:colorgroup id=\"1\">\n";
    for (const auto& codes : colors.all) xml += "<m:color color=\"" + hexColor(codes) + "FF\"/>\n";
    xml += "</m:colorgroup>\n<object id=\"2\" type=\"model\" pid=\"1\" pindex=\"0\">" + meshXml(mesh, colors) +
           "</object>\n</resources>\n<build><item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1";
    putVector(xml, -low);
    return xml + "\"/></build>\n</model>\n";
}

}  // namespace

std::string objFile(const SceneMesh& mesh, const std::string& name)
{
    std::string text =
        "# Vitrine " + std::string(render::programVersion()) + ", meters, y up\no " + onOneLine(name) + '\n';
    for (const MeshVertex& vertex : mesh.vertices) {
        text += 'v';
        putVector(text, vertex.position);
        glm::vec3 encoded;
        for (int i = 0; i < 3; ++i) encoded[i] = static_cast<float>(render::srgb8FromLinear(vertex.color[i])) / 255;
        putVector(text, encoded);
        text += '\n';
    }
    for (const MeshVertex& vertex : mesh.vertices) {
        text += "vn";
        putVector(text, vertex.normal);
        text += '\n';
    }
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        text += i % 3 == 0 ? "f " : " ";
        putNumber(text, mesh.indices[i] + 1);
        text += "//";
        putNumber(text, mesh.indices[i] + 1);
        if (i % 3 == 2) text += '\n';
    }
    return text;
}

std::string threeMfFile(const SceneMesh& mesh, const std::string& name)
{
    return render::zipFile(
        {{"[Content_Types].xml",
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
          "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
          "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
          "</Types>\n"},
         {"_rels/.rels", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                         "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
                         "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
                         "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n"},
         {"3D/3dmodel.model", modelXml(mesh, name)}});
}

}  // namespace vitrine::scenes
