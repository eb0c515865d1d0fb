#include "app/kit/command.h"
#include "app/kit/number_option.h"
#include "app/kit/picture_options.h"
#include "app/kit/report.h"
#include "app/kit/say.h"
#include "app/kit/useless_option.h"

#include "exhibits/exhibits.h"
#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "render/image/image_io.h"
#include "render/plan/diagnostics.h"
#include "render/text/translation.h"
#include "ui/kit/language.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

namespace vitrine::app {
namespace {

struct RenderOptions {
    PictureOptions picture;
    std::string report;
    bool sixteenBit = false;
};

int renderPicture(const RenderOptions& options)
{
    const render::PictureFormat format = pictureFormat("--out", options.picture.out, options.sixteenBit);
    const render::gl::HeadlessContext context;
    const Museum museum{allExhibits()};
    const RequestedPicture job = requestedPicture(museum, options.picture);
    for (const std::string& note : job.notes) say(note);
    if (job.taken && job.taken->language != language() && !ui::languageAsked())
        ui::setLanguage(QString::fromStdString(job.taken->language));
    render::gl::Renderer renderer;
    PictureMaker maker(museum, renderer, job.sceneState, job.request);
    while (maker.step()) {
    }
    for (const render::CulledPass& complaint : render::Diagnostics().begun(maker.report().skipped))
        say(lineOf(complaint));
    std::vector<std::unique_ptr<render::PartFile>> files;
    files.push_back(render::stagedPicture(
        options.picture.out, maker.picture(), format,
        {.preset = pictureSettings(museum, job.subject, job.sceneState, job.request, "Picture")}));
    if (!options.report.empty())
        files.push_back(render::stagedFile(
            options.report, render::writeJson(pictureReport(museum, renderer, context.info(), job, maker.report()))));
    render::publishAll(files);
    return 0;
}

int renderTour(const std::string& folder, const std::string& size, int samples)
{
    const render::gl::HeadlessContext context;
    const Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw Failure(ErrorKind::file,
                      folder + ": the folder cannot be made (" + error.message() + "); choose another with --out.");
    for (const SceneObject* subject : museum.subjects()) {
        PictureOptions options;
        options.subject = subject->name();
        options.size = size;
        options.samples = samples;
        options.out = (std::filesystem::path(folder) / (options.subject + ".png")).string();
        const RequestedPicture job = requestedPicture(museum, options);
        PictureMaker maker(museum, renderer, job.sceneState, job.request);
        while (maker.step()) {
        }
        render::writePicture(options.out, maker.picture(), render::PictureFormat::png8,
                             {.preset = pictureSettings(museum, job.subject, job.sceneState, job.request, "Picture")});
        std::printf("%s\n", options.out.c_str());
    }
    std::printf("The tour is in %s\n", std::filesystem::absolute(folder).string().c_str());
    return 0;
}

}  // namespace

void addRenderCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand(
        "render", "Render an exhibit at its place in the hall, or the hall, to a file; needs no display");
    auto options = std::make_shared<RenderOptions>();
    command->add_option("exhibit", options->picture.subject, "Name of an exhibit, or hall")->required();
    command
        ->add_option("--out", options->picture.out,
                     "Output picture: " + render::writtenExtensions() + "; OpenEXR holds linear light")
        ->required();
    command->add_flag("--sixteen-bit", options->sixteenBit,
                      "Write 16 bits per channel: integers in PNG and TIFF, half floats for the color in OpenEXR");
    command->add_option("--report", options->report,
                        "File for the frame report as JSON: passes that ran, passes that were skipped and why, "
                        "counters, times, memory by owner");
    addPictureOptions(*command, options->picture);
    command->callback([&chosen, options, command] {
        chosen = [options, command] {
            refuseUselessSceneOptions(*command, options->picture);
            return renderPicture(*options);
        };
    });
}

void addTourCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command =
        parser.add_subcommand("tour", "Render one picture of the hall and of every exhibit into a folder");
    auto folder = std::make_shared<std::string>("vitrine-tour");
    auto size = std::make_shared<std::string>("1280x720");
    auto samples = std::make_shared<int>(9);
    command->add_option("--out", *folder, "Output folder")->capture_default_str();
    command->add_option("--size", *size, "Width x height in pixels")->capture_default_str();
    addNumber(*command, "--samples", *samples, {1, 4096}, "Samples per pixel")->capture_default_str();
    command->callback([&chosen, folder, size, samples] {
        chosen = [folder, size, samples] { return renderTour(*folder, *size, *samples); };
    });
}

}  // namespace vitrine::app
