#include "exhibits/your_shader/guest_blocks.h"

#include "exhibits/your_shader/guest_glsl.h"
#include "exhibits/your_shader/reading.h"
#include "render/glsl/std140.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace vitrine::guest {
namespace {

/// Writes the first components of a vector as a variable of this GLSL type.
void put(render::Std140Writer& writer, std::string_view type, const glm::dvec4& value)
{
    const std::size_t count = componentsOf(type);
    const auto write = [&](const auto& vector) {
        using Number = typename std::decay_t<decltype(vector)>::value_type;
        if (count == 1) writer.put(vector[0]);
        if (count == 2) writer.put(glm::vec<2, Number>(vector));
        if (count == 3) writer.put(glm::vec<3, Number>(vector));
        if (count == 4) writer.put(vector);
    };
    const bool isBool = type.starts_with('b');
    if (type.starts_with('f') || type.starts_with('v'))
        write(glm::vec4(value));
    else
        write(glm::ivec4(isBool ? glm::dvec4(glm::notEqual(value, glm::dvec4(0))) : glm::clamp(value, -2e9, 2e9)));
}

double numberOf(const ParameterValues& values, std::size_t row)
{
    return std::get<double>(values.row(row));
}

bool isPressed(double pressedAt, const StepTime& time)
{
    return pressedAt >= 0 && std::floor(pressedAt * time.rate + 1e-6) == static_cast<double>(time.frame);
}

glm::dvec4 valueOf(const Input& input, const std::vector<std::size_t>& rows, const ParameterValues& values,
                   const StepTime& time)
{
    glm::dvec4 value(0);
    if (rows.empty()) return value;
    switch (input.type) {
    case InputType::color: {
        const glm::dvec3 linear = std::get<glm::dvec3>(values.row(rows[0]));
        for (int i = 0; i < 3; ++i) value[i] = render::srgbFromLinear(linear[i]);
        value[3] = rows.size() > 1 ? numberOf(values, rows[1]) : 1;
        return value;
    }
    case InputType::choice: {
        const auto index = static_cast<std::size_t>(std::max(numberOf(values, rows[0]), 0.0));
        value[0] = input.choices[std::min(index, input.choices.size() - 1)].value;
        return value;
    }
    case InputType::event: value[0] = isPressed(numberOf(values, rows[0]), time) ? 1 : 0; return value;
    default:
        for (std::size_t i = 0; i < rows.size() && i < 4; ++i)
            value[static_cast<int>(i)] = shown(numberOf(values, rows[i]), values.rows()[rows[i]].unit);
        return value;
    }
}

/// Returns Shadertoy's iMouse, in pixels: the position, and where the button was pressed last. The third number is
/// negative while the button is up; all are 0 before it was pressed.
glm::dvec4 pressed(const Mouse& mouse, const glm::dvec2& size)
{
    if (!mouse.isDown && !mouse.pressedAt) return glm::dvec4(0);
    const glm::dvec2 at = mouse.pressedAt.value_or(mouse.position) * size;
    return {mouse.position * size, mouse.isDown ? at.x : -at.x, -at.y};
}

/// Variables of all dialects, by name.
class FrameValues {
public:
    FrameValues(const DrawnPass& drawn, const StepTime& time, const Mouse& mouse)
    {
        const double t = time.seconds, day = 86400;
        const glm::dvec2 whole(drawn.size), at = mouse.position * whole;
        const double seconds = t + day / 2, days = std::floor(seconds / day), ofDay = seconds - days * day;
        const glm::dvec4 date(2026, 1, 1 + days, ofDay), dateFrom0(2026, 0, 1 + days, ofDay);
        const glm::dvec4 resolution(whole, 1, 0), frame(static_cast<double>(time.frame));
        values_ = {{"PASSINDEX", glm::dvec4(static_cast<double>(drawn.pass))},
                   {cubeFaceName, glm::dvec4(drawn.face)},
                   {"RENDERSIZE", resolution},
                   {"TIME", glm::dvec4(t)},
                   {"TIMEDELTA", glm::dvec4(time.delta)},
                   {"DATE", date},
                   {"FRAMEINDEX", frame},
                   {"iResolution", resolution},
                   {"iTime", glm::dvec4(t)},
                   {"iTimeDelta", glm::dvec4(time.delta)},
                   {"iFrameRate", glm::dvec4(time.rate)},
                   {"iFrame", frame},
                   {"iMouse", pressed(mouse, whole)},
                   {"iDate", dateFrom0},
                   {"iSampleRate", glm::dvec4(44100)},
                   {"iChannelTime", glm::dvec4(t)},
                   {"u_time", glm::dvec4(t)},
                   {"u_delta", glm::dvec4(time.delta)},
                   {"u_resolution", resolution},
                   {"u_mouse", glm::dvec4(at, 0, 0)},
                   {"u_frame", frame},
                   {"u_date", dateFrom0},
                   {"time", glm::dvec4(t)},
                   {"mouse", glm::dvec4(mouse.position, 0, 0)},
                   {"resolution", resolution},
                   {"surfaceSize", glm::dvec4(whole.x / whole.y, 1, 0, 0)}};
    }
    [[nodiscard]] glm::dvec4 of(std::string_view name, const PictureSize& sizeOf) const
    {
        if (const auto found = values_.find(name); found != values_.end()) return found->second;
        // "u_tex0Resolution" is the size of "u_tex0".
        constexpr std::string_view ending = "Resolution";
        if (name.ends_with(ending)) name.remove_suffix(ending.size());
        return glm::dvec4(glm::dvec2(sizeOf(name)), 1, 0);
    }

private:
    std::map<std::string_view, glm::dvec4> values_;
};

}  // namespace

render::Bytes inputBytes(const Work& work, const YourShaderTable& table, const ParameterValues& values,
                         const StepTime& time, const PictureSize& sizeOf)
{
    render::Std140Writer writer;
    for (std::size_t i = 0; i < work.shader->inputs.size(); ++i) {
        const Input& input = work.shader->inputs[i];
        if (!isPicture(input)) {
            put(writer, input.glslType, valueOf(input, table.ofInputs[i], values, time));
        } else if (work.shader->form == Form::isf) {
            writer.put(glm::vec4(0, 0, 1, 1));
            writer.put(glm::vec2(sizeOf(input.name)));
            writer.put(false);
        }
    }
    return writer.take();
}

render::Bytes frameBytes(const Work& work, const DrawnPass& drawn, const StepTime& time, const Mouse& mouse,
                         const PictureSize& sizeOf)
{
    const FrameValues values(drawn, time, mouse);
    render::Std140Writer writer;
    for (const BuiltIn& builtIn : work.shader->builtIns) {
        if (builtIn.count == 0) {
            put(writer, builtIn.glslType, values.of(builtIn.name, sizeOf));
            continue;
        }
        for (std::size_t i = 0; i < builtIn.count; ++i) {
            writer.align(16);
            const std::string channel = "iChannel" + std::to_string(i);
            put(writer, builtIn.glslType,
                builtIn.name == "iChannelTime" ? values.of(builtIn.name, sizeOf)
                                               : values.of(channel + "Resolution", sizeOf));
            writer.align(16);
        }
    }
    return writer.take();
}

}  // namespace vitrine::guest
