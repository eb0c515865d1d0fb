// Shaders that are exported show the same picture: read back by this program, and on a page in Chromium.

#include "exhibits/shader_export/block_layout.h"
#include "exhibits/shader_export/code_rewriter.h"
#include "exhibits/shader_export/exported_shader.h"
#include "exhibits/shader_export/scene_shader.h"
#include "exhibits/your_shader/your_shader_table.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"
#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "tests/exhibits/your_shader/shaders.h"
#include "tests/support/gallery.h"
#include "tests/support/image_bytes.h"
#include "tests/support/made_image.h"
#include "tests/support/temporary_folder.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine {
namespace {

using namespace test;
using guest::ExportForm;

namespace fs = std::filesystem;

const fs::path sources = fs::path(VITRINE_SOURCE_DIR) / "tests/exhibits/your_shader/shadertoy";

/// An exhibit alone, or a shader on the screen of "your_shader".
class ExportShot {
public:
    explicit ExportShot(const char* exhibit = "your_shader", int width = 96, int height = 64) : shot(exhibit)
    {
        shot.request.frame.averageIn = AverageIn::display;
        shot.request.frame.transparent = false;
        shot.request.samples = 1;
        const auto glare = shot.hall().table().find("glare");
        shot.hall().setParameter(*glare, 0.0);  // Halos are the hall's, and no part of an exported shader.
        shot.size(width, height);
    }
    explicit ExportShot(const fs::path& shader) : ExportShot()
    {
        set("file", shader.string());
        read();
    }
    void set(const char* name, const Value& value)
    {
        const auto row = shot.values().table().find(name);
        ASSERT_TRUE(row) << name;
        shot.values().setParameter(*row, value);
    }
    void read()
    {
        TabledSceneState tabled = gallery().museum.readTables(shot.sceneState);
        shot.sceneState = std::move(tabled.sceneState);
        for (const Message& why : tabled.unreadable) ADD_FAILURE() << why.english();
        shot.request.frame.camera = gallery().museum.subject(shot.exhibit).bestView(shot.values());
    }
    [[nodiscard]] guest::ExportedShader exported() const
    {
        return guest::sceneShader(gallery().museum, shot.sceneState, shot.exhibit, shot.request.frame);
    }
    /// Exports into the folder, and returns the notes.
    std::string exportTo(const fs::path& out, ExportForm form) const
    {
        guest::ExportedShader shader = exported();
        shader.start.size = shot.request.frame.raster.size;
        shader.start.runs = false;
        const guest::ExportedFiles files = exportedFiles(shader, form, out);
        render::atomicWriteAll(files.files);
        std::string notes;
        for (const Message& note : files.notes) notes += note.english() + '\n';
        return notes;
    }

    Shot shot;
};

struct Difference {
    double largest = 0, rmse = 0;  // In display values from 0 to 255.
};

Difference between(const render::Image& a, const render::Image& b)
{
    Difference difference;
    if (a.width != b.width || a.height != b.height) return {255, 255};
    double sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const auto code = [&](const render::Image& image) {
                    return std::lround(255 * render::srgbFromLinear(image.at(x, y, c)));
                };
                const double d = std::abs(static_cast<double>(code(a) - code(b)));
                difference.largest = std::max(difference.largest, d);
                sum += d * d;
            }
    difference.rmse = std::sqrt(sum / (3.0 * a.width * a.height));
    return difference;
}

/// Returns how far the picture of the exported shader is from the original's, at the same moment.
Difference readBack(const ExportShot& original, const fs::path& out, ExportForm form, double moment)
{
    original.exportTo(out, form);
    ExportShot again(out);
    again.set("moment", moment);
    again.set("rate", original.exported().start.rate);
    return between(original.shot.take().image, again.shot.take().image);
}

class ShaderExports : public GlTest {
protected:
    TemporaryFolder folder;
};

/// Works that are shipped: their programs take a minute to compile.
class LongShaderExports : public ShaderExports {};

