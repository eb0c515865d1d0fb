#include "exhibits/your_shader/reading.h"

#include "exhibits/your_shader/size_expression.h"
#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "render/files/text_position.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vitrine::guest {
namespace {

using render::Json;

/// Range of the JSON text inside the first comment; empty if there is none.
std::string_view headOf(std::string_view text)
{
    const std::size_t open = text.find("/*");
    if (open == std::string_view::npos) return {};
    const std::size_t close = text.find("*/", open + 2);
    std::string_view comment = text.substr(open + 2, close == std::string_view::npos ? close : close - open - 2);
    const std::size_t first = comment.find_first_not_of(" \t\n*");
    if (first == std::string_view::npos || comment[first] != '{') return {};
    comment.remove_prefix(first);
    return comment.substr(0, comment.find_last_not_of(" \t\n*") + 1);
}

/// Reads the JSON head of an ISF file.
class IsfHead {
public:
    IsfHead(Reading& reading, std::uint32_t file)
        : reading_(reading), file_(file), text_(reading.shader.files[file].text), head_(headOf(text_))
    {
    }

    void read()
    {
        parse();
        Shader& shader = reading_.shader;
        shader.form = Form::isf;
        shader.version = json_.contains("ISFVSN") ? textOf(json_["ISFVSN"]) : "1";
        shader.description = textOf(member(json_, "DESCRIPTION"));
        shader.credit = textOf(member(json_, "CREDIT"));
        for (const Json& category : member(json_, "CATEGORIES"))
            if (category.is_string()) shader.categories.push_back(category.get<std::string>());
        readInputs();
        readImports();
        readPasses();
    }

private:
    [[noreturn]] void refuse(const std::string& word, Message sentence) const
    {
        throw refused(reading_, file_, lineOf(word), word, std::move(sentence));
    }
    /// Returns the line of a word in quotes; the first line of the head if it does not occur.
    [[nodiscard]] int lineOf(const std::string& word) const
    {
        const auto begin = static_cast<std::size_t>(head_.data() - text_.data());
        const std::size_t at = word.empty() ? std::string::npos : head_.find('"' + word + '"');
        return render::positionAt(text_, at == std::string::npos ? begin : begin + at).line;
    }
    static const Json& member(const Json& object, const char* key)
    {
        static const Json none;
        const auto found = object.is_object() ? object.find(key) : object.end();
        return object.is_object() && found != object.end() ? *found : none;
    }
    static std::string textOf(const Json& json)
    {
        if (json.is_string()) return json.get<std::string>();
        return json.is_number() ? json.dump() : "";
    }

