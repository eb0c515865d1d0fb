#include "app/command.h"
#include "app/number_option.h"
#include "app/picture_options.h"
#include "app/progress.h"
#include "app/queue/parts.h"
#include "app/say.h"
#include "app/useless_option.h"

#include "exhibits/exhibits.h"
#include "exhibits/framework/preset.h"
#include "exhibits/recording/record.h"
#include "exhibits/recording/tour.h"
#include "render/failure.h"
#include "render/files/extension.h"
#include "render/files/number_text.h"
#include "render/files/read_file.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>

namespace vitrine::app {
namespace {

struct RecordOptions {
    PictureOptions picture;
    std::string subject;  ///< As typed: an exhibit, hall, or a tour's file.
    std::string path;     ///< Empty: a tour of the hall, round an exhibit.
    std::string pace;     ///< Empty: as the tour says; constant in a loop, else eased.
    double turn = 0;      ///< Degrees; 0: 360 alone, 60 in the hall.
    double seconds = 8, framesPerSecond = 30, shutter = 0;
    int shutterSamples = 8;
    PartOptions part;
};

Pace paceOf(const RecordOptions& options, Pace otherwise)
{
    return options.pace.empty() ? otherwise : options.pace == "eased" ? Pace::eased : Pace::constant;
}

/// Round what the view looks at: once round in a loop, or to and fro about the view.
void turnRound(const RecordOptions& options, const Museum& museum, const SceneState& sceneState,
               RecordingRequest& request)
{
    const FrameRequest& frame = request.picture.frame;
    const double degrees = options.turn != 0 ? options.turn : frame.alone ? 360 : 60;
    const double angle = degrees * std::numbers::pi / 180;
    request.closed = isWholeTurns(angle);
    request.camera = turntable(frame.camera, angle, paceOf(options, request.closed ? Pace::constant : Pace::eased));
    if (frame.alone) return;
    const double hit = firstCollision(museum.obstacles(sceneState), request.camera);
    if (hit >= 0)
        throw Failure(Blame::usage,
                      "A camera that turns by " + render::shortestNumber(degrees) + " degrees round " +
                          options.subject +
                          " runs into a wall or what stands in the hall; give a smaller --turn, or --alone.");
}

/// Along a tour, at its own pace or the one asked for.
void follow(const RecordOptions& options, const Obstacles& obstacles, const Tour& tour, RecordingRequest& request)
{
    request.closed = tour.closed;
    request.camera = [path = tourPath(obstacles, tour), pace = paceOf(options, tour.pace)](double part) {
        return path.at(paced(pace, part));
    };
}

bool isTourFile(const RecordOptions& options)
{
    return render::lowerExtension(options.subject) == ".json";
}

/// "turntable", "still" or "tour".
std::string pathOf(const RecordOptions& options)
{
    if (!options.path.empty()) return options.path;
    return isTourFile(options) || options.subject == "hall" ? "tour" : "turntable";
}

void refuseUselessOptions(const CLI::App& command, const RecordOptions& o)
{
    const std::string path = pathOf(o);
    for (const char* option : {"--path", "--turn", "--eye", "--target", "--fov"})
        refuseOn(command, option, isTourFile(o), "a tour's file, which says how the camera moves");
    refuseWithout(command, "--turn", path == "turntable", "--path turntable");
    for (const char* option : {"--eye", "--target", "--fov"})
        refuseWithout(command, option, path != "tour", "--path still");
    refuseOn(command, "--pace", path == "still", "a camera that stands still");
    refuseWithout(command, "--shutter-samples", o.shutter > 0, "--shutter");
    PictureOptions picture = o.picture;
    picture.subject = isTourFile(o) ? "hall" : o.subject;
    refuseUselessSceneOptions(command, picture);
}

RecordingRequest recordingRequest(const RecordOptions& options, const Museum& museum, RequestedPicture& job)
{
    RecordingRequest request;
    request.picture = job.request;
    request.seconds = options.seconds;
    request.framesPerSecond = options.framesPerSecond;
    request.shutter = options.shutter;
    request.shutterSamples = options.shutterSamples;
    const bool isHall = job.subject == hallIndex;
    const std::string path = pathOf(options);
    if (isTourFile(options)) {
        Tour tour = parseTour(render::readFile(options.subject, presetLimits.bytes), options.subject);
        for (const std::string& note : tour.notes) job.notes.push_back(options.subject + ": " + note);
        follow(options, museum.obstacles(job.sceneState), tour, request);
    } else if (path == "still") {
        request.camera = [camera = job.request.frame.camera](double) { return camera; };
        request.closed = true;
    } else if (path == "turntable") {
        turnRound(options, museum, job.sceneState, request);
    } else if (isHall) {
        follow(options, museum.obstacles(job.sceneState), museumTour(museum, job.sceneState), request);
    } else {
        throw Failure(Blame::usage,
                      "--path tour: the tour goes through the hall; record hall, or choose turntable or still.");
    }
    return request;
}

/// The frames of a video that is made in parts.
constexpr const char* framesOfParts = "%06d.png";

struct Drawn {
    std::string renderer;
    int frames = 0;  ///< Of the whole recording.
};

/// Draws what was asked for into `out`, or the share of it that `share` says; nothing when it was stopped.
std::optional<Drawn> draw(const RecordOptions& options, const std::string& out, const RecordingShare& share)
{
    PictureOptions picture = options.picture;
    picture.subject = isTourFile(options) ? "hall" : options.subject;
    RecordingRequest early;  // What cannot be written is refused before anything is read.
    early.picture.frame.raster.size = parseSize("--size", picture.size);
    early.picture.frame.transparent = picture.transparent;
    early.framesPerSecond = options.framesPerSecond;
    requireRecordable(early, picture.out);
    const bool isVideo = render::lowerExtension(out) != ".png";
    const render::gl::HeadlessContext context;
    const Museum museum{allExhibits()};
    PictureOptions described = picture;
    described.out.clear();  // Its ending is none of a picture.
    RequestedPicture job = requestedPicture(museum, described);
    if (job.request.frame.transparent && !picture.transparent) {
        job.request.frame.transparent = false;
        job.request.frame.cutOut.reset();
        job.notes.push_back(picture.preset + ": this picture is transparent; give --transparent for a recording "
                                             "that is, too.");
    }
    const RecordingRequest request = recordingRequest(options, museum, job);
    for (const std::string& note : job.notes) say(note);
    render::gl::Renderer renderer;
    const StopSignal signal;
    Recording recording(museum, renderer, job.sceneState, job.subject, request, out, share);
    {
        ProgressLine line("recording");
        line.estimate();
        while (line.show(recording.progress()) && recording.step()) {
        }
    }
    if (!recording.finished()) {
        say(isVideo ? "Stopped; nothing was written."
                    : "Stopped; the frames so far are whole, and the same command goes on with the next one.");
        return std::nullopt;
    }
    std::printf("%s: %d frames of %d x %d", out.c_str(), recording.drawn() + recording.kept(),
                request.picture.frame.raster.size.x, request.picture.frame.raster.size.y);
    if (recording.kept() > 0) std::printf(", %d of them kept", recording.kept());
    std::printf("\n");
    return Drawn{context.info().renderer, request.frames()};
}

int makePart(const RecordOptions& options)
{
    const std::string& out = options.picture.out;
    const Shard shard = parseShard(options.part.shard);
    const RecordingShare share{[shard](int k) { return shard.makes(static_cast<std::size_t>(k)); }, {}};
    if (render::lowerExtension(out) == ".png")
        return draw(options, out, share) ? 0 : StopSignal::exitCode;  // The frames are all that there is to make.
    return runPart(out, shard, [&](Parts& parts) -> std::optional<std::string> {
        const std::string frames = parts.file(framesOfParts);
        const std::optional<Drawn> drawn = draw(options, frames, share);
        if (!drawn) return std::nullopt;
        for (int k = 0; k < drawn->frames; ++k)
            if (share.draws(k)) parts.wrote(framePath(frames, k).filename());
        return drawn->renderer;
    });
}

int makeRecording(const RecordOptions& options)
{
    if (!options.part.shard.empty()) return makePart(options);
    RecordingShare share;
    if (options.part.fromParts) share.from = Parts{std::filesystem::path(options.picture.out)}.file(framesOfParts);
    return draw(options, options.picture.out, share) ? 0 : StopSignal::exitCode;
}

void addMotionOptions(CLI::App& command, RecordOptions& o)
{
    addNumber(command, "--seconds", o.seconds, {0.001, 36000, Unit::second}, "How long it is")->capture_default_str();
    addNumber(command, "--fps", o.framesPerSecond, {0.1, 240, Unit::hertz}, "Frames a second")->capture_default_str();
    command.add_option("--size", o.picture.size, "Width x height in pixels")->capture_default_str();
    addChoice(command, "--path", o.path, {"turntable", "still", "tour"},
              "How the camera moves: turntable (of an exhibit, when nothing is said), still, or tour (of the hall)");
    addNumber(command, "--turn", o.turn, {-36000, 36000, Unit::degree},
              "Degrees of the turntable; without it 360 alone, and 60 in the hall");
    addChoice(command, "--pace", o.pace, {"constant", "eased"},
              "constant or eased; without it as the tour says, or constant in a loop, else eased");
    addNumber(command, "--shutter", o.shutter, {0, 1},
              "Motion blur: the share of a frame's time for which it is exposed; 0: none")
        ->capture_default_str();
    addNumber(command, "--shutter-samples", o.shutterSamples, {1, 4096}, "Motion-blur samples per frame")
        ->capture_default_str();
}

}  // namespace

void addRecordCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand(
        "record", "Record a film: round an exhibit, through the hall, or along the bookmarks of a tour");
    auto options = std::make_shared<RecordOptions>();
    options->picture.size = "1280x720";
    command->add_option("subject", options->subject, "An exhibit's name, hall, or a tour's file (.json)")->required();
    command
        ->add_option("--out", options->picture.out,
                     "The film: .mp4, .webm, .gif, .webp or .apng (both lossless), or frames/%04d.png, of which those "
                     "that are there are kept")
        ->required();
    addMotionOptions(*command, *options);
    addSceneOptions(*command, options->picture);
    addPartOptions(*command, options->part);
    command->callback([&chosen, options, command] {
        chosen = [options, command] {
            refuseUselessOptions(*command, *options);
            return makeRecording(*options);
        };
    });
}

}  // namespace vitrine::app