TEST_F(LongShaderExports, OfShippedWorksShowTheSamePictures)
{
    for (const char* name :
         {"gyroid.frag", "dunes.frag", "rose_window.glsl", "agate.glsl", "circle_limit.fs", "ink.fs"}) {
        ExportShot original{fs::path(name)};
        original.set("moment", 0.5);
        EXPECT_EQ(readBack(original, folder / "exported.fs", ExportForm::isf, 0.5).largest, 0) << name;
    }
    for (const char* name : {"gyroid.frag", "rose_window.glsl", "agate.glsl", "circle_limit.fs"}) {
        ExportShot original{fs::path(name)};
        original.set("moment", 1.5);
        EXPECT_LE(readBack(original, folder / "exported.glsl", ExportForm::shadertoy, 1.5).largest, 1) << name;
    }
}

TEST_F(LongShaderExports, AsIsfShowTheSamePictures)
{
    // In each form, with several passes, feedback, pictures and the mouse.
    {
        ExportShot original{fs::path("ink.fs")};
        original.set("moment", 0.5);
        EXPECT_EQ(readBack(original, folder / "exported.fs", ExportForm::isf, 0.5).largest, 0);
    }
    const auto redRight = [](int x, int y, int c) { return static_cast<float>(c == 0 ? x : c == 1 ? y : 0); };
    fs::copy(sources, folder / "shadertoy", fs::copy_options::recursive);
    render::writePicture(folder / "shadertoy" / "four.png", made(2, 2, redRight), render::PictureFormat::png8);
    for (const char* name : {"buffers.json", "common.json", "feedback.json", "frame.glsl", "image.glsl", "include.glsl",
                             "mouse.glsl", "sliders.glsl", "time_delta.glsl", "earlier_buffer.json"}) {
        ExportShot original{folder / "shadertoy" / name};
        original.set("moment", 0.2);
        original.set("mouseX", 0.25);
        original.set("mouseDown", 1.0);
        EXPECT_EQ(readBack(original, folder / "exported.fs", ExportForm::isf, 0.2).largest, 0) << name;
    }
}

TEST_F(ShaderExports, AsShadertoyShowTheSamePictures)
{
    {
        ExportShot original{fs::path("circle_limit.fs")};
        original.set("moment", 1.5);
        EXPECT_LE(readBack(original, folder / "exported.glsl", ExportForm::shadertoy, 1.5).largest, 1);
    }
    for (const char* name : {"buffers.json", "common.json", "feedback.json", "earlier_buffer.json", "cube_buffer.json",
                             "cube_map.json", "volume.json", "keyboard.json"}) {
        ExportShot original{sources / name};
        original.set("moment", 0.2);
        EXPECT_EQ(readBack(original, folder / "exported.json", ExportForm::shadertoyJson, 0.2).largest, 0) << name;
    }
}

TEST_F(ShaderExports, BeginWithThePresentValues)
{
    writeBytes(folder / "own.frag",
               "uniform float u_gain; // 0 .. 10, default 2, exact 9, m, \"Gain of \\ all\"\n"
               "uniform vec3 u_tint; // color\nuniform vec3 u_shift; // 0 .. 4, default 1\n"
               "#define STEPS 3 // 1 .. 20, default 3\nuniform bool u_on;\n"
               "out vec4 color;\nvoid main() { color = vec4(u_tint * u_gain / 10.0, 1.0);\n"
               "for (int i = 0; i < STEPS; ++i) color.rgb += u_shift / 255.0; if (u_on) color.g = 1.0; }");
    ExportShot original{folder / "own.frag"};
    original.set("uGain", 5.0);
    original.set("uTint", glm::dvec3(0.2, 0.5, 0.8));
    original.set("uShiftY", 2.5);
    original.set("steps", 7.0);
    for (const auto& [form, name] : {std::pair(ExportForm::isf, "a.fs"), std::pair(ExportForm::shadertoy, "a.glsl")}) {
        EXPECT_LE(readBack(original, folder / name, form, 0).largest, 1) << name;
        ExportShot again{folder / name};
        const auto& table = again.shot.values().table();
        const ParameterInfo& gain = table.rows()[*table.find("uGain")];
        EXPECT_EQ(std::get<double>(gain.initial), 5) << name;
        EXPECT_EQ(gain.range, (Range{0, 10})) << name;
        EXPECT_EQ(gain.qualityReference, 9) << name;
        EXPECT_EQ(gain.unit, Unit::meter) << name;
        EXPECT_EQ(gain.label, "Gain of \\ all") << name;
        EXPECT_EQ(std::get<double>(table.rows()[*table.find("uShiftY")].initial), 2.5) << name;
        EXPECT_EQ(std::get<double>(table.rows()[*table.find("steps")].initial), 7) << name;
    }
}

