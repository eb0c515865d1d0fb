#pragma once

#include "exhibits/your_shader/guest_blocks.h"
#include "exhibits/your_shader/guest_shader.h"
#include "render/files/atomic_write.h"
#include "render/text/message.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::guest {

/// Form in which a shader is exported.
enum class ExportForm : std::uint8_t {
    isf,            ///< ISF 2, ".fs"; a vertex shader becomes a file beside it.
    shadertoy,      ///< Shadertoy code of one pass, ".glsl".
    shadertoyJson,  ///< Shadertoy's JSON, with all buffers, ".json".
    web             ///< One HTML page that needs no network, ".html".
};

/// State in which an exported shader begins.
struct ExportStart {
    double moment = 0;       ///< Seconds.
    bool runs = true;        ///< Whether time runs on a page.
    double rate = 60;        ///< Steps per second.
    int loopRounds = 65536;  ///< Largest number of loop iterations per pixel on a page.
    Mouse mouse = {};
    glm::ivec2 size{960, 540};  ///< Size of the picture on a page, in pixels.
};

/// A shader with the values that its inputs have now.
struct ExportedShader {
    Shader shader;                                ///< The initial values of its inputs are the present ones.
    std::filesystem::path path;                   ///< File that it was read from.
    std::vector<std::filesystem::path> ofInputs;  ///< Pictures of the inputs, by index; empty: none.
    ExportStart start;
    std::vector<Message> notes = {};  ///< Sentences on what does not follow the inputs.
};

/// Files that an export writes, the main one first.
struct ExportedFiles {
    std::vector<render::NamedBytes> files;
    std::vector<Message> notes;  ///< Sentences on what the form cannot hold.
};

/// Returns the work with the values of its inputs.
[[nodiscard]] ExportedShader exportedShader(const Work&, const YourShaderTable&, const ParameterValues&);

/// Returns the file of the ISF, and those beside it. `out` is the path of the file. Throws Failure (ErrorKind::check)
/// with a sentence on what ISF cannot hold.
[[nodiscard]] ExportedFiles isfFiles(const ExportedShader&, const std::filesystem::path& out);

/// The same for Shadertoy's code, which has one pass, and for its JSON.
[[nodiscard]] ExportedFiles shadertoyFiles(const ExportedShader&, bool asJson, const std::filesystem::path& out);

/// The same for a web page.
[[nodiscard]] ExportedFiles webFiles(const ExportedShader&, const std::filesystem::path& out);

/// Calls one of the functions above.
[[nodiscard]] ExportedFiles exportedFiles(const ExportedShader&, ExportForm, const std::filesystem::path& out);

}  // namespace vitrine::guest
