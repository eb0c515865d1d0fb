#include "app/kit/picture_options.h"

#include "app/kit/apply_preset.h"
#include "app/kit/number_option.h"
#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/table/expression.h"
#include "exhibits/framework/table/value_text.h"
#include "exhibits/framework/time/motion_json.h"
#include "exhibits/hall/hall_table.h"
#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

#include <CLI/CLI.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace vitrine::app {
namespace {

std::vector<std::string> split(const std::string& text, char separator)
{
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else if (c != ' ')
            parts.back() += c;
    }
    return parts;
}

glm::dmat4 exhibitTransform(const PictureOptions& options, const PictureRecord* taken)
{
    if (taken && options.rotate.empty() && options.scale.empty()) return taken->exhibitTransform;
    glm::dmat4 m(1);
    if (!options.rotate.empty()) {
        const glm::dvec3 degrees = parseTriple("--rotate", options.rotate, Unit::degree);
        for (int axis = 2; axis >= 0; --axis) {
            glm::dvec3 direction(0);
            direction[axis] = 1;
            m = glm::rotate(m, degrees[axis] * std::numbers::pi / 180, direction);
        }
    }
    if (!options.scale.empty()) {
        const glm::dvec3 scale = parseTriple("--scale", options.scale);
        if (std::abs(scale.x) < 1e-6 || std::abs(scale.y) < 1e-6 || std::abs(scale.z) < 1e-6)
            throw Failure(ErrorKind::usage,
                          "--scale " + options.scale +
                              ": a scale of 0 leaves nothing to draw; give three numbers away from 0.");
        m = glm::scale(m, scale);
    }
    return m;
}

}  // namespace

void setCamera(const PictureOptions& options, render::Camera& camera)
{
    if (!options.eye.empty()) camera.eye = parseTriple("--eye", options.eye, Unit::meter);
    if (!options.target.empty()) camera.target = parseTriple("--target", options.target, Unit::meter);
    if (options.fovDegrees > 0) camera.fovY = options.fovDegrees * std::numbers::pi / 180;
}

glm::dvec3 parseTriple(const std::string& option, const std::string& text, Unit unit)
{
    const std::vector<std::string> parts = split(text, ',');
    glm::dvec3 result(0);
    bool good = parts.size() == 3;
    for (int i = 0; good && i < 3; ++i) {
        const auto number = plainOrWithUnit(parts[static_cast<std::size_t>(i)], unit);
        good = number.has_value();
        result[i] = number.value_or(0);
    }
    if (!good)
        throw Failure(ErrorKind::usage,
                      option + " \"" + text + "\": give three numbers, such as " + option + " 1.5,2,-0.5.");
    return result;
}

glm::ivec2 parseSize(const std::string& option, const std::string& text, const std::string& what,
                     const std::string& such)
{
    const std::vector<std::string> parts = split(text, 'x');
    glm::ivec2 size(0);
    for (int i = 0; parts.size() == 2 && i < 2; ++i) {
        const auto number = render::parseNumber(parts[static_cast<std::size_t>(i)]);
        if (number && *number >= 1 && *number <= 1e6 && *number == std::floor(*number))
            size[i] = static_cast<int>(*number);
    }
    if (size.x < 1 || size.y < 1)
        throw Failure(ErrorKind::usage, option + " \"" + text + "\": give " + what +
                                            ", each from 1 to 1000000, such as " + option + ' ' + such + '.');
    return size;
}

void addCameraOptions(CLI::App& command, PictureOptions& o, const std::string& heading)
{
    const auto add = [&](const char* name, auto& value, const char* help) {
        return command.add_option(name, value, help)->group(heading);
    };
    addNumber(command, "--time", o.time, {.unit = Unit::second}, "Time on the exhibit's clock, in seconds")
        ->default_str("0")
        ->group(heading);
    addNumber(command, "--seed", o.seed, {0, 4294967295.0}, "Seed of the random numbers")
        ->default_str("1")
        ->group(heading);
    add("--eye", o.eye,
        "Position of the camera: x,y,z in meters, in the hall's space (with --alone: in the exhibit's)");
    add("--target", o.target, "Point that the camera looks at: x,y,z in meters");
    addNumber(command, "--fov", o.fovDegrees, {1, 175, Unit::degree}, "Vertical field of view in degrees")
        ->group(heading);
}

void addSceneOptions(CLI::App& command, PictureOptions& o, const std::string& heading)
{
    const auto add = [&](const char* name, auto& value, const char* help) {
        return command.add_option(name, value, help)->group(heading);
    };
    add("--preset", o.preset,
        "Settings to start from: the name of a shipped preset, or a file (preset, exhibition, or picture with settings "
        "in it). A picture also sets size, samples, time, seed, camera, --alone, --transparent, --rotate and --scale. "
        "Other options take precedence");
    command
        .add_flag("--settings-only", o.settingsOnly,
                  "Take only settings and camera from the picture that --preset names, and not its size, samples, time "
                  "or seed")
        ->group(heading);
    add("--set", o.sets,
        "Value of a parameter, as name=value or exhibit.name=value; numbers without a unit are in SI units")
        ->take_all()
        ->allow_extra_args(true);
    add("--animate", o.motions,
        "Animation of a parameter, as NAME=KIND:FROM:TO[:KEY=VALUE...], such as morph=sine:0.1:0.9:period=4; --time is "
        "its clock")
        ->take_all()
        ->allow_extra_args(true);
    addCameraOptions(command, o, heading);
    add("--scale", o.scale, "Scale of the exhibit: X,Y,Z; negative numbers mirror it");
    add("--rotate", o.rotate, "Rotation of the exhibit in degrees: X,Y,Z, applied about x first, then y, then z");
    command.add_flag("--alone", o.alone, "Show the exhibit alone, without the hall, in the environment's light")
        ->group(heading);
    addNumber(command, "--samples", o.samples, {1, 4096},
              "Samples per pixel. Default: as in the picture that --preset names, else the hall's supersamples if a "
              "preset or --set changes them, else 4")
        ->group(heading);
    command.add_flag("--transparent", o.transparent, "Make the background of the exhibit transparent (alpha 0)")
        ->group(heading);
    add("--environment", o.environment, "File of a panorama that replaces the sky");
    add("--model", o.model, "File of a glTF object that stands on the free plinth");
}