TEST_F(ShaderExports, SayWhatAFormCannotHold)
{
    const auto refusal = [&](const fs::path& shader, ExportForm form) {
        try {
            ExportShot(shader).exportTo(folder / "x.html", form);
        } catch (const Failure& failure) {
            return std::string(failure.what());
        }
        return std::string("exported");
    };
    EXPECT_EQ(
        refusal("ink.fs", ExportForm::shadertoy),
        "The shader has 2 passes, and Shadertoy's code has one; give --out a name that ends in .json, .fs or .html.");
    writeBytes(folder / "filter.fs", isf(R"("INPUTS": [{"NAME": "inputImage", "TYPE": "image"}])",
                                         "gl_FragColor = IMG_THIS_PIXEL(inputImage);"));
    EXPECT_EQ(refusal(folder / "filter.fs", ExportForm::shadertoy),
              "“inputImage” has no picture file; choose one with --set inputImage=FILE.");
    EXPECT_EQ(ExportShot(folder / "filter.fs").exportTo(folder / "filter.html", ExportForm::web),
              "“inputImage” has no picture file: the page begins with a test picture.\n");
    for (const char* name : {"cube_buffer.json", "cube_map.json", "volume.json", "keyboard.json"}) {
        EXPECT_EQ(refusal(sources / name, ExportForm::web).substr(0, 14), "A page has no ") << name;
        EXPECT_EQ(refusal(sources / name, ExportForm::isf).substr(0, 30), "ISF has no channel of the kind") << name;
    }
    const auto exhibitRefusal = [](const char* name) {
        try {
            return static_cast<void>(ExportShot(name).exported()), std::string("exported");
        } catch (const Failure& failure) {
            return std::string(failure.what());
        }
    };
    EXPECT_EQ(exhibitRefusal("fur").substr(0, 42), "Fur with Physics cannot stand alone: its p");
}

TEST_F(ShaderExports, KeepNamesThatTheNewFormTakes)
{
    writeBytes(folder / "own.frag",
               "uniform vec2 u_resolution;\nfloat pictureColor = 0.25;\n"
               "float pictureMain(float x) { return x / u_resolution.x; }\n"
               "void main() { gl_FragColor = vec4(pictureColor, pictureMain(gl_FragCoord.x), 0.5, 1.0); }\n");
    ExportShot original{folder / "own.frag"};
    EXPECT_EQ(readBack(original, folder / "a.fs", ExportForm::isf, 0).largest, 0);
    EXPECT_EQ(readBack(original, folder / "a.glsl", ExportForm::shadertoy, 0).largest, 0);
}

/// Names of the choices of the noise, as indices.
enum class Work { field, fractal, sea, clouds };

ExportShot noiseShot(Work work, bool reference = false)
{
    ExportShot original("noise");
    original.set("work", static_cast<double>(work));
    original.set("look", reference ? 1.0 : 0.0);
    for (const char* baked : {"fieldNoise", "cloudNoise", "jitter"}) original.set(baked, 0.0);
    original.read();
    return original;
}