    void parse()
    {
        // Files of the format's own collection repeat keys; the last one counts, as in other hosts. The strict reader
        // refuses that, and says line and column of everything else.
        try {
            json_ =
                render::parseJson(std::string(head_), "", {Limits::textBytes, 32, 100'000, Limits::textBytes}).root();
        } catch (const render::JsonFailure& failure) {
            try {
                json_ = Json::parse(head_);
            } catch (const Json::exception&) {
                fail(failure);
            }
            if (depthOf(head_) > 32) fail(failure);
            reading_.note(file_, placeOf(failure).line, "",
                          message("In the JSON head, {1}; the last one counts.", failure.problem()));
        }
        if (!json_.is_object()) refuse("", message("The first comment holds no JSON object; begin it with {."));
    }
    static int depthOf(std::string_view text)
    {
        int depth = 0, most = 0;
        for (const char c : text) {
            depth += (c == '{' || c == '[') - (c == '}' || c == ']');
            most = std::max(most, depth);
        }
        return most;
    }
    [[nodiscard]] render::TextPosition placeOf(const render::JsonFailure& failure) const
    {
        const render::TextPosition begin =
            render::positionAt(text_, static_cast<std::size_t>(head_.data() - text_.data()));
        const FilePlace& at = failure.place();
        return {begin.line + at.line - 1, at.line == 1 ? begin.column + at.column - 1 : at.column};
    }
    [[noreturn]] void fail(const render::JsonFailure& failure) const
    {
        const render::TextPosition at = placeOf(failure);
        throw Refused({.file = reading_.shader.files[file_].name,
                       .line = at.line,
                       .column = at.column,
                       .sentence = message("In the JSON head: {1}.", failure.problem())});
    }

    void readInputs()
    {
        const Json& inputs = member(json_, "INPUTS");
        if (!inputs.is_null() && !inputs.is_array())
            refuse("INPUTS", message("INPUTS must be a list of inputs in [ ]."));
        for (const Json& each : inputs) readInput(each);
    }
    void readInput(const Json& json)
    {
        Input input;
        input.name = textOf(member(json, "NAME"));
        if (input.name.empty()) refuse("INPUTS", message("An input has no NAME; give it the name of its variable."));
        const std::string type = textOf(member(json, "TYPE"));
        static const std::map<std::string, std::pair<InputType, const char*>> types{
            {"float", {InputType::real, "float"}},
            {"bool", {InputType::toggle, "bool"}},
            {"long", {InputType::choice, "int"}},
            {"color", {InputType::color, "vec4"}},
            {"point2D", {InputType::point, "vec2"}},
            {"event", {InputType::event, "bool"}},
            {"image", {InputType::image, "sampler2D"}},
            {"audio", {InputType::audio, "sampler2D"}},
            {"audioFFT", {InputType::spectrum, "sampler2D"}}};
        const auto found = types.find(type);
        if (found == types.end())
            refuse(input.name,
                   message("The input “{1}” has the unknown TYPE “{2}”; use float, bool, long, color, point2D, "
                           "event, image, audio or audioFFT.",
                           input.name, type));
        input.type = found->second.first;
        input.glslType = found->second.second;
        input.label = textOf(member(json, "LABEL"));
        readRange(json, input);
        addInput(reading_, std::move(input), file_, lineOf(textOf(member(json, "NAME"))));
    }
    /// Returns the numbers of a value: a number, a Boolean, or a list; empty if it is none of them.
    std::vector<double> numbers(const Input& input, const Json& json, const char* key, std::size_t count) const
    {
        const Json& value = member(json, key);
        if (value.is_null()) return {};
        std::vector<double> all;
        if (value.is_number()) all.assign(1, value.get<double>());
        if (value.is_boolean()) all.assign(1, value.get<bool>() ? 1 : 0);
        if (value.is_array())
            for (const Json& each : value)
                if (each.is_number()) all.push_back(each.get<double>());
        // Colors are given with and without alpha.
        if (count == 4 && all.size() == 3) all.push_back(1);
        if (all.size() == 1 && count > 1) all.resize(count, all.front());
        if (all.size() != count)
            refuse(input.name, message("{1} of the input “{2}” must have {3} numbers.", key, input.name, count));
        return all;
    }
    void readRange(const Json& json, Input& input)
    {
        const std::size_t count = componentsOf(input.glslType);
        if (input.type == InputType::audio || input.type == InputType::spectrum)
            input.high = numbers(input, json, "MAX", 1);
        if (input.type == InputType::event || count == 0) return;
        if (input.type == InputType::choice) return readChoices(json, input);
        input.low = numbers(input, json, "MIN", count);
        input.high = numbers(input, json, "MAX", count);
        input.initial = numbers(input, json, "DEFAULT", count);
        if (const Json& exact = member(json, "EXACT"); exact.is_number() && count == 1)
            input.exact = exact.get<double>();
        // A key of our own, which other hosts ignore: the unit in which the slider shows the number.
        if (count == 1 && textOf(member(json, "UNIT")).size() <= 8) input.unit = textOf(member(json, "UNIT"));
        const bool lacksRange = input.low.empty() || input.high.empty();
        if (input.low.empty()) input.low.assign(count, 0);
        if (input.high.empty()) input.high.assign(count, 1);
        if (input.initial.empty())
            input.initial = input.type == InputType::color ? std::vector<double>{1, 1, 1, 1} : input.low;
        widen(input);
        if (lacksRange && input.type == InputType::real)
            reading_.note(file_, lineOf(input.name), input.name,
                          message("“{1}” has no MIN and MAX; the slider goes from 0 to 1, or as far as its default.",
                                  input.name));
    }
    /// Puts the ends of each range in order, and the initial value between them.
    static void widen(Input& input)
    {
        for (std::size_t i = 0; i < input.initial.size(); ++i) {
            if (input.low[i] > input.high[i]) std::swap(input.low[i], input.high[i]);
            input.low[i] = std::min(input.low[i], input.initial[i]);
            input.high[i] = std::max(input.high[i], input.initial[i]);
        }
    }
    void readChoices(const Json& json, Input& input)
    {
        const Json& values = member(json, "VALUES");
        const Json& labels = member(json, "LABELS");
        const std::vector<double> initial = numbers(input, json, "DEFAULT", 1);
        if (const Json& exact = member(json, "EXACT"); exact.is_number()) input.exact = exact.get<double>();
        if (!values.is_array() || values.empty()) {
            input.type = InputType::integer;
            input.low = numbers(input, json, "MIN", 1);
            input.high = numbers(input, json, "MAX", 1);
            if (input.low.empty()) input.low.assign(1, 0);
            if (input.high.empty()) input.high.assign(1, std::max(10.0, input.low[0]));
            input.initial = initial.empty() ? input.low : initial;
            widen(input);
            return;
        }
        if (values.size() > Limits::choices)
            refuse(input.name,
                   message("The input “{1}” has more than {2} VALUES; remove some.", input.name, Limits::choices));
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!values[i].is_number() || std::abs(values[i].get<double>()) > 1e9)
                refuse(input.name, message("VALUES of the input “{1}” must be whole numbers.", input.name));
            const int value = static_cast<int>(values[i].get<double>());
            const bool named = labels.is_array() && i < labels.size();
            input.choices.push_back({value, named ? textOf(labels[i]) : std::to_string(value)});
        }
        const auto isExact = [&](const InputChoice& choice) { return choice.value == input.exact; };
        if (input.exact && std::none_of(input.choices.begin(), input.choices.end(), isExact))
            refuse(input.name,
                   message("EXACT of the input “{1}” is not one of its VALUES; write one of them.", input.name));
        const auto isInitial = [&](const InputChoice& choice) {
            return !initial.empty() && choice.value == initial[0];
        };
        const bool known = std::any_of(input.choices.begin(), input.choices.end(), isInitial);
        input.initial.assign(1, known ? initial[0] : input.choices.front().value);
    }

