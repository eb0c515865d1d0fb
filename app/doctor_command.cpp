#include "app/kit/command.h"
#include "app/kit/findings.h"
#include "app/kit/number_option.h"
#include "app/kit/useless_option.h"
#include "app/stability_report.h"

#include "render/failure.h"
#include "render/files/assets.h"
#include "render/files/manual.h"
#include "render/files/strict_json.h"
#include "render/gl/context.h"
#include "render/gl/frame_clock.h"
#include "render/image/oiio_codec.h"
#include "render/image/video_codec.h"
#include "render/library_versions.h"

#include <CLI/CLI.hpp>
#include <qcustomplot.h>

#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

using render::Json;

Json libraries()
{
    Json versions(render::libraryVersions());
    versions["Qt"] = qVersion();
    versions["QCustomPlot"] = QCUSTOMPLOT_VERSION_STR;
    versions["CLI11"] = CLI11_VERSION;
    versions["OpenImageIO"] = render::oiioCodec().libraryVersion();
    versions["libavcodec"] = render::videoCodec().libraryVersion();
    return versions;
}

Json examine()
{
    Json report = newDocument("vitrine-doctor");
    try {
        const render::gl::HeadlessContext context;
        const render::gl::ContextInfo& gl = context.info();
        report["opengl"] = Json{{"renderer", gl.renderer}, {"vendor", gl.vendor},
                                {"version", gl.version},   {"shadingLanguage", gl.shadingLanguage},
                                {"software", gl.software}, {"usable", true}};
        if (gl.renderer.starts_with("zink") && gl.renderer.find("llvmpipe") != std::string::npos)
            report["opengl"]["caution"] = "zink over lavapipe, as in Mesa 22.3, ends programs that draw by SIGSEGV; "
                                          "draw with llvmpipe instead: unset GALLIUM_DRIVER";
        report["limits"] = Json{{"textureSize", gl.maxTextureSize},
                                {"samples", gl.maxSamples},
                                {"uniformBlockBytes", gl.maxUniformBlockSize}};
        const render::ClockChoice& clock = render::gl::trustedClock(gl.software);
        report["clock"] = Json{{"method", clock.name},
                               {"trusted", clock.trusted},
                               {"why", clock.why},
                               {"overheadMs", 1e3 * clock.overheadSeconds}};
    } catch (const Failure& failure) {
        report["opengl"] = Json{{"usable", false}, {"why", failure.what()}};
    }
    report["libraries"] = libraries();
    try {
        report["assets"] = render::assetFolder().string();
        report["manual"] = render::manualFile().string();
    } catch (const Failure& failure) {
        report["assets"] = failure.what();
        report["manual"] = "";
    }
    return report;
}

void printText(const Json& value, const std::string& indent)
{
    for (const auto& [key, entry] : value.items()) {
        if (entry.is_object()) {
            std::printf("%s%s\n", indent.c_str(), key.c_str());
            printText(entry, indent + "  ");
        } else {
            std::printf("%s%-20s %s\n", indent.c_str(), key.c_str(),
                        entry.is_string() ? entry.get<std::string>().c_str() : entry.dump().c_str());
        }
    }
}

int doctor(bool asJson)
{
    const Json report = examine();
    if (asJson) {
        std::fputs(render::writeJson(report).c_str(), stdout);
    } else {
        Json shown = report;
        for (const char* key : {"format", "app"}) shown.erase(key);
        shown["version"] = report["app"];
        printText(shown, "");
    }
    return report["opengl"]["usable"].get<bool>() ? 0 : static_cast<int>(ErrorKind::openGl);
}

}  // namespace

void addDoctorCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command =
        parser.add_subcommand("doctor", "Print what this machine can do: OpenGL, limits, clock, libraries");
    struct Given {
        bool asJson = false;
        bool stability = false;
        StabilityOptions options;
    };
    auto given = std::make_shared<Given>();
    command->add_flag("--json", given->asJson, "Print the result as JSON");
    command->add_flag(
        "--stability", given->stability,
        "Run the numerically difficult cases on this machine's driver, and print which pass and which fail");
    addNumber(*command, "--presets", given->options.presets, {1, 1e6},
              "Largest number of random settings per exhibit, with --stability")
        ->capture_default_str();
    addNumber(*command, "--minutes", given->options.minutes, {0.01, 1e5},
              "Longest time in minutes, with --stability; fewer settings are tried then")
        ->capture_default_str();
    addNumber(*command, "--first-seed", given->options.firstSeed, {0, 9007199254740992.0},
              "Seed of the first random setting, with --stability; a failure prints its seed")
        ->capture_default_str();
    command->callback([&chosen, given, command] {
        chosen = [given, command] {
            for (const char* option : {"--presets", "--first-seed", "--minutes"})
                refuseWithout(*command, option, given->stability, "--stability");
            given->options.asJson = given->asJson;
            return given->stability ? stabilityReport(given->options) : doctor(given->asJson);
        };
    });
}

}  // namespace vitrine::app