TEST_F(LongShaderExports, OfNoiseShowTheSamePictures)
{
    // The error is that of float32: times and places are computed in other orders.
    for (const Work work : {Work::field, Work::fractal, Work::sea, Work::clouds})
        for (const bool reference : {false, true})
            for (const double later : {0.0, 7.0}) {
                if (work == Work::clouds && !reference && later == 0) continue;  // Takes long.
                ExportShot original = noiseShot(work, reference);
                if (work == Work::clouds) {
                    original.shot.size(48, 32);
                    // The loops of a pixel of an exported shader end after 65,536 iterations.
                    original.set("cloudSteps", 24.0);
                    original.set("lightSteps", 4.0);
                    // An exported shader marches a ray through every pixel.
                    original.set("cloudTolerance", 0.0);
                }
                original.set("moment", 20.0);
                original.exportTo(folder / "noise.fs", ExportForm::isf);
                original.set("moment", 20.0 + later);
                ExportShot again{folder / "noise.fs"};
                again.shot.size(original.shot.request.frame.raster.size.x, original.shot.request.frame.raster.size.y);
                again.set("moment", later);
                const Difference difference = between(original.shot.take().image, again.shot.take().image);
                EXPECT_LE(difference.rmse, 0.6) << static_cast<int>(work) << reference << later;
            }
    for (const double sun : {-0.06, 0.03, 1.2}) {
        ExportShot original = noiseShot(Work::sea);
        original.set("sunElevation", sun);
        EXPECT_LE(readBack(original, folder / "sea.fs", ExportForm::isf, 0).rmse, 0.6) << sun;
    }
    EXPECT_LE(readBack(noiseShot(Work::sea), folder / "sea.glsl", ExportForm::shadertoy, 0).rmse, 0.6);
}

TEST_F(LongShaderExports, OfNoiseHaveInputsThatActAsInTheExhibit)
{
    ExportShot original = noiseShot(Work::fractal);
    original.set("kind", 3.0);
    original.set("warp", 0.5);
    EXPECT_NE(original.exportTo(folder / "noise.fs", ExportForm::isf)
                  .find("Parameters from which further numbers are computed stay as they are now."),
              std::string::npos);
    ExportShot again{folder / "noise.fs"};
    const render::Image before = again.shot.take().image;
    for (ExportShot* each : {&original, &again}) {
        each->set("gain", 0.3);
        each->set("frequency", 1.4);
        each->set("albedo", glm::dvec3(0.2, 0.5, 0.7));
    }
    const render::Image after = again.shot.take().image;
    EXPECT_GT(between(before, after).rmse, 10);
    EXPECT_LE(between(original.shot.take().image, after).rmse, 0.6);
    const auto& row = [&](const char* name) -> const ParameterInfo& {
        return again.shot.values().rows()[*again.shot.values().table().find(name)];
    };
    EXPECT_EQ(row("boundShare").qualityReference, 1);
    EXPECT_EQ(row("threshold").label, "Threshold");
    EXPECT_EQ(row("octaveRotation").unit, Unit::degree);
    // The haze is also in the sky's table, so a slider for it would change only half of it.
    EXPECT_FALSE(again.shot.values().table().find("haze"));
    ExportShot sea = noiseShot(Work::sea);
    sea.exportTo(folder / "sea.fs", ExportForm::isf);
    ExportShot ofSea{folder / "sea.fs"};
    EXPECT_TRUE(ofSea.shot.values().table().find("chop"));
    EXPECT_FALSE(ofSea.shot.values().table().find("windSpeed"));
}

TEST_F(ShaderExports, OfNoiseSayWhichSettingKeepsThemFromStandingAlone)
{
    const auto refusal = [](Work work, const char* setting) {
        ExportShot shot = noiseShot(work);
        shot.set(setting, 1.0);
        try {
            return static_cast<void>(shot.exported()), std::string("exported");
        } catch (const Failure& failure) {
            return std::string(failure.what());
        }
    };
    EXPECT_EQ(refusal(Work::field, "fieldNoise"),
              "Noise cannot stand alone while “Field noise” is “baked”; choose “evaluated”.");
    EXPECT_EQ(refusal(Work::clouds, "cloudNoise"),
              "Noise cannot stand alone while “Cloud noise” is “baked”; choose “evaluated”.");
    EXPECT_EQ(refusal(Work::clouds, "jitter"), "Noise cannot stand alone while “Jitter” is “on”; choose “off”.");
    EXPECT_EQ(refusal(Work::sea, "fieldNoise"), "exported");
}

