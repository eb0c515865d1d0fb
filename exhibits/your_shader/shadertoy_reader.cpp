#include "exhibits/your_shader/reading.h"

#include "render/files/number_text.h"
#include "render/files/strict_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace vitrine::guest {
namespace {

using render::Json;

void addBuiltIns(Shader& shader)
{
    shader.form = Form::shadertoy;
    shader.builtIns = {{"iResolution", "vec3"},
                       {"iTime", "float"},
                       {"iTimeDelta", "float"},
                       {"iFrameRate", "float"},
                       {"iFrame", "int"},
                       {"iMouse", "vec4"},
                       {"iDate", "vec4"},
                       {"iSampleRate", "float"},
                       {"iChannelTime", "float", 4},
                       {"iChannelResolution", "vec3", 4}};
}

/// Returns the path of a channel: "file://sand.png" is "sand.png".
std::string channelPath(std::string_view text)
{
    std::string path = unquoted(text);
    return path.starts_with("file://") ? path.substr(7) : path;
}

/// Reads the preprocessor lines of editors that make sliders and name the channels.
class Directives {
public:
    Directives(Reading& reading, std::uint32_t file)
        : reading_(reading), file_(file), text_(reading.shader.files[file].text), tokens_(text_)
    {
    }

    /// Returns the channels that are named or used.
    std::vector<Channel> read()
    {
        for (std::size_t i = 0; i < tokens_.size(); i = tokens_.lineEnd(i)) {
            if (tokens_[i].directive == 0) continue;
            const std::string_view word = tokens_.text(i + 1);
            if (word == "iUniform") slider(i + 2, tokens_.lineEnd(i));
            if (word.starts_with("iChannel")) channel(i + 1, tokens_.lineEnd(i));
        }
        std::vector<Channel> used;
        for (const char digit : {'0', '1', '2', '3'}) {
            const std::string name = std::string("iChannel") + digit;
            const auto named = channels_.find(name);
            if (named != channels_.end())
                used.push_back(named->second);
            else if (tokens_.contains(name))
                used.push_back({.name = name, .glslType = "sampler2D", .kind = "texture"});
        }
        return used;
    }

private:
    [[noreturn]] void refuse(std::size_t at, Message sentence) const
    {
        const std::size_t i = std::min(at, tokens_.size() - 1);
        throw refused(reading_, file_, tokens_[i].line, tokens_.text(i), std::move(sentence));
    }
    [[noreturn]] void refuseSlider(std::size_t at) const
    {
        refuse(at, message("“{1}” is wrong here; write #iUniform float name = 0.5 in {0.0, 1.0}.", tokens_.text(at)));
    }

    /// Reads numbers up to a closing bracket: "1", "-1", "true", "vec2(1, 2)", "{ 0, 1 }". Moves `at` behind them.
    std::vector<double> numbers(std::size_t& at, std::size_t end) const
    {
        const std::size_t begin = at;
        std::vector<double> all;
        int depth = 0;
        double sign = 1;
        for (; at < end; ++at) {
            const std::string_view text = tokens_.text(at);
            if (text == "(" || text == "{") {
                ++depth;
            } else if (text == ")" || text == "}") {
                if (--depth <= 0) break;
            } else if (text == "-") {
                sign = -1;
            } else if (text == "true" || text == "false") {
                all.push_back(text == "true" ? 1 : 0);
                if (depth == 0) break;
            } else if (tokens_[at].kind == render::Token::Kind::number) {
                const std::optional<double> value = glslNumber(text);
                if (!value) refuseSlider(at);
                all.push_back(sign * *value);
                sign = 1;
                if (depth == 0) break;
            } else if (text != "," && !(at == begin && tokens_[at].kind == render::Token::Kind::word)) {
                refuseSlider(at);
            }
        }
        at = std::min(at + 1, end);
        return all;
    }

