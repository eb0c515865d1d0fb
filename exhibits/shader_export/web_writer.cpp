// Writes a shader as one web page: programs in GLSL ES 3.00, pictures as data, and a player (assets/web).

#include "exhibits/shader_export/exported_shader.h"
#include "exhibits/shader_export/picture_files.h"
#include "exhibits/your_shader/guest_glsl.h"
#include "exhibits/your_shader/guest_work.h"
#include "exhibits/your_shader/reading.h"
#include "render/failure.h"
#include "render/files/assets.h"
#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "render/image/picture_formats.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <mutex>

namespace vitrine::guest {
namespace {

using render::Json;
using From = PassPicture::From;

constexpr std::size_t mostTemplateBytes = 1U << 20U;
constexpr std::size_t mostPagePictureBytes = 16U << 20U;

[[noreturn]] void refuseForWeb(Message sentence)
{
    throw Failure(ErrorKind::check, std::move(sentence));
}

/// Layout of a uniform block of scalars and vectors (std140).
class BlockLayout {
public:
    /// Returns the offset of the next member. The elements of an array are members of their own.
    std::size_t add(const std::string& type, bool isElement = false)
    {
        const std::size_t count = componentsOf(type);
        const std::size_t alignment = isElement || count > 2 ? 16 : 4 * count;
        const std::size_t offset = (at_ + alignment - 1) / alignment * alignment;
        at_ = offset + 4 * count;
        if (isElement) end();
        return offset;
    }
    /// Returns the number of bytes, a multiple of 16.
    std::size_t end() { return at_ = (at_ + 15) / 16 * 16; }

private:
    std::size_t at_ = 0;
};

std::string base64(std::string_view bytes)
{
    static constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t j = 0; j < 3; ++j)
            three = three << 8U | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
        for (std::size_t j = 0; j < 4; ++j) text += i + j > bytes.size() ? '=' : letters[three >> (18 - 6 * j) & 63U];
    }
    return text;
}

/// Returns a picture file as the address of its data. Throws Failure if browsers do not read its format.
std::string dataAddress(const std::filesystem::path& file)
{
    const render::PictureFileFormat* format = render::formatNamed(file);
    if (!format || format->mediaType.empty())
        refuseForWeb(message("Web browsers cannot read {1}; convert it to PNG or JPEG.", file));
    return "data:" + std::string(format->mediaType) + ";base64," + base64(render::readFile(file, mostPagePictureBytes));
}

std::string kindName(const Input& input)
{
    switch (input.type) {
    case InputType::real: return "real";
    case InputType::toggle: return "toggle";
    case InputType::integer: return "integer";
    case InputType::choice: return "choice";
    case InputType::color: return "color";
    case InputType::point:
    case InputType::vector: return "vector";
    case InputType::event: return "event";
    case InputType::image: return "image";
    default: return "none";
    }
}