TEST_F(LongShaderExports, OfScenesShowTheSamePictures)
{
    struct Case {
        const char* scene;
        std::vector<std::pair<const char*, double>> settings;
        double largestRmse;
    };
    // The bounds of moving shapes are wider in the exported shader, so that rays begin elsewhere and hit within the
    // same tolerance at other points.
    for (const Case& each : {Case{"torus.json", {}, 0.6}, Case{"dahlia.json", {{"bloom", 0.4}, {"width", 1.3}}, 1.5},
                             Case{"shading.json", {}, 0.6}, Case{"rotunda.json", {}, 0.6}}) {
        ExportShot original("sdf_scenes");
        original.set("scene", std::string(each.scene));
        original.read();
        original.set("evaluation", 2.0);  // Every shape, as in the exported shader.
        for (const auto& [name, value] : each.settings) original.set(name, value);
        const Difference difference = readBack(original, folder / "scene.fs", ExportForm::isf, 0);
        EXPECT_LE(difference.rmse, each.largestRmse) << each.scene << ", largest " << difference.largest;
        // One scene for the other form: how a scene becomes code does not depend on the form, and compiling takes long.
        if (each.settings.empty()) continue;
        EXPECT_LE(readBack(original, folder / "scene.glsl", ExportForm::shadertoy, 0).rmse, each.largestRmse)
            << each.scene;
    }
}

TEST_F(LongShaderExports, OfScenesFollowTheirParameters)
{
    ExportShot original("sdf_scenes");
    original.set("scene", std::string("dahlia.json"));
    original.read();
    original.set("evaluation", 2.0);
    original.exportTo(folder / "dahlia.fs", ExportForm::isf);
    ExportShot again{folder / "dahlia.fs"};
    const render::Image before = again.shot.take().image;
    for (ExportShot* each : {&original, &again}) {
        each->set("bloom", 0.3);
        each->set("width", 1.4);
    }
    const render::Image after = again.shot.take().image;
    EXPECT_GT(between(before, after).rmse, 10);
    EXPECT_LE(between(original.shot.take().image, after).rmse, 1.5);
    again.set("orbit", 1.0);
    EXPECT_GT(between(after, again.shot.take().image).rmse, 10);
}

/// Returns how far an exported scene is from the original after the same change of parameters.
Difference afterChanges(const std::string& scene, const fs::path& out,
                        const std::vector<std::pair<const char*, double>>& changes)
{
    ExportShot original("sdf_scenes");
    original.set("scene", scene);
    original.read();
    original.set("evaluation", 2.0);
    original.exportTo(out, ExportForm::isf);
    ExportShot again{out};
    for (ExportShot* each : {&original, &again})
        for (const auto& [name, value] : changes) each->set(name, value);
    return between(original.shot.take().image, again.shot.take().image);
}

TEST_F(LongShaderExports, OfScenesAreBoundedAsTheOriginalsAfterChanges)
{
    // Rays that pass a box without end reach the step limit and widen silhouettes.
    for (const auto& changes : std::vector<std::vector<std::pair<const char*, double>>>{
             {{"melt", 0.05}}, {{"twist", -1.2}, {"columns", 9.0}}, {{"twist", 1.3}, {"melt", 0.2}}})
        EXPECT_LE(afterChanges("rotunda.json", folder / "rotunda.fs", changes).rmse, 0.6) << changes[0].first;
    // Rays begin at other points, so that they end at others within the tolerance: the finer it is, the less they
    // differ.
    const double coarse = afterChanges("dahlia.json", folder / "dahlia.fs", {{"lean", 0.0}}).rmse;
    const double fine = afterChanges("dahlia.json", folder / "dahlia.fs", {{"lean", 0.0}, {"hitTolerance", 0.1}}).rmse;
    EXPECT_LE(coarse, 6);
    EXPECT_LE(fine, 1.6);
}