RequestedPicture requestedPicture(const Museum& museum, const PictureOptions& options)
{
    return requestedPicture(museum, options, museum.initialSceneState(), std::nullopt);
}

namespace {

/// Returns the camera of the preset, in the space of the picture, or else the best view of the subject.
render::Camera chosenCamera(const Museum& museum, const RequestedPicture& job, bool alone)
{
    if (job.taken && job.taken->camera && job.taken->alone == alone) return *job.taken->camera;
    const render::Camera& camera = job.sceneState.camera;
    // Cameras of presets are in the hall's space. If the exhibit is alone, its own space is the world.
    if (job.cameraFromPreset)
        return alone ? camera.transformed(glm::inverse(museum.worldFromExhibit(job.subject))) : camera;
    if (job.subject == hallIndex) return camera;
    const ParameterValues& values = job.sceneState.values[job.subject];
    return alone ? museum.subject(job.subject).bestView(values) : museum.bestView(job.subject, values);
}

/// Returns the samples per pixel if no option gives them. `supersamples` is the hall's value in the preset.
int chosenSamples(const RequestedPicture& job, int supersamples)
{
    const hall::HallTable names;
    const ParameterValues& hall = job.sceneState.hall();
    const bool setHere = hall[names.supersamples] != supersamples;
    if (setHere) return hall[names.supersamples];
    return job.taken ? job.taken->samples : usualSamples(hall);
}

}  // namespace

RequestedPicture requestedPicture(const Museum& museum, const PictureOptions& options, SceneState start,
                                  const std::optional<render::Camera>& startCamera,
                                  std::optional<PictureRecord> startTaken)
{
    const auto subject = museum.find(options.subject);
    if (!subject)
        throw Failure(ErrorKind::usage, "There is no exhibit \"" + options.subject + '"' +
                                            didYouMean(options.subject, namesOf(museum)) +
                                            " `vitrine list` names them.");
    const bool isHall = *subject == hallIndex;
    if (isHall && options.alone)
        throw Failure(ErrorKind::usage, "--alone: the hall cannot be shown without the hall; name an exhibit.");

    RequestedPicture job;
    job.subject = *subject;
    job.sceneState = std::move(start);
    if (startCamera) job.sceneState.camera = *startCamera;
    job.cameraFromPreset = startCamera.has_value();
    job.taken = std::move(startTaken);
    if (!options.preset.empty()) {
        const std::string leftOut = applyPreset(museum, options.preset, job);
        if (options.settingsOnly)
            job.taken.reset();
        else if (!leftOut.empty())
            job.notes.push_back(leftOut);
    }
    const PictureRecord* taken = job.taken ? &*job.taken : nullptr;
    const hall::HallTable names;
    const int supersamples = job.sceneState.hall()[names.supersamples];
    applySets(museum, job.sceneState, *subject, options.sets, job.notes);
    for (const std::string& motion : options.motions) applyMotion(museum, job.sceneState, *subject, motion);
    ParameterValues& hall = job.sceneState.hall();
    if (!options.environment.empty()) hall.set(names.environment, options.environment);
    if (!options.model.empty()) hall.set(names.objects.front().model, options.model);

    FrameRequest& frame = job.request.frame;
    const bool alone = options.alone || (taken && taken->alone);
    render::Camera camera = chosenCamera(museum, job, alone);
    setCamera(options, camera);
    frame.camera = camera;
    job.sceneState.camera = camera;
    frame.raster.size = !options.size.empty() ? parseSize("--size", options.size)
                        : taken               ? taken->size
                                              : parseSize("--size", usualPictureSize);
    frame.time = options.time.value_or(taken ? taken->time : 0);
    if (!std::isfinite(frame.time)) throw Failure(ErrorKind::usage, "--time: give a finite number of seconds.");
    frame.seed = options.seed.value_or(taken ? taken->seed : 1);
    frame.transparent = options.transparent || (taken && taken->transparent);
    if (frame.transparent && !alone && !isHall) frame.cutOut = *subject;
    frame.needsFiles = true;  // A missing file must fail: a picture without a named object would be wrong.
    frame.exhibitTransform = exhibitTransform(options, taken);
    if (alone)
        frame.alone = *subject;
    else if (!isHall)
        frame.subject = *subject;
    job.request.samples = options.samples > 0 ? options.samples : chosenSamples(job, supersamples);
    return job;
}

}  // namespace vitrine::app
