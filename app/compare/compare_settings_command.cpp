#include "app/compare/comparison_folder.h"
#include "app/kit/command.h"
#include "app/kit/number_option.h"
#include "app/kit/picture_options.h"
#include "app/kit/progress.h"
#include "app/kit/report.h"
#include "app/kit/say.h"
#include "app/kit/useless_option.h"

#include "exhibits/compare/offered_comparison.h"
#include "exhibits/exhibits.h"
#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace vitrine::app {
namespace {

/// Name in place of a file: the initial values of all subjects.
constexpr const char* initialSettings = "initial";

struct SettingsOptions {
    std::array<std::string, 2> files;
    std::string with;  ///< Comparison offered by the exhibit, in place of the second file.
    PictureOptions picture;
    int runs = 5;
    std::string gain = "8";  ///< One of `comparisonGains`.
};

/// Returns the file names of A and B, or the whole paths if the names are equal.
std::array<std::string, 2> namesOf(const std::array<std::string, 2>& files)
{
    std::array<std::string, 2> names;
    for (std::size_t i = 0; i < 2; ++i) names[i] = std::filesystem::path(files[i]).filename().string();
    return names[0] == names[1] ? files : names;
}

/// Returns the camera of both pictures: as the options say, else that of the first file that has one, else the best
/// view of the named exhibit, or of the first one in which A and B differ.
render::Camera sharedCamera(const Museum& museum, const std::array<RequestedPicture, 2>& jobs,
                            const PictureOptions& options)
{
    render::Camera camera = jobs[0].request.frame.camera;
    if (!jobs[0].cameraFromPreset && jobs[1].cameraFromPreset) {
        camera = jobs[1].request.frame.camera;
    } else if (!jobs[0].cameraFromPreset && jobs[0].subject == hallIndex) {
        const std::vector<DifferingParameter> rows = differingParameters(jobs[0].sceneState, jobs[1].sceneState);
        const auto exhibit = std::find_if(rows.begin(), rows.end(),
                                          [](const DifferingParameter& row) { return row.subject != hallIndex; });
        if (exhibit != rows.end())
            camera = museum.bestView(exhibit->subject, jobs[0].sceneState.values[exhibit->subject]);
    }
    setCamera(options, camera);
    return camera;
}

RequestedPicture requestedSide(const Museum& museum, const PictureOptions& picture, const std::string& settings)
{
    PictureOptions one = picture;
    one.settingsOnly = true;
    one.preset = settings == initialSettings ? "" : settings;
    RequestedPicture job = requestedPicture(museum, one);
    for (const std::string& note : job.notes) say(note);
    return job;
}

/// Reads the subject and both files from the options. An exhibit's name in place of A stands for its initial values.
void readSubject(const Museum& museum, const CLI::App& command, SettingsOptions& options)
{
    if (options.with.empty() == options.files[1].empty())
        throw Failure(ErrorKind::usage, options.with.empty()
                                            ? "compare-settings: name a second setting, or what A is compared --with."
                                            : "compare-settings: give either a second setting or --with, not both.");
    if (!museum.find(options.files[0])) return;
    refuseOn(command, "--exhibit", options.picture.subject != options.files[0], "an exhibit that is named as A");
    options.picture.subject = options.files[0];
    options.files[0] = initialSettings;
}

/// Returns the named exhibit, or the first one that differs from the initial values.
std::size_t subjectOf(const Museum& museum, const RequestedPicture& job)
{
    if (job.subject != hallIndex) return job.subject;
    for (const DifferingParameter& row :
         differingParameters(job.sceneState, museum.readTables(museum.initialSceneState()).sceneState))
        if (row.subject != hallIndex) return row.subject;
    throw Failure(ErrorKind::usage,
                  "--with: these settings change no exhibit; say with --exhibit which one is compared.");
}

/// Replaces B by the comparison that the exhibit of A offers, and B's file name by its title.
void compareWith(const Museum& museum, SettingsOptions& options, std::array<RequestedPicture, 2>& jobs)
{
    const std::size_t subject = subjectOf(museum, jobs[0]);
    const OfferedComparison offered = offeredComparison(museum.subject(subject), options.with);
    jobs[1] = jobs[0];
    jobs[1].sceneState = otherSide(jobs[0].sceneState, subject, offered);
    options.files[1] = offered.title;
}

ComparisonRequest comparisonRequest(const Museum& museum, const CLI::App& command, SettingsOptions& options)
{
    std::array<RequestedPicture, 2> jobs;
    readSubject(museum, command, options);
    jobs[0] = requestedSide(museum, options.picture, options.files[0]);
    if (options.with.empty())
        jobs[1] = requestedSide(museum, options.picture, options.files[1]);
    else
        compareWith(museum, options, jobs);
    ComparisonRequest request;
    request.frame = jobs[0].request.frame;
    request.frame.camera = sharedCamera(museum, jobs, options.picture);
    request.runs = options.runs;
    for (std::size_t i = 0; i < 2; ++i) {
        request.settings[i] = std::move(jobs[i].sceneState);
        request.settings[i].camera = request.frame.camera;
        request.samples[i] = jobs[i].request.samples;
    }
    return request;
}

int compareSettings(const CLI::App& command, SettingsOptions options)
{
    requireComparisonFolder(options.picture.out);
    const render::gl::HeadlessContext context;
    const Museum museum{allExhibits()};
    ComparisonRequest request = comparisonRequest(museum, command, options);
    ComparisonText text;
    text.names = namesOf(options.files);
    const std::size_t subject = museum.find(options.picture.subject).value_or(hallIndex);
    for (std::size_t i = 0; i < 2; ++i)
        text.presets[i] = pictureSettings(museum, subject, request.settings[i],
                                          {.frame = request.frame, .samples = request.samples[i]}, text.names[i]);
    text.gain = std::stoi(options.gain);
    text.machine = machineJson(context.info());
    render::gl::Renderer renderer;
    renderer.timeSteps(true);
    const StopSignal signal;
    Comparison comparison(museum, renderer, std::move(request));
    {
        ProgressLine line("comparing");
        while (comparison.step())
            if (!line.show(comparison.progress())) return StopSignal::exitCode;
    }
    writeComparisonFolder(options.picture.out, museum.subjects(), comparison, text);
    const ComparisonResult& result = comparison.result();
    for (const auto& [metric, error] : result.errors)
        std::printf("%-8s %.6g\n", std::string(toString(metric)).c_str(), error);
    std::printf("%zu %s; a frame of A takes %.2f ms, one of B %.2f ms.\n", result.rows.size(),
                result.rows.size() == 1 ? "parameter differs" : "parameters differ",
                result.sides[0].report.milliseconds, result.sides[1].report.milliseconds);
    std::printf("The comparison is in %s/index.html\n", options.picture.out.c_str());
    return 0;
}

}  // namespace

void addCompareSettingsCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand(
        "compare-settings", "Compare two settings on one page: pictures, differences, costs pass by pass");
    auto options = std::make_shared<SettingsOptions>();
    options->picture.subject = "hall";
    options->picture.size = usualPictureSize;
    const std::string what = "A preset, an exhibition, a picture that carries one, or \"initial\"";
    command->add_option("a", options->files[0], what + "; an exhibit's name for its initial values")->required();
    command->add_option("b", options->files[1], what);
    command->add_option("--with", options->with,
                        "Name of a comparison that the exhibit of A offers (see `list --json`), in place of B");
    command->add_option("--out", options->picture.out, "Output folder for the page")->required();
    command->add_option("--exhibit", options->picture.subject, "Exhibit whose presets can be given by name as A and B");
    command->add_option("--size", options->picture.size, "Width x height in pixels")->capture_default_str();
    addNumber(*command, "--samples", options->picture.samples, {1, 4096},
              "Samples per pixel. Default: the supersamples of a setting that changes them, else 4");
    addNumber(*command, "--runs", options->runs, {1, 99}, "Number of timed frames per setting")->capture_default_str();
    std::vector<std::string> gains;
    for (const int gain : comparisonGains) gains.push_back(std::to_string(gain));
    addChoice(*command, "--gain", options->gain, gains, "Initial gain of the difference pictures")
        ->capture_default_str();
    addCameraOptions(*command, options->picture);
    command->callback(
        [&chosen, options, command] { chosen = [options, command] { return compareSettings(*command, *options); }; });
}

}  // namespace vitrine::app