TEST_F(LongShaderExports, OfScenesHaveAllCopiesAfterChanges)
{
    // The copy that is nearest depends on where the content of the first one lies.
    const auto scene = [&](const std::string& root) {
        writeBytes(
            folder / "copies.json",
            R"({"format": "vitrine-scene", "version": 1, "parameters": {"shift": {"value": 0, "range": [0, 3]}},)"
            R"("camera": {"position": [0.5, 6, 6]}, "root": {"kind": "union", "children": [)"
            R"({"kind": "box", "size": [0.2, 0.2, 0.2]}, )" +
                root + "]}}");
        return (folder / "copies.json").string();
    };
    const std::string ball = R"("child": {"kind": "sphere", "radius": 0.3, "translate": )";
    const std::string around = R"({"kind": "repeatAround", "count": 7, )" + ball + R"([1.2, 0, "shift"]}})";
    const std::string cells =
        R"({"kind": "repeat", "spacing": [0.8, 0, 0], "count": [4, 1, 1], )" + ball + R"(["shift - 1.5", 0, 0]}})";
    for (const std::string& root : {around, cells})
        for (const double shift : {0.0, 0.4, 1.7, 3.0})
            EXPECT_LE(afterChanges(scene(root), folder / "copies.fs", {{"shift", shift}}).rmse, 1) << root << shift;
}

/// A page in Chromium.
class LongShaderPages : public ShaderExports {
protected:
    void SetUp() override
    {
        ShaderExports::SetUp();
        if (std::system("command -v chromium >/dev/null 2>&1") != 0) GTEST_SKIP() << "Chromium is not installed.";
    }

    /// Result of a page.
    struct Shown {
        std::vector<render::Image> pictures;
        std::string console, problem;
    };
    /// Opens the page and runs lines of a script in it, which call take() for each picture.
    Shown open(const fs::path& page, const std::string& script)
    {
        std::string text = render::readFile(page, 1U << 26U);
        const std::string end = "</body>";
        text.insert(
            text.rfind(end),
            "<pre id=\"taken\"></pre><script>shaderPage.ready.then(() => { const taken = [];"
            "const take = (seconds) => { shaderPage.draw(seconds); taken.push(document.getElementById('picture')"
            ".toDataURL()); };\n" +
                script + "\ndocument.getElementById('taken').textContent = taken.join(' ') + ' end';});</script>");
        writeBytes(folder / "tested.html", text);
        const std::string dom = (folder / "dom.html").string(), log = (folder / "log.txt").string();
        const std::string command =
            "timeout 120 chromium --headless=new --no-sandbox --disable-gpu-sandbox --use-gl=angle "
            "--use-angle=gl-egl --ignore-gpu-blocklist --enable-logging=stderr "
            "--user-data-dir='" +
            (folder / "profile").string() + "' --virtual-time-budget=20000 --dump-dom 'file://" +
            (folder / "tested.html").string() + "' >'" + dom + "' 2>'" + log + "'";
        EXPECT_EQ(std::system(command.c_str()), 0);
        return shownIn(render::readFile(dom, 1U << 28U), render::readFile(log, 1U << 24U));
    }

    /// Exports a page, and returns the pictures that the script takes on it. Expects `count` of them, and no complaint.
    Shown shownBy(ExportShot& original, const std::string& script, std::size_t count)
    {
        original.exportTo(folder / "page.html", ExportForm::web);
        Shown shown = open(folder / "page.html", script);
        EXPECT_EQ(shown.console, "");
        EXPECT_EQ(shown.problem, "");
        EXPECT_EQ(shown.pictures.size(), count);
        shown.pictures.resize(count);
        return shown;
    }

private:
    Shown shownIn(const std::string& dom, const std::string& log)
    {
        Shown shown;
        std::istringstream lines(log);
        for (std::string line; std::getline(lines, line);)
            if (line.find("CONSOLE") != std::string::npos) shown.console += line + '\n';
        const std::string problem = "role=\"alert\">";
        const std::size_t at = dom.find(problem) + problem.size();
        shown.problem = dom.substr(at, dom.find('<', at) - at);
        const std::size_t taken = dom.find("<pre id=\"taken\">");
        std::istringstream words(
            taken == std::string::npos ? "" : dom.substr(taken + 16, dom.find("</pre>", taken) - taken - 16));
        for (std::string word; words >> word;) {
            if (!word.starts_with("data:image/png;base64,")) continue;
            writeBytes(folder / "shown.base64", word.substr(22));
            const std::string png = (folder / "shown.png").string();
            EXPECT_EQ(std::system(("base64 -d '" + (folder / "shown.base64").string() + "' >'" + png + "'").c_str()),
                      0);
            shown.pictures.push_back(render::readColor(png));
        }
        return shown;
    }
};