    void readImports()
    {
        const Json& imported = member(json_, "IMPORTED");
        for (const auto& [key, value] : imported.items()) {
            const std::string name = imported.is_object() ? key : textOf(member(value, "NAME"));
            const std::string path = textOf(member(value, "PATH"));
            if (path.empty())
                refuse(name, message("The import “{1}” has no PATH; name a picture beside the shader.", name));
            if (reading_.shader.imports.size() >= Limits::imports)
                refuse(name, message("The shader imports more than {1} pictures; remove some.", Limits::imports));
            if (const Message why = render::whyRefused(path); !why.empty())
                refuse(path, message("The import “{1}” cannot be read: {2}.", path, why));
            requireName(reading_, name, file_, lineOf(name));
            reading_.shader.imports.push_back({name, path});
        }
    }

    void readPasses()
    {
        const Code code = withIncludes(reading_, file_);
        const Json& passes = member(json_, "PASSES");
        for (const Json& each : passes) {
            if (reading_.shader.passes.size() >= Limits::passes)
                refuse("PASSES", message("The shader has more than {1} passes; remove some.", Limits::passes));
            reading_.shader.passes.push_back(pass(each, code));
        }
        if (reading_.shader.passes.empty()) reading_.shader.passes.push_back({.name = "pass 1", .code = code});
        readPersistentBuffers();
    }
    Pass pass(const Json& json, const Code& code)
    {
        Pass pass{.name = "pass " + std::to_string(reading_.shader.passes.size() + 1), .code = code};
        pass.target = textOf(member(json, "TARGET"));
        if (!pass.target.empty()) requireName(reading_, pass.target, file_, lineOf(pass.target));
        pass.isPersistent = isTrue(member(json, "PERSISTENT"));
        pass.isFloat = isTrue(member(json, "FLOAT"));
        pass.width = size(json, "WIDTH");
        pass.height = size(json, "HEIGHT");
        return pass;
    }
    static bool isTrue(const Json& json)
    {
        return (json.is_boolean() && json.get<bool>()) || (json.is_number() && json.get<double>() != 0);
    }
    /// Returns a size expression that can be evaluated.
    std::string size(const Json& json, const char* key)
    {
        const std::string text = textOf(member(json, key));
        const auto value = [this](std::string_view name) -> std::optional<double> {
            const Input* input = reading_.shader.inputNamed(std::string(name));
            if (!input || input->initial.size() != 1) return std::nullopt;
            return input->initial.front();
        };
        const PassSize size = passSize(text, 640, 480, 640, value);
        if (!size.problem.empty()) refuse(text, message("{1} of a pass: {2}.", key, size.problem));
        return text;
    }
    /// Reads the buffers of version 1: a list of names, or an object with sizes by name.
    void readPersistentBuffers()
    {
        const Json& buffers = member(json_, "PERSISTENT_BUFFERS");
        for (const auto& [key, value] : buffers.items()) {
            const std::string name = buffers.is_object() ? key : textOf(value);
            for (Pass& pass : reading_.shader.passes) {
                if (pass.target != name) continue;
                pass.isPersistent = true;
                pass.isFloat = pass.isFloat || isTrue(member(value, "FLOAT"));
                if (pass.width.empty()) pass.width = size(value, "WIDTH");
                if (pass.height.empty()) pass.height = size(value, "HEIGHT");
            }
        }
    }

    Reading& reading_;
    std::uint32_t file_;
    const std::string text_;
    const std::string_view head_;
    Json json_;
};

}  // namespace

bool isIsf(std::string_view text)
{
    return !headOf(text).empty();
}

void readIsf(Reading& reading, std::uint32_t file)
{
    reading.shader.builtIns = {{"PASSINDEX", "int"},   {"RENDERSIZE", "vec2"}, {"TIME", "float"},
                               {"TIMEDELTA", "float"}, {"DATE", "vec4"},       {"FRAMEINDEX", "int"}};
    IsfHead(reading, file).read();
}

}  // namespace vitrine::guest
