#include "app/command.h"
#include "app/number_option.h"
#include "app/picture_options.h"
#include "app/say.h"
#include "app/useless_option.h"
#include "exhibits/exhibits.h"
#include "exhibits/museum/museum.h"
#include "exhibits/sprites/sprite_files.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::app {
namespace {

struct SpriteOptions {
    std::string subject, out, size = "64x64", animation, preset, palette = "own", dither = "none", pivot = "origin",
                              motion = "automatic";
    std::vector<std::string> sets;
    int directions = 8, frames = 1, colors = 32;
    bool trimmed = false, noMaps = false;
    double fps = 12;
};

ParameterValues lookOf(const Museum& museum, const SpriteOptions& options)
{
    PictureOptions picture;
    picture.subject = spriteLookName;
    picture.preset = options.preset;
    picture.settingsOnly = true;
    picture.sets = options.sets;
    const RequestedPicture job = requestedPicture(museum, picture);
    for (const std::string& note : job.notes) say(note);
    return job.sceneState.values[museum.find(spriteLookName).value()];
}

void choose(ParameterValues& values, std::size_t row, const char* flag, const std::string& name)
{
    const ParameterInfo& info = values.rows()[row];
    const std::optional<Value> value = optionValue(info, name);
    if (!value) throw Failure(Blame::usage, std::string(flag) + ' ' + name + ": give " + whatItTakes(info) + '.');
    values.setRow(row, *value);
}

/// Throws Failure (Blame::usage) for what no sheet can be made of.
ParameterValues sheetValues(const SpriteOptions& options)
{
    const SpriteTable& t = spriteTable();
    ParameterValues values = t.initial();
    const glm::ivec2 size = parseSize("--size", options.size);
    const double most = t.rows()[t.width.row].range.high;
    if (std::max(size.x, size.y) > most)
        throw Failure(Blame::usage, "--size " + options.size + ": a frame has at most " + render::shortestNumber(most) +
                                        " pixels on a side.");
    if (options.subject != spriteLookName) values.set(t.model, options.subject);
    values.set(t.directions, options.directions);
    values.set(t.frames, options.frames);
    values.set(t.framesPerSecond, options.fps);
    values.set(t.width, size.x);
    values.set(t.height, size.y);
    values.set(t.colors, options.colors);
    choose(values, t.palette.row, "--palette", options.palette);
    choose(values, t.dither.row, "--dither", options.dither);
    choose(values, t.pivot.row, "--pivot", options.pivot);
    choose(values, t.motion.row, "--motion", options.motion);
    values.set(t.trimmed, options.trimmed);
    values.set(t.normals, !options.noMaps);
    values.set(t.depth, !options.noMaps);
    if (const std::string why = whyNoSheet(values); !why.empty()) throw Failure(Blame::usage, why);
    return values;
}

int makeSprite(const SpriteOptions& options)
{
    if (pictureFormat("--out", options.out, false) != render::PictureFormat::png8)
        throw Failure(Blame::usage, "--out " + options.out + ": sprite sheets are PNG files; give a name with .png.");
    const ParameterValues values = sheetValues(options);
    const std::shared_ptr<const SpriteSubject> subject = spriteSubject(values);
    for (const std::string& warning : subject->warnings()) say(warning);
    const render::gl::HeadlessContext context;
    const Museum museum{allExhibits()};
    render::gl::Renderer renderer;
    const SpriteRequest request = spriteRequest(values, options.animation);
    const ParameterValues look = lookOf(museum, options);
    const std::vector<SpriteFrame> frames = drawSprite(look, *subject, request, renderer);
    SpriteSheet sheet =
        sheetOf(frames, values, options.animation, *subject, std::filesystem::path(options.out).filename().string());
    sheet.settings = lookPreset(look);
    writeSheet(sheet, values, options.out);
    for (const std::string& warning : sheet.warnings) std::fprintf(stderr, "vitrine: %s\n", warning.c_str());
    std::printf("%s: %zu frames of %d x %d, %zu colors, %d x %d pixels\n", options.out.c_str(), frames.size(),
                request.size.x, request.size.y, sheet.palette.size(), sheet.color.width, sheet.color.height);
    return 0;
}

}  // namespace

void addSpriteCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand(
        "sprite",
        "Draw an object from all sides as a sheet of sprites, with normals, depth and Aseprite's JSON beside it");
    auto o = std::make_shared<SpriteOptions>();
    command->add_option("object", o->subject, "pixel_art, or a glTF file (.glb, .gltf), whose animation is played")
        ->required();
    command->add_option("--out", o->out, "The sheet: .png; further files take its name")->required();
    addNumber(*command, "--directions", o->directions, {1, 64},
              "Number of view directions, evenly spaced around the object")
        ->capture_default_str();
    addNumber(*command, "--frames", o->frames, {1, 256},
              "Number of frames per direction, evenly spaced over the animation")
        ->capture_default_str();
    command->add_option("--size", o->size, "Of a frame, pixels")->capture_default_str();
    command->add_option("--animation", o->animation, "By its name; the file's first one otherwise");
    addNumber(*command, "--fps", o->fps, {0, 1000, Unit::hertz},
              "Frames a second that the description tells; 0: as long as the animation")
        ->capture_default_str();
    command->add_option("--palette", o->palette, "own (made of all frames), or a shipped palette's name")
        ->capture_default_str();
    addNumber(*command, "--colors", o->colors, {1, 256}, "Number of colors of its own palette")->capture_default_str();
    command->add_option("--dither", o->dither, "none, ordered, blue noise, or error diffusion")->capture_default_str();
    command->add_option("--pivot", o->pivot, "That the description gives: origin, center, or bottom")
        ->capture_default_str();
    command->add_option("--motion", o->motion, "What the animation carries the object by: kept, in place, or automatic")
        ->capture_default_str();
    command->add_option("--preset", o->preset, "A look of pixel_art");
    command->add_option("--set", o->sets, "name=value of pixel_art");
    command->add_flag("--trim", o->trimmed, "Cut off empty rows and columns");
    command->add_flag("--no-maps", o->noMaps, "Neither normals nor depth");
    command->callback([&chosen, o, command] {
        chosen = [o, command] {
            refuseWithout(*command, "--colors", o->palette == "own", "--palette own");
            refuseOn(*command, "--animation", o->subject == spriteLookName, "pixel_art, which has one animation");
            return makeSprite(*o);
        };
    });
}

}  // namespace vitrine::app