TEST_F(LongShaderPages, ShowThePicturesOfVisitorsShaders)
{
    struct Case {
        const char* file;
        double moment, largestRmse;
    };
    // Chromium draws by the same driver, through ANGLE, which compiles programs anew.
    for (const Case& each : {Case{"circle_limit.fs", 1, 1}, Case{"rose_window.glsl", 1, 1}, Case{"ink.fs", 0.5, 1},
                             Case{"gyroid.frag", 1, 1.5}, Case{"dunes.frag", 1, 2}}) {
        ExportShot original{fs::path(each.file)};
        original.set("moment", each.moment);
        SCOPED_TRACE(each.file);
        const Shown shown = shownBy(original, "take(" + std::to_string(each.moment) + ");", 1);
        const Difference difference = between(original.shot.take().image, shown.pictures[0]);
        EXPECT_LE(difference.rmse, each.largestRmse) << each.file << ", largest " << difference.largest;
    }
}

TEST_F(LongShaderPages, HaveControlsThatChangeThePicture)
{
    writeBytes(
        folder / "own.fs",
        isf(R"("INPUTS": [{"NAME": "gain", "TYPE": "float", "MIN": 0, "MAX": 100, "DEFAULT": 30},
        {"NAME": "isOn", "TYPE": "bool"}, {"NAME": "mode", "TYPE": "long", "VALUES": [10, 40], "LABELS": ["a", "b"]},
        {"NAME": "tint", "TYPE": "color", "DEFAULT": [0.2, 0.4, 0.6, 1]}, {"NAME": "picture", "TYPE": "image"},
        {"NAME": "center", "TYPE": "point2D", "MIN": [0, 0], "MAX": [50, 50], "DEFAULT": [3, 4]},
        {"NAME": "flash", "TYPE": "event"}])",
            "vec3 a = vec3(gain, isOn ? 200.0 : 0.0, float(mode)) / 255.0;\n"
            "vec3 b = vec3(center, flash ? 99.0 : 1.0) / 255.0;\n"
            "gl_FragColor = vec4(gl_FragCoord.x < 24.0 ? a : gl_FragCoord.x < 48.0 ? b : gl_FragCoord.x < 72.0 ? "
            "tint.rgb : IMG_THIS_PIXEL(picture).rgb, 1.0);"));
    ExportShot original{folder / "own.fs"};
    const Shown shown =
        shownBy(original,
                "take(0); const change = (kind, value) => { const all = document.querySelectorAll(kind);"
                "for (const each of all) { each[value[0]] = value[1]; each.dispatchEvent(new Event('input')); } };"
                "change('input[type=range]', ['value', 40]); change('input[type=checkbox]', ['checked', true]);"
                "change('select', ['value', '40']); change('input[type=color]', ['value', '#ff8000']);"
                "document.querySelector('form button').click(); take(0); take(0);",
                3);
    EXPECT_LE(between(original.shot.take().image, shown.pictures[0]).largest, 2);
    if (HasFailure()) return;  // A picture may be missing.
    const auto codes = [&](std::size_t picture, int x) {
        std::vector<long> all;
        for (int c = 0; c < 3; ++c)
            all.push_back(std::lround(255 * render::srgbFromLinear(shown.pictures[picture].at(x, 5, c))));
        return all;
    };
    EXPECT_EQ(codes(0, 4), (std::vector<long>{30, 0, 10}));
    EXPECT_EQ(codes(1, 4), (std::vector<long>{40, 200, 40}));
    EXPECT_EQ(codes(1, 30), (std::vector<long>{40, 40, 99}));
    EXPECT_EQ(codes(2, 30), (std::vector<long>{40, 40, 1}));
    EXPECT_EQ(codes(1, 60), (std::vector<long>{255, 128, 0}));
}

