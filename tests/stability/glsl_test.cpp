// Files that C++ has compiled must also be valid GLSL.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Returns the file with its includes inserted, each once, like the renderer's loader.
std::string flattened(const std::string& name, std::set<std::string>& done)
{
    if (!done.insert(name).second) return {};
    std::ifstream file(fs::path(VITRINE_SOURCE_DIR) / "shaders" / name);
    EXPECT_TRUE(file) << name;
    std::string text;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("#include \""))
            text += flattened(line.substr(10, line.size() - 11), done);
        else
            text += line + '\n';
    }
    return text;
}

/// Returns a shader that uses the library like an exhibit.
std::string fragmentShader()
{
    std::set<std::string> done;
    std::string text =
        "#version 450 core\nlayout(location = 0) out vec4 color;\nlayout(location = 0) in vec3 direction;\n";
    text += flattened("sdf_morph/torus_mug.glsl", done);
    text += flattened("lib/hash.glsl", done);
    text += "TorusMugShape shape;\nfloat fieldDistance(vec3 p) { return sdfTorusMug(p, shape); }\n";
    text += flattened("lib/sphere_tracing.glsl", done);
    return text + R"(
void main()
{
    shape = torusMugShape(TorusMug(0.5, 0.35, 0.12, 0.28, 0.66, 0.045, 0.165, 0.09, 0.06));
    TorusMugBox box = torusMugBox(shape);
    vec3 eye = vec3(0.0, 0.0, 3.0);
    vec3 ray = normalize(direction);
    vec2 span = rayBox(eye, ray, box.center - box.halfSize, box.center + box.halfSize);
    MarchSettings settings = marchSettings(span.x, span.y, 0.001);
    ConeMarch cone = coneMarch(eye, ray, coneChord(ray, normalize(ray + vec3(0.01))), settings);
    settings.tMin = max(settings.tMin, cone.t);
    March march = sphereTrace(eye, ray, settings);
    vec3 p = eye + ray * march.t;
    vec3 n = fieldNormal(p, normalStep(march.t, settings), NORMAL_CENTRAL, -ray);
    float light = shadowSigned(p, n, 0.06, 0.01, 3.0, 64).visibility + shadowClassic(p, n, 0.06, 0.01, 3.0, 64).visibility +
                  shadowAaltonen(p, n, 0.06, 0.01, 3.0, 64).visibility +
                  shadowArea(p, n, 0.06, 0.01, 3.0, 64, 8, unitFromBits(hashCell(ivec3(p), 1u).x)).visibility;
    color = vec4(n * light * schlick(dot(n, ray), 0.04), fieldOcclusion(p, n, 0.4));
}
)";
}

TEST(Library, CompilesAsGlslThatTheReferenceCompilerAccepts)
{
    const std::string compiler = VITRINE_GLSLANG;
    if (compiler.empty()) GTEST_SKIP() << "glslangValidator was not found when the build was configured";
    const fs::path folder = fs::temp_directory_path() / ("vitrine_glsl_test_" + std::to_string(std::rand()));
    fs::create_directories(folder);
    const fs::path file = folder / "library.frag";
    std::ofstream(file) << fragmentShader();
    const fs::path log = folder / "log";
    const int status = std::system((compiler + " " + file.string() + " > " + log.string()).c_str());
    std::stringstream said;
    said << std::ifstream(log).rdbuf();
    EXPECT_EQ(status, 0) << said.str();
    fs::remove_all(folder);
}

/// Returns the shader files that render/glsl/cpu.h and the exhibits' *_cpu.h compile as C++. All others are GLSL only.
std::vector<fs::path> sharedWithCpp()
{
    const fs::path root(VITRINE_SOURCE_DIR);
    std::vector<fs::path> headers{root / "render" / "glsl" / "cpu.h"};
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / "exhibits"))
        if (entry.path().filename().string().ends_with("_cpu.h")) headers.push_back(entry.path());
    EXPECT_GE(headers.size(), 4U);
    std::vector<fs::path> files;
    for (const fs::path& path : headers) {
        std::ifstream header(path);
        for (std::string line; std::getline(header, line);) {
            const std::size_t start = line.find("#include \"shaders/");
            if (start == std::string::npos) continue;
            const std::size_t open = line.find('"', start) + 1;
            files.emplace_back(root / line.substr(open, line.find('"', open) - open));
        }
    }
    return files;
}

/// Rules for sources in both languages that neither compiler checks.
TEST(Library, KeepsToTheSubsetThatIsBothLanguages)
{
    const std::vector<fs::path> shared = sharedWithCpp();
    ASSERT_GE(shared.size(), 10U);
    for (const fs::path& path : shared) {
        std::ifstream file(path);
        ASSERT_TRUE(file) << path;
        int number = 0;
        for (std::string line; std::getline(file, line);) {
            ++number;
            const std::string code = line.substr(0, line.find("//"));
            for (const char* const banned : {" inout ", "(inout ", " out ", "(out ", "(in ", ", in ", ".xy", ".xz",
                                             ".yz", ".zx", ".rgb", ".xyz", "__FILE__"})
                EXPECT_EQ(code.find(banned), std::string::npos) << path.filename() << ':' << number << ": " << banned;
            EXPECT_LE(line.size(), 120U) << path.filename() << ':' << number;
        }
    }
}

}  // namespace