std::string replaced(std::string text, std::string_view what, const std::string& by)
{
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

std::string escapedForHtml(std::string text)
{
    text = replaced(std::move(text), "&", "&amp;");
    text = replaced(std::move(text), "<", "&lt;");
    return replaced(std::move(text), "\"", "&quot;");
}

/// Returns a program with the limit of its loops.
std::string withRounds(const std::string& glsl, int rounds)
{
    const std::size_t newline = glsl.find('\n') + 1;
    const std::string text =
        glsl.substr(0, newline) + "#define GUEST_ROUNDS " + std::to_string(rounds) + "u\n" + glsl.substr(newline);
    return replaced(text, "\nuint guest_rounds", "\nhighp uint guest_rounds");
}

/// Collects the programs, inputs, passes and pictures of the page.
class PageWriter {
public:
    explicit PageWriter(const ExportedShader& exported) : exported_(exported), shader_(exported.shader) {}

    ExportedFiles write(const std::filesystem::path& out)
    {
        translate();
        const ExportStart& start = exported_.start;
        page_ = Json{
            {"description", shader_.description},
            {"credit", shader_.credit},
            {"size", {start.size.x, start.size.y}},
            {"moment", start.moment},
            {"runs", start.runs},
            {"rate", start.rate},
            {"mouse", Json{{"x", start.mouse.position.x}, {"y", start.mouse.position.y}, {"down", start.mouse.isDown}}},
            {"readsTime", work_->readsTime},
            {"kept", work_->isKept},
            {"triangles", trianglesOf(shader_)},
            {"mipmaps", shader_.form == Form::shadertoy}};
        addInputs();
        addFrameBlock();
        addTargets();
        addPasses();
        page_["files"] = Json::array();
        for (const std::filesystem::path& file : work_->files) page_["files"].push_back(dataAddress(file));
        const std::string json = replaced(page_.dump(-1, ' ', false, Json::error_handler_t::replace), "<", "\\u003c");
        const std::string title = shader_.title.empty() ? "Shader" : shader_.title;
        std::string text = render::readFile(render::asset("web") / "shader_page.html", mostTemplateBytes);
        text = replaced(std::move(text), "{{TITLE}}", escapedForHtml(title));
        files_.files.push_back({out, replaced(std::move(text), "{{SHADER}}", json)});
        return std::move(files_);
    }

private:
    void translate()
    {
        static ShaderCompiler compiler;
        static std::mutex mutex;
        const std::lock_guard lock(mutex);
        auto shared = std::make_shared<const Shader>(shader_);
        WebPrograms web = translateForWeb(shared, compiler);
        CheckedShader checked{.shader = shared, .programs = web.programs, .errors = web.errors};
        if (checked.isGood()) work_ = makeWork(checked, exported_.path, checked.errors);
        if (!checked.isGood()) {
            const Finding& first = checked.errors.front();
            refuseForWeb(message("{1}:{2}:{3}: {4}", first.file, first.line, first.column, first.sentence));
        }
        programs_ = std::move(web.programs);
    }

    void addInputs()
    {
        BlockLayout layout;
        Json members = Json::array(), inputs = Json::array();
        for (std::size_t i = 0; i < shader_.inputs.size(); ++i) {
            const Input& input = shader_.inputs[i];
            inputs.push_back(inputJson(i));
            const auto member = [&](const char* type, const char* part) {
                members.push_back(Json{{"type", type}, {"input", i}, {"offset", layout.add(type)}});
                if (*part != 0) members.back()["part"] = part;
            };
            if (!isPicture(input)) {
                member(input.glslType.c_str(), "");
            } else if (shader_.form == Form::isf) {
                member("vec4", "rect");
                member("vec2", "size");
                member("bool", "flip");
            }
        }
        page_["inputs"] = std::move(inputs);
        page_["inputBlock"] = std::move(members);
        page_["inputBytes"] = layout.end();
    }
    Json inputJson(std::size_t index)
    {
        const Input& input = shader_.inputs[index];
        Json json{{"name", input.name},       {"label", input.label.empty() ? input.name : input.label},
                  {"kind", kindName(input)},  {"type", input.glslType},
                  {"low", input.low},         {"high", input.high},
                  {"initial", input.initial}, {"unit", input.unit}};
        json["choices"] = Json::array();
        for (const InputChoice& choice : input.choices)
            json["choices"].push_back(Json{{"value", choice.value}, {"label", choice.label}});
        if (input.type == InputType::audio || input.type == InputType::spectrum)
            files_.notes.push_back(message("A page has no sound: “{1}” is silence there.", input.name));
        if (input.source == "buffer") json["kind"] = "none";
        if (input.type != InputType::image || input.source == "buffer") return json;
        const std::filesystem::path& file = exported_.ofInputs[index];
        if (file.empty())
            files_.notes.push_back(
                message("“{1}” has no picture file: the page begins with a test picture.", input.name));
        else
            json["picture"] = dataAddress(file);
        return json;
    }
    void addFrameBlock()
    {
        BlockLayout layout;
        Json members = Json::array();
        for (const BuiltIn& builtIn : shader_.builtIns)
            for (std::size_t i = 0; i < std::max<std::size_t>(builtIn.count, 1); ++i) {
                members.push_back(Json{{"name", builtIn.name},
                                       {"type", builtIn.glslType},
                                       {"offset", layout.add(builtIn.glslType, builtIn.count > 0)}});
                if (builtIn.name == "iChannelResolution") members.back()["picture"] = "iChannel" + std::to_string(i);
            }
        page_["frameBlock"] = std::move(members);
        page_["frameBytes"] = layout.end();
    }
    void addTargets()
    {
        page_["targets"] = Json::array();
        for (const Target& target : work_->targets) {
            if (target.isCube) refuseKind(target.name);
            page_["targets"].push_back(Json{{"name", target.name},
                                            {"float", target.isFloat},
                                            {"kept", target.isKept},
                                            {"repeats", target.repeats},
                                            {"nearest", target.isNearest},
                                            {"width", target.width},
                                            {"height", target.height}});
        }
    }
    [[noreturn]] static void refuseKind(const std::string& use)
    {
        refuseForWeb(message("A page has no picture of the kind of “{1}”; use a picture file or a buffer.", use));
    }
    static const char* nameOf(const PassPicture& picture, const std::string& use)
    {
        switch (picture.from) {
        case From::thisStep: return "thisStep";
        case From::stepBefore: return "stepBefore";
        case From::input: return "input";
        case From::file: return "file";
        case From::nothing: return "nothing";
        default: break;
        }
        refuseKind(use);
    }
    void addPasses()
    {
        page_["passes"] = Json::array();
        page_["programs"] = Json::array();
        std::map<std::string, std::size_t> known;
        for (std::size_t i = 0; i < work_->passes.size(); ++i) {
            const PassProgram& program = programs_[i];
            const auto [found, isNew] = known.try_emplace(program.vertex + program.fragment, known.size());
            if (isNew)
                page_["programs"].push_back({withRounds(program.vertex, exported_.start.loopRounds),
                                             withRounds(program.fragment, exported_.start.loopRounds)});
            Json pictures = Json::array();
            const std::vector<PictureUse> uses = picturesOf(shader_, shader_.passes[i]);
            for (const PassPicture& picture : work_->passes[i].pictures) {
                const PictureUse& use = uses[static_cast<std::size_t>(picture.unit)];
                if (use.glslType != "sampler2D")
                    refuseForWeb(message("A page has no {1}, which “{2}” is; use a picture.", use.glslType, use.name));
                pictures.push_back(Json{{"use", use.name},
                                        {"sampler", programName(use.name)},
                                        {"from", nameOf(picture, use.name)},
                                        {"index", picture.index}});
            }
            page_["passes"].push_back(Json{{"name", shader_.passes[i].name},
                                           {"target", work_->passes[i].target},
                                           {"program", found->second},
                                           {"pictures", std::move(pictures)}});
        }
    }

    const ExportedShader& exported_;
    const Shader& shader_;
    std::shared_ptr<const Work> work_;
    std::vector<PassProgram> programs_;
    Json page_;
    ExportedFiles files_;
};

}  // namespace

ExportedFiles webFiles(const ExportedShader& exported, const std::filesystem::path& out)
{
    return PageWriter(exported).write(out);
}

}  // namespace vitrine::guest
