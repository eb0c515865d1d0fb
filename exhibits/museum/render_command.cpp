#include "exhibits/museum/render_command.h"

#include "exhibits/framework/table/value_text.h"
#include "exhibits/framework/time/motion_json.h"
#include "render/files/number_text.h"
#include "render/files/shell_word.h"

#include <cmath>
#include <numbers>

namespace vitrine {
namespace {

std::string triple(const glm::dvec3& v)
{
    return render::shortestNumber(v.x) + ',' + render::shortestNumber(v.y) + ',' + render::shortestNumber(v.z);
}

/// Returns the degrees that the option converts back to exactly these radians.
double degreesOf(double radians)
{
    double degrees = radians * 180 / std::numbers::pi;
    const auto read = [](double d) { return d * std::numbers::pi / 180; };
    for (int i = 0; i < 4 && read(degrees) < radians; ++i) degrees = std::nextafter(degrees, 1e9);
    for (int i = 0; i < 4 && read(degrees) > radians; ++i) degrees = std::nextafter(degrees, -1e9);
    return degrees;
}

/// Formats a value for `--set`: numbers in SI units.
std::string settingOf(const ParameterInfo& parameter, const Value& value)
{
    const auto* number = std::get_if<double>(&value);
    return number && parameter.isNumeric() ? render::shortestNumber(*number) : formatValue(parameter, value);
}

}  // namespace

std::vector<std::string> sceneWords(const Museum& museum, const SceneState& sceneState, const FrameRequest& request,
                                    bool withCamera)
{
    std::vector<std::string> words{"--time=" + render::shortestNumber(request.time),
                                   "--seed=" + std::to_string(request.seed)};
    if (withCamera) {
        words.push_back("--eye=" + triple(request.camera.eye));
        words.push_back("--target=" + triple(request.camera.target));
        words.push_back("--fov=" + render::shortestNumber(degreesOf(request.camera.fovY)));
    }
    for (std::size_t i = 0; i < museum.subjects().size(); ++i) {
        const ParameterValues& values = sceneState.values[i];
        for (std::size_t row = 0; row < values.rows().size(); ++row) {
            const ParameterInfo& info = values.rows()[row];
            const std::string name = std::string(museum.subject(i).name()) + '.' + std::string(info.name) + '=';
            if (!values.isInitial(row)) words.push_back("--set=" + name + settingOf(info, values.row(row)));
            if (const Motion* motion = values.motion(row))
                words.push_back("--animate=" + name +
                                motionText(*motion, [&](const Value& end) { return settingOf(info, end); }));
        }
    }
    return words;
}

std::string renderCommand(const Museum& museum, const SceneState& sceneState, const FrameRequest& request, int samples,
                          const std::string& out)
{
    const glm::ivec2 size = request.raster.size;
    std::string line = "vitrine render hall --size " + std::to_string(size.x) + 'x' + std::to_string(size.y) +
                       " --samples " + std::to_string(samples);
    for (const std::string& word : sceneWords(museum, sceneState, request)) line += ' ' + render::shellWord(word);
    return line + " --out " + render::shellWord(out);
}

}  // namespace vitrine