    void slider(std::size_t at, std::size_t end)
    {
        static const std::map<std::string_view, std::pair<InputType, const char*>> types{
            {"float", {InputType::real, "float"}},  {"int", {InputType::integer, "int"}},
            {"bool", {InputType::toggle, "bool"}},  {"vec2", {InputType::vector, "vec2"}},
            {"vec3", {InputType::vector, "vec3"}},  {"vec4", {InputType::vector, "vec4"}},
            {"color3", {InputType::color, "vec3"}}, {"color4", {InputType::color, "vec4"}}};
        const auto type = types.find(tokens_.text(at));
        if (at + 1 >= end || type == types.end()) refuseSlider(std::min(at, end - 1));
        Input input;
        input.name = tokens_.text(at + 1);
        input.type = type->second.first;
        input.glslType = type->second.second;
        const std::size_t count = componentsOf(input.glslType);
        const std::size_t last = end - 1;
        at += 2;
        if (at < end && tokens_.text(at) == "=") {
            input.initial = numbers(++at, end);
            if (input.initial.size() == 1) input.initial.resize(count, input.initial.front());
            if (input.initial.size() != count) refuseSlider(std::min(at, last));
        }
        if (at < end && tokens_.text(at) == "in") {
            const std::vector<double> range = numbers(++at, end);
            if (range.size() != 2 || range[0] >= range[1]) refuseSlider(std::min(at, last));
            input.low.assign(count, range[0]);
            input.high.assign(count, range[1]);
        }
        complete(input, count, last);
        addInput(reading_, std::move(input), file_, tokens_[last].line);
    }
    void complete(Input& input, std::size_t count, std::size_t last) const
    {
        if (input.initial.empty()) input.initial.assign(count, 0);
        if (input.low.empty()) {
            input.low.assign(count, 0);
            input.high.assign(count, 1);
            for (std::size_t i = 0; i < count && input.type != InputType::color; ++i) {
                input.low[i] = std::min(0.0, 2 * input.initial[i]);
                input.high[i] = std::max(1.0, 2 * input.initial[i]);
            }
        }
        // The same comment as behind a uniform gives label, unit and exact value.
        const std::string_view comment = tokens_.commentBehind(last);
        if (!comment.empty()) readRangeComment(comment, count, input, reading_, file_, tokens_[last].line);
        for (std::size_t i = 0; i < count; ++i) {
            input.low[i] = std::min(input.low[i], input.initial[i]);
            input.high[i] = std::max(input.high[i], input.initial[i]);
        }
    }

    void channel(std::size_t at, std::size_t end)
    {
        const std::string name(tokens_.text(at));
        if (name.size() != 9 || name.back() < '0' || name.back() > '3')
            refuse(at, message("“{1}” is not a channel; there are iChannel0 to iChannel3.", name));
        Channel& channel =
            channels_.try_emplace(name, Channel{.name = name, .glslType = "sampler2D", .kind = "texture"})
                .first->second;
        if (at + 1 >= end) refuse(at, message("“{1}” names no file; write #iChannel0 \"file://name.png\".", name));
        const std::string value = channelPath(tokens_.text(end - 1));
        if (tokens_.text(at + 1) != ":") {
            channel.source = value;
            if (value == "self") channel.kind = "buffer";
            return;
        }
        const std::string_view key = tokens_.text(at + 3);
        if (key == "MinFilter" || key == "MagFilter") channel.filter = value;
        if (key.starts_with("WrapMode")) channel.wrap = value;
        if (key == "Type" && value == "CubeMap") {
            channel.glslType = "samplerCube";
            channel.kind = "cubemap";
        } else if (key == "Type" && value == "Volume") {
            channel.glslType = "sampler3D";
            channel.kind = "volume";
        } else if (key == "Type" && value == "Keyboard") {
            channel.kind = "keyboard";
        }
    }

    Reading& reading_;
    std::uint32_t file_;
    const std::string text_;
    const render::Tokens tokens_;
    std::map<std::string, Channel> channels_;
};

/// Reads the JSON that Shadertoy exports.
class Export {
public:
    Export(Reading& reading, std::uint32_t file) : reading_(reading), file_(file) {}

