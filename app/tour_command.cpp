#include "app/kit/command.h"
#include "app/kit/number_option.h"
#include "app/kit/picture_options.h"

#include "exhibits/exhibits.h"
#include "exhibits/jobs/kit/part_folder.h"
#include "exhibits/museum/picture_settings.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "render/image/image_io.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace vitrine::app {
namespace {

int renderTour(const std::string& folder, const std::string& size, int samples)
{
    const render::gl::HeadlessContext context;
    const Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    jobs::makeFolders(folder, folder);
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