TEST_F(LongShaderPages, ShowScenesWithTheirParameters)
{
    ExportShot original("sdf_scenes");
    original.set("scene", std::string("dahlia.json"));
    original.read();
    original.set("evaluation", 2.0);
    const Shown shown = shownBy(original, "take(0); shaderPage.set('bloom', 0.3); take(0);", 2);
    EXPECT_LE(between(original.shot.take().image, shown.pictures[0]).rmse, 2);
    original.set("bloom", 0.3);
    EXPECT_LE(between(original.shot.take().image, shown.pictures[1]).rmse, 2);
}

TEST_F(LongShaderPages, ShowTheNoise)
{
    ExportShot original = noiseShot(Work::sea);
    const Shown shown = shownBy(original, "take(0); shaderPage.set('chop', 0.3); take(5);", 2);
    EXPECT_LE(between(original.shot.take().image, shown.pictures[0]).rmse, 1);
    original.set("chop", 0.3);
    original.set("moment", 5.0);
    EXPECT_LE(between(original.shot.take().image, shown.pictures[1]).rmse, 1);
}

TEST(BlocksOfExports, HaveTheLengthsOfTheirArrays)
{
    const guest::GlslMacros macros{{"COUNT", "12"}};
    const auto listed = [&](const std::string& length) {
        return guest::fieldsOfMacro("#define X_FIELDS(FIELD, ARRAY) FIELD(int, a) ARRAY(vec4, b, " + length + ")",
                                    macros);
    };
    const auto declared = [&](const std::string& length) {
        return guest::fieldsInBraces("uniform X { int a; vec4 b[ " + length + " ]; };", macros);
    };
    for (const auto& fields : {listed("COUNT"), declared("COUNT")}) {
        ASSERT_EQ(fields.size(), 2U);
        EXPECT_EQ(fields[0].count, 0);
        EXPECT_EQ(fields[1].name, "b");
        EXPECT_EQ(fields[1].count, 12);
    }
    EXPECT_THROW(listed("COUNT / 4"), Failure);
    EXPECT_THROW(declared("COUNT / 4"), Failure);
}

TEST(CodeOfShaders, IsRenamedAndStrippedAsNeeded)
{
    const guest::Code code{{0, 1,
                            "struct Ray { vec3 at; };\n#define TWO 2.0\nconst float half_ = 0.5, third = 0.3;\n"
                            "float f(float x) { float y = x; return y; }\nvec3 g[2];\nRay r;\n"}};
    EXPECT_EQ(guest::globalNames(code), (std::set<std::string>{"Ray", "TWO", "f", "g", "half_", "r", "third"}));
    guest::Shader shader{.form = guest::Form::plain};
    shader.inputs.push_back({.name = "gain", .glslType = "float"});
    const guest::Code own{{0, 1,
                           "#version 300 es\nprecision highp float;\nuniform float gain; // 0 .. 1\n"
                           "layout(location = 0) out vec4 color; // the picture\n"
                           "in vec2 uv;\n// kept\n"
                           "void main() { color = vec4(uv, gain, 1.0).color; }\n"}};
    EXPECT_EQ(guest::rewritten(shader, own, {{"main", "pictureMain"}, {"color", "c"}}),
              "precision highp float;\nvec4 c; // the picture\n// kept\n"
              "void pictureMain() { c = vec4(uv, gain, 1.0).color; }\n");
    EXPECT_EQ(guest::outputName(own), "color");
    EXPECT_EQ(guest::versionLine("uint x = 1u;"), "#version 330\n");
    EXPECT_EQ(guest::versionLine("float sample = 1.0;"), "");
}

}  // namespace
}  // namespace vitrine