    void read()
    {
        const SourceFile source = reading_.shader.files[file_];
        Json json;
        try {
            json = render::parseJson(source.text, "", {Limits::textBytes, 32, 100'000, Limits::textBytes}).root();
        } catch (const render::JsonFailure& failure) {
            const FilePlace& at = failure.place();
            throw Refused({source.name, at.line, at.column, message("In the JSON: {1}.", failure.problem())});
        }
        if (json.is_array() && !json.empty()) json = Json(json[0]);
        if (json.is_object() && json.contains("Shader")) json = Json(json["Shader"]);
        const Json passes = json.is_object() && json.contains("renderpass") ? json["renderpass"] : Json();
        if (!passes.is_array())
            refuse(message("This JSON has no list “renderpass”; export the shader from Shadertoy again."));
        const Json info = json.contains("info") ? json["info"] : Json();
        reading_.shader.title = textOf(info, "name");
        reading_.shader.description = textOf(info, "description");
        reading_.shader.credit = textOf(info, "username");
        if (passes.size() > Limits::passes)
            refuse(message("The shader has more than {1} passes; remove some.", Limits::passes));
        readCommon(passes);
        for (const char* type : {"buffer", "cubemap", "image"})
            for (const Json& pass : passes)
                if (textOf(pass, "type") == type) readPass(pass, type);
        if (reading_.shader.passes.empty() || !reading_.shader.passes.back().target.empty())
            refuse(message("This JSON has no pass of type “image”; add the pass that draws the picture."));
    }

private:
    [[noreturn]] void refuse(Message sentence) const { throw refused(reading_, file_, 1, "", std::move(sentence)); }
    static std::string textOf(const Json& object, const char* key)
    {
        if (!object.is_object() || !object.contains(key)) return "";
        const Json& value = object[key];
        return value.is_string() ? value.get<std::string>() : value.is_number() ? value.dump() : "";
    }
    static Json listOf(const Json& object, const char* key)
    {
        return object.is_object() && object.contains(key) && object[key].is_array() ? object[key] : Json::array();
    }
    std::uint32_t addCode(const Json& pass, const std::string& name)
    {
        return reading_.addFile(reading_.shader.files[file_].name + " (" + name + ")",
                                render::withPlainLineEnds(textOf(pass, "code")));
    }

    void readCommon(const Json& passes)
    {
        for (const Json& pass : passes) {
            const std::string type = textOf(pass, "type");
            if (type == "common") {
                const std::uint32_t file = addCode(pass, "Common");
                static_cast<void>(Directives(reading_, file).read());
                common_ = withIncludes(reading_, file);
            } else if (type == "sound") {
                reading_.note(file_, 1, "", message("The sound pass is left out; pictures have no sound."));
            } else if (type == "buffer" || type == "cubemap") {
                for (const Json& output : listOf(pass, "outputs")) targets_[textOf(output, "id")] = nameOf(pass);
            } else if (type != "image") {
                refuse(message("A pass has the unknown type “{1}”; there are common, buffer, image, cubemap and sound.",
                               type));
            }
        }
    }
    static std::string nameOf(const Json& pass)
    {
        const std::string name = textOf(pass, "name");
        return name.empty() ? textOf(pass, "type") : name;
    }
    void readPass(const Json& json, const std::string& type)
    {
        Pass pass{.name = nameOf(json)};
        const std::uint32_t file = addCode(json, pass.name);
        // Buffers keep their content, because any of them may be read before it is drawn.
        pass.isPersistent = pass.isFloat = type != "image";
        if (type != "image") pass.target = pass.name;
        if (type == "cubemap") {
            pass.isCube = true;
            pass.width = pass.height = std::to_string(Limits::cubeSide);
            if (reading_.shader.builtIns.back().name != cubeFaceName)
                reading_.shader.builtIns.push_back({cubeFaceName, "int"});
        }
        pass.code = common_;
        const Code own = withIncludes(reading_, file);
        pass.code.insert(pass.code.end(), own.begin(), own.end());
        pass.channels = Directives(reading_, file).read();
        for (const Json& input : listOf(json, "inputs")) readInput(input, pass);
        reading_.shader.passes.push_back(std::move(pass));
    }
    void readInput(const Json& json, Pass& pass)
    {
        const std::string number = textOf(json, "channel");
        if (number.size() != 1 || number[0] < '0' || number[0] > '3')
            refuse(message("An input of “{1}” has no channel from 0 to 3.", pass.name));
        Channel channel{.name = "iChannel" + number, .glslType = "sampler2D"};
        channel.kind = textOf(json, json.contains("ctype") ? "ctype" : "type");
        channel.source = textOf(json, json.contains("src") ? "src" : "filepath");
        if (channel.kind == "cubemap") channel.glslType = "samplerCube";
        if (channel.kind == "volume") channel.glslType = "sampler3D";
        if (const auto target = targets_.find(textOf(json, "id")); target != targets_.end())
            channel.source = target->second;
        const Json sampler = json.contains("sampler") ? json["sampler"] : Json();
        channel.filter = textOf(sampler, "filter");
        channel.wrap = textOf(sampler, "wrap");
        channel.flipped = textOf(sampler, "vflip") == "true";
        const auto same = [&](const Channel& other) { return other.name == channel.name; };
        std::erase_if(pass.channels, same);
        pass.channels.push_back(std::move(channel));
    }

    Reading& reading_;
    std::uint32_t file_;
    Code common_;
    std::map<std::string, std::string> targets_;  // Names of buffers, by the number of their output.
};

}  // namespace

void readShadertoyText(Reading& reading, std::uint32_t file)
{
    addBuiltIns(reading.shader);
    Pass pass{.name = "Image"};
    pass.channels = Directives(reading, file).read();
    pass.code = withIncludes(reading, file);
    for (std::uint32_t included = file + 1; included < reading.shader.files.size(); ++included)
        for (Channel& channel : Directives(reading, included).read()) {
            const auto same = [&](const Channel& other) { return other.name == channel.name; };
            if (std::none_of(pass.channels.begin(), pass.channels.end(), same))
                pass.channels.push_back(std::move(channel));
        }
    reading.shader.passes.push_back(std::move(pass));
}

void readShadertoyJson(Reading& reading, std::uint32_t file)
{
    addBuiltIns(reading.shader);
    Export(reading, file).read();
}

}  // namespace vitrine::guest
