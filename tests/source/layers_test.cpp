// Rules for includes: app > ui > exhibits > render > shaders/lib. A folder may include itself and folders to its right.
// Rooms, which are folders, include one another in no circle, and neither do more than three files.
// A room of exhibits/ declares everything in its own namespace.

#include "tests/source/source_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <set>

namespace vitrine {
namespace {

using test::Include;

const std::map<std::string, std::vector<std::string>> allowed{
    {"app", {"app/", "ui/", "exhibits/", "render/", "shaders/lib/"}},
    {"ui",
     {"ui/", "exhibits/framework/", "exhibits/museum/", "exhibits/study/", "exhibits/compare/", "exhibits/printing/",
      "exhibits/recording/", "exhibits/shader_export/", "exhibits/jobs/kit/", "exhibits/jobs.h", "exhibits/exhibits.h",
      "render/", "shaders/lib/"}},
    {"exhibits", {"exhibits/", "render/", "shaders/"}},
    {"render", {"render/", "shaders/lib/"}},
};

bool startsWith(const std::string& text, const std::string& start)
{
    return text.rfind(start, 0) == 0;
}

bool isOurs(const std::string& target)
{
    for (const char* folder : {"app/", "ui/", "exhibits/", "render/", "shaders/", "tests/"})
        if (startsWith(target, folder)) return true;
    return false;
}

bool isGl(const std::string& target)
{
    return startsWith(target, "epoxy/") || startsWith(target, "GL/") || startsWith(target, "EGL/") ||
           startsWith(target, "GLES");
}

/// Headers of QtGui, QtWidgets, QtOpenGL: those of QtCore are named, so that an unknown one is not let through.
bool isQt(const std::string& target)
{
    return target.size() > 1 && target[0] == 'Q' &&
           (std::isupper(static_cast<unsigned char>(target[1])) || startsWith(target, "Qt"));
}

bool isQtCore(const std::string& target)
{
    static const std::regex core(
        "(QtCore/.*|QString|QStringList|QByteArray|QFile|QFileInfo|QDir|QSaveFile|QStandardPaths|QLockFile|QDateTime|"
        "QCoreApplication|QLocale|QtGlobal|QObject|QTimer|QIODevice|QTemporaryFile|QStringView|QStorageInfo)");
    return std::regex_match(target, core);
}

/// Returns why `include` is not allowed; empty if it is.
std::string complaint(const Include& include)
{
    const std::string folder = include.file.substr(0, include.file.find('/'));
    const std::string& target = include.target;
    if (isOurs(target)) {
        bool good = false;
        for (const std::string& start : allowed.at(folder)) good = good || startsWith(target, start);
        // A job's own types are known to its preview alone.
        if (startsWith(include.file, "ui/jobs/") && include.file.find("_preview.") != std::string::npos)
            good = good || startsWith(target, "exhibits/jobs/");
        if (!good) return folder + " may not include it";
        if (folder == "exhibits" && startsWith(target, "render/gl/")) return "exhibits never sees GL";
        if (folder == "render" && startsWith(target, "render/gl/") && !startsWith(include.file, "render/gl/"))
            return "only render/gl knows render/gl";
    }
    if (isGl(target) && !startsWith(include.file, "render/gl/")) return "only render/gl includes GL headers";
    if (isQt(target)) {
        if (folder == "render") return "render knows no Qt";
        if (folder == "exhibits" && (!isQtCore(target) || !startsWith(include.file, "exhibits/framework/")))
            return "only exhibits/framework, and only QtCore";
    }
    return {};
}

class Layers : public testing::TestWithParam<const char*> {};

TEST_P(Layers, IncludeOnlyWhatLiesToTheirRight)
{
    for (const std::string& file : test::sourceFiles(GetParam(), test::cppExtensions))
        for (const Include& include : test::includesOf(file))
            EXPECT_EQ(complaint(include), "") << include.file << ':' << include.line << " includes " << include.target;
}

INSTANTIATE_TEST_SUITE_P(Folders, Layers, testing::Values("app", "ui", "exhibits", "render"),
                         [](const auto& p) { return std::string(p.param); });

TEST(LayersControl, ForbiddenIncludesAreSeen)
{
    EXPECT_NE(complaint({"render/plan/a.h", 1, "exhibits/museum/museum.h"}), "");
    EXPECT_NE(complaint({"exhibits/hall/a.h", 1, "ui/window/main_window.h"}), "");
    EXPECT_NE(complaint({"exhibits/hall/a.h", 1, "render/gl/renderer.h"}), "");
    EXPECT_NE(complaint({"exhibits/hall/a.h", 1, "QString"}), "");
    EXPECT_NE(complaint({"exhibits/framework/a.h", 1, "QImage"}), "");
    EXPECT_NE(complaint({"ui/a.cpp", 1, "exhibits/sdf_morph/sdf_morph.h"}), "");
    EXPECT_NE(complaint({"ui/jobs/a_preview.cpp", 1, "exhibits/pixel_art/palette.h"}), "");
    EXPECT_NE(complaint({"ui/jobs/job_dialog.cpp", 1, "exhibits/jobs/sprite/sprite_job.h"}), "");
    EXPECT_NE(complaint({"ui/window/a_preview.cpp", 1, "exhibits/jobs/sprite/sprite_job.h"}), "");
    EXPECT_EQ(complaint({"ui/jobs/sprite_preview.cpp", 1, "exhibits/jobs/sprite/sprite_job.h"}), "");
    EXPECT_EQ(complaint({"ui/window/a.cpp", 1, "exhibits/jobs/kit/job.h"}), "");
    EXPECT_NE(complaint({"ui/a.cpp", 1, "epoxy/gl.h"}), "");
    EXPECT_NE(complaint({"render/plan/a.h", 1, "render/gl/renderer.h"}), "");
    EXPECT_NE(complaint({"render/image/a.cpp", 1, "QImage"}), "");
    EXPECT_EQ(complaint({"exhibits/framework/a.cpp", 1, "QSaveFile"}), "");
    EXPECT_EQ(complaint({"render/gl/a.cpp", 1, "epoxy/gl.h"}), "");
    EXPECT_EQ(complaint({"app/a.cpp", 1, "exhibits/sdf_morph/sdf_morph.h"}), "");
}

/// Folders of exhibits/, each with the ones that it may include besides itself. Other folders are exhibits.
const std::map<std::string, std::vector<std::string>> roomsOfExhibits{
    {"framework", {}},
    {"kit", {"framework"}},
    {"hall", {"framework", "kit"}},
    {"museum", {"framework", "kit", "hall"}},
    {"printing", {"framework", "museum"}},
    {"study", {"framework", "museum"}},
    {"compare", {"framework", "museum", "study"}},
    {"recording", {"framework", "museum"}},
    {"stability", {"framework", "kit", "museum"}},
    {"shader_export", {"framework", "kit", "museum", "your_shader"}},
};
const std::vector<std::string> roomsForExhibits{"framework", "kit", "printing"};

/// Folders of ui/ in the same way. There are no cycles.
const std::map<std::string, std::vector<std::string>> roomsOfUi{
    {"kit", {}},
    {"model", {"kit"}},
    {"viewport", {"kit", "model"}},
    {"parameters", {"kit", "model", "viewport"}},
    {"presets", {"kit", "model", "viewport"}},
    {"charts", {"kit", "model"}},
    {"compare", {"kit", "model", "viewport", "parameters", "presets"}},
    {"explore", {"kit", "model", "viewport", "parameters", "presets"}},
    {"editor", {"kit", "model", "viewport"}},
    {"tree", {"kit", "model", "viewport", "parameters", "editor"}},
    {"study", {"kit", "model", "viewport", "parameters", "jobs"}},
    {"gamepad", {"kit", "model", "viewport"}},
    {"controllers", {"kit", "model", "viewport", "parameters"}},
    {"lessons", {"kit", "model", "viewport", "parameters"}},
    {"print", {"kit", "model", "viewport", "parameters", "presets"}},
    {"jobs", {"kit", "model", "viewport", "parameters"}},
    {"record", {"kit", "model", "viewport"}},
    {"preferences", {"kit", "model", "viewport", "parameters"}},
    {"export", {"kit", "model", "viewport"}},
    {"report", {"kit"}},
    {"window", {"kit",     "model",       "viewport", "parameters",  "presets", "charts", "compare",
                "explore", "editor",      "tree",     "lessons",     "study",   "print",  "jobs",
                "record",  "preferences", "gamepad",  "controllers", "export",  "report"}},
};

/// Returns the folder below the first one; empty if there is none.
std::string roomOf(const std::string& path)
{
    const std::string rest = path.substr(path.find('/') + 1);
    return rest.find('/') == std::string::npos ? "" : rest.substr(0, rest.find('/'));
}

/// Returns why a file of ui/ must not include another one of ui/; empty if it may.
std::string uiRoomComplaint(const Include& include)
{
    const std::string from = roomOf(include.file), to = roomOf(include.target);
    if (from == to) return {};
    const auto room = roomsOfUi.find(from);
    if (room == roomsOfUi.end()) return from + " is no room of ui/";
    const std::vector<std::string>& good = room->second;
    return std::find(good.begin(), good.end(), to) == good.end() ? from + " may not include " + to : "";
}

/// The same for a file of exhibits/jobs/: a job may include every room but another job, and the kit no job.
std::string jobComplaint(const Include& include)
{
    const std::string jobs = "exhibits/jobs/";
    const auto jobOf = [&](const std::string& path) { return roomOf(path.substr(path.find('/') + 1)); };
    const std::string from = jobOf(include.file);
    if (include.target == "exhibits/jobs.h" || include.target == "exhibits/exhibits.h") return "a job knows no list";
    if (startsWith(include.target, jobs)) {
        const std::string to = jobOf(include.target);
        return to == from || to == "kit" ? "" : from + " may not include " + to;
    }
    const std::string room = roomOf(include.target);
    if (from == "kit" && room != "framework" && room != "museum") return "the kit may not include " + room;
    return {};
}

/// Returns why a file of exhibits/ must not include one of exhibits/ or shaders/; empty if it may.
std::string roomComplaint(const Include& include)
{
    const std::string from = roomOf(include.file), to = roomOf(include.target);
    if (from == "jobs") return jobComplaint(include);
    if (from.empty() || from == to) return {};  // The lists of exhibits and of jobs include all of them.
    if (startsWith(include.target, "shaders/lib/")) return {};
    const auto room = roomsOfExhibits.find(from);
    const std::vector<std::string>& good = room == roomsOfExhibits.end() ? roomsForExhibits : room->second;
    return std::find(good.begin(), good.end(), to) == good.end() ? from + " may not include " + to : "";
}

TEST(Layers, RoomsOfTheExhibitsIncludeOnlyThoseBelowThem)
{
    for (const std::string& file : test::sourceFiles("exhibits", test::cppExtensions))
        for (const Include& include : test::includesOf(file))
            if (startsWith(include.target, "exhibits/") || startsWith(include.target, "shaders/")) {
                EXPECT_EQ(roomComplaint(include), "") << file << ':' << include.line << " includes " << include.target;
            }
}

TEST(Layers, RoomsOfTheWindowIncludeOnlyThoseBelowThem)
{
    for (const std::string& file : test::sourceFiles("ui", test::cppExtensions))
        for (const Include& include : test::includesOf(file))
            if (startsWith(include.target, "ui/")) {
                EXPECT_EQ(uiRoomComplaint(include), "")
                    << file << ':' << include.line << " includes " << include.target;
            }
}

TEST(Layers, RoomsOfTheWindowHaveNoCycles)
{
    for (const auto& [room, below] : roomsOfUi)
        for (const std::string& lower : below) {
            const std::vector<std::string>& further = roomsOfUi.at(lower);
            EXPECT_EQ(std::find(further.begin(), further.end(), room), further.end())
                << room << " and " << lower << " may include each other";
            for (const std::string& lowest : further)
                EXPECT_NE(std::find(below.begin(), below.end(), lowest), below.end())
                    << room << " reaches " << lowest << " through " << lower << " only";
        }
}

TEST(LayersControl, ForbiddenRoomsAreSeen)
{
    EXPECT_NE(uiRoomComplaint({"ui/presets/a.h", 1, "ui/window/main_window.h"}), "");
    EXPECT_NE(uiRoomComplaint({"ui/kit/a.h", 1, "ui/model/history.h"}), "");
    EXPECT_NE(uiRoomComplaint({"ui/a.h", 1, "ui/model/history.h"}), "");
    EXPECT_EQ(uiRoomComplaint({"ui/window/a.h", 1, "ui/print/print_dialog.h"}), "");
    EXPECT_NE(roomComplaint({"exhibits/fur/a.h", 1, "exhibits/sdf_morph/sdf_morph.h"}), "");
    EXPECT_NE(roomComplaint({"exhibits/fur/a.h", 1, "exhibits/hall/hall.h"}), "");
    EXPECT_NE(roomComplaint({"exhibits/hall/a.h", 1, "exhibits/museum/museum.h"}), "");
    EXPECT_NE(roomComplaint({"exhibits/framework/a.h", 1, "exhibits/exhibits.h"}), "");
    EXPECT_NE(roomComplaint({"exhibits/pixel_art/a.h", 1, "exhibits/jobs/sprite/sprite_sheet.h"}), "");
    EXPECT_NE(roomComplaint({"exhibits/jobs/mesh/a.h", 1, "exhibits/jobs/sprite/sprite_sheet.h"}), "");
    EXPECT_NE(roomComplaint({"exhibits/jobs/kit/a.h", 1, "exhibits/jobs/sprite/sprite_sheet.h"}), "");
    EXPECT_NE(roomComplaint({"exhibits/jobs/kit/a.h", 1, "exhibits/printing/sheet.h"}), "");
    EXPECT_NE(roomComplaint({"exhibits/jobs/mesh/a.h", 1, "exhibits/jobs.h"}), "");
    EXPECT_EQ(roomComplaint({"exhibits/jobs/mesh/a.h", 1, "exhibits/sdf_scenes/scene.h"}), "");
    EXPECT_EQ(roomComplaint({"exhibits/jobs/mesh/a.h", 1, "exhibits/jobs/kit/job.h"}), "");
    EXPECT_EQ(roomComplaint({"exhibits/jobs.cpp", 1, "exhibits/jobs/mesh/mesh_job.h"}), "");
    EXPECT_NE(roomComplaint({"exhibits/fur/a.h", 1, "shaders/lenticular/card_block.glsl"}), "");
    EXPECT_NE(roomComplaint({"exhibits/framework/a.h", 1, "shaders/kit/surface_object_block.glsl"}), "");
    EXPECT_EQ(roomComplaint({"exhibits/lenticular/a.h", 1, "exhibits/printing/sheet.h"}), "");
    EXPECT_EQ(roomComplaint({"exhibits/fur/a.h", 1, "shaders/fur/body_block.glsl"}), "");
    EXPECT_EQ(roomComplaint({"exhibits/fur/a.h", 1, "shaders/kit/surface_object_block.glsl"}), "");
    EXPECT_EQ(roomComplaint({"exhibits/fur/a.h", 1, "shaders/lib/bindings.glsl"}), "");
    EXPECT_EQ(roomComplaint({"exhibits/exhibits.cpp", 1, "exhibits/fur/fur.h"}), "");
}

/// Returns the namespace of a file of exhibits/: that of its room. What every exhibit uses is in `vitrine` itself.
std::string namespaceOf(const std::string& file)
{
    static const std::map<std::string, std::string> differs{{"", ""},
                                                            {"framework", ""},
                                                            {"kit", ""},
                                                            {"museum", ""},
                                                            {"sdf_scenes", "scenes"},
                                                            {"your_shader", "guest"},
                                                            {"shader_export", "guest"}};
    const std::string room = roomOf(file);
    const auto found = differs.find(room);
    const std::string& name = found == differs.end() ? room : found->second;
    return name.empty() ? "vitrine" : "vitrine::" + name;
}

/// Returns why a file of exhibits/ may not declare what it does; empty if it may. Other rooms' types may be declared in
/// advance, and GLSL is compiled as C++ in `vitrine::glsl`.
std::string namespaceComplaint(const std::string& file, const std::string& text)
{
    static const std::regex opening(R"(namespace (vitrine[\w:]*) \{\n((?:(?:class|struct) \w+;\n)+\})?)");
    const std::string own = namespaceOf(file);
    for (std::sregex_iterator found(text.begin(), text.end(), opening), end; found != end; ++found) {
        const std::string name = (*found)[1];
        const bool good = name == own || startsWith(name, own + "::") || name == "vitrine::glsl";
        if (!good && !(*found)[2].matched) return "declares in " + name + " instead of " + own;
    }
    return {};
}

TEST(Layers, RoomsOfTheExhibitsDeclareInTheirNamespace)
{
    for (const std::string& file : test::sourceFiles("exhibits", test::cppExtensions))
        EXPECT_EQ(namespaceComplaint(file, test::withoutComments(test::sourceText(file))), "") << file;
}

TEST(LayersControl, ForeignNamespacesAreSeen)
{
    const std::string fur = "namespace vitrine::fur {\n\nclass Fur {};\n\n}";
    EXPECT_EQ(namespaceComplaint("exhibits/fur/a.h", fur), "");
    EXPECT_NE(namespaceComplaint("exhibits/hall/a.h", fur), "");
    EXPECT_NE(namespaceComplaint("exhibits/fur/a.h", "namespace vitrine {\n\nclass Fur {};\n\n}"), "");
    EXPECT_NE(namespaceComplaint("exhibits/fur/a.h", fur + "\nnamespace vitrine {\nclass A;\nclass B {};\n}"), "");
    EXPECT_NE(namespaceComplaint("exhibits/fur/a.h", "namespace vitrine::furniture {\n\nclass Fur {};\n\n}"), "");
    EXPECT_EQ(namespaceComplaint("exhibits/hall/a.h", "namespace vitrine::fur {\nclass Fur;\n}"), "");
    EXPECT_EQ(namespaceComplaint("exhibits/kit/a.h", "namespace vitrine {\n\nclass Kit {};\n\n}"), "");
    EXPECT_NE(namespaceComplaint("exhibits/jobs/mesh/a.h", "namespace vitrine {\n\nclass Mesh {};\n\n}"), "");
    EXPECT_EQ(namespaceComplaint("exhibits/your_shader/a.h", "namespace vitrine::guest {\n\nclass A {};\n\n}"), "");
}

/// Names of rooms or files, each with the names that it includes.
using IncludeGraph = std::map<std::string, std::set<std::string>>;
using Circle = std::set<std::string>;

/// Returns the strongly connected components of more than one name (Tarjan 1972, "Depth-First Search and Linear Graph
/// Algorithms"): within a circle, every name reaches every other.
std::set<Circle> circlesOf(const IncludeGraph& graph)
{
    std::map<std::string, std::size_t> order, lowest;
    std::vector<std::string> path;
    std::set<std::string> onPath;
    std::set<Circle> circles;
    const std::function<void(const std::string&)> visit = [&](const std::string& name) {
        const std::size_t mine = order.size();
        order[name] = lowest[name] = mine;
        path.push_back(name);
        onPath.insert(name);
        const auto next = graph.find(name);
        if (next != graph.end())
            for (const std::string& other : next->second) {
                if (!order.contains(other)) visit(other);
                if (onPath.contains(other)) lowest[name] = std::min(lowest[name], lowest[other]);
            }
        if (lowest[name] != mine) return;
        const auto first = std::find(path.begin(), path.end(), name);
        const Circle circle(first, path.end());
        path.erase(first, path.end());
        for (const std::string& each : circle) onPath.erase(each);
        if (circle.size() > 1) circles.insert(circle);
    };
    for (const auto& [name, others] : graph)
        if (!order.contains(name)) visit(name);
    return circles;
}

/// Returns the folder of a file: "exhibits/jobs/kit".
std::string folderOf(const std::string& path)
{
    return path.substr(0, path.rfind('/'));
}

/// Returns the path without its extension: a header and its source count as one file.
std::string withoutExtension(const std::string& path)
{
    return path.substr(0, path.rfind('.'));
}

/// Returns what includes what in app, ui, exhibits and render, by the names that `nameOf` gives to files.
IncludeGraph includeGraph(const std::function<std::string(const std::string&)>& nameOf)
{
    IncludeGraph graph;
    for (const char* folder : {"app", "ui", "exhibits", "render"})
        for (const std::string& file : test::sourceFiles(folder, test::cppExtensions))
            for (const Include& include : test::includesOf(file))
                if (isOurs(include.target) && nameOf(include.target) != nameOf(file))
                    graph[nameOf(file)].insert(nameOf(include.target));
    return graph;
}

std::string listed(const Circle& circle)
{
    std::string text;
    for (const std::string& name : circle) text += (text.empty() ? "" : ", ") + name;
    return text;
}

void expectNoCircles(const std::set<Circle>& found)
{
    for (const Circle& circle : found)
        ADD_FAILURE() << "These include one another in a circle: " << listed(circle)
                      << ". Open it: move what both ends need below them.";
}

TEST(Layers, RoomsFormNoCircles)
{
    expectNoCircles(circlesOf(includeGraph(folderOf)));
}

TEST(Layers, NoMoreThanThreeFilesFormACircle)
{
    std::set<Circle> large;
    for (const Circle& circle : circlesOf(includeGraph(withoutExtension)))
        if (circle.size() > 3) large.insert(circle);
    expectNoCircles(large);
}

TEST(LayersControl, CirclesAreFound)
{
    const IncludeGraph chain{{"a", {"b", "c"}}, {"b", {"c"}}, {"c", {"d"}}};
    EXPECT_EQ(circlesOf(chain), std::set<Circle>{});
    IncludeGraph graph = chain;
    graph["d"] = {"b"};
    EXPECT_EQ(circlesOf(graph), std::set<Circle>({{"b", "c", "d"}}));
    graph["e"] = {"a", "f"};
    graph["f"] = {"e"};
    EXPECT_EQ(circlesOf(graph), std::set<Circle>({{"b", "c", "d"}, {"e", "f"}}));
    graph["d"].insert("e");
    EXPECT_EQ(circlesOf(graph), std::set<Circle>({{"a", "b", "c", "d", "e", "f"}}));
    EXPECT_EQ(folderOf("exhibits/jobs/kit/job.h"), "exhibits/jobs/kit");
    EXPECT_EQ(withoutExtension("app/main.cpp"), "app/main");
}

TEST(Layers, EveryIncludeOfOursExists)
{
    for (const char* folder : {"app", "ui", "exhibits", "render", "tests"})
        for (const std::string& file : test::sourceFiles(folder, test::cppExtensions))
            for (const Include& include : test::includesOf(file))
                if (isOurs(include.target) &&
                    include.target.find("cpu32.h") == std::string::npos) {  // The build generates cpu32.h.
                    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(VITRINE_SOURCE_DIR) / include.target))
                        << file << ':' << include.line << ' ' << include.target;
                }
}

/// The extensions of pictures that a line of code lists, where there are several. WebP is a video as well.
std::set<std::string> listedPictures(const std::string& line)
{
    static const std::regex literal(R"re("(?:\\.|[^"\\])*")re");
    static const std::regex extension(R"re((?:^|[^\w%])(png|jpe?g|tiff?|exr|bmp|hdr)\b)re");
    std::set<std::string> found;
    for (std::sregex_iterator text(line.begin(), line.end(), literal), end; text != end; ++text) {
        const std::string words = text->str();
        for (std::sregex_iterator at(words.begin(), words.end(), extension); at != end; ++at)
            found.insert((*at)[1].str().substr(0, 2));
    }
    return found;
}

TEST(Layers, PictureFormatsAreListedInTheirTableAlone)
{
    for (const char* folder : {"app", "ui", "exhibits", "render"})
        for (const std::string& file : test::sourceFiles(folder, test::cppExtensions)) {
            if (startsWith(file, "render/image/picture_formats.")) continue;
            const std::vector<std::string> lines = test::lines(test::withoutComments(test::sourceText(file)));
            for (std::size_t i = 0; i < lines.size(); ++i)
                EXPECT_LT(listedPictures(lines[i]).size(), 2U)
                    << file << ':' << i + 1 << ": ask render/image/picture_formats.h instead";
        }
}

TEST(LayersControl, ListsOfPictureFormatsAreSeen)
{
    EXPECT_EQ(listedPictures("tr(\"Pictures (*.png *.jpg)\")").size(), 2U);
    EXPECT_EQ(listedPictures("{\".tif\", \"png\"}").size(), 2U);
    EXPECT_EQ(listedPictures("if (e != \".tif\" && e != \".tiff\")").size(), 1U);
    EXPECT_EQ(listedPictures("\"view_00.png, view_01.png\"").size(), 1U);
}

TEST(Layers, NoFileIsLongerThan800Lines)
{
    for (const char* folder : {"app", "ui", "exhibits", "render", "tests"})
        for (const std::string& file : test::sourceFiles(folder, test::cppExtensions))
            EXPECT_LE(test::lines(test::sourceText(file)).size(), 800U) << file;
    for (const std::string& file : test::sourceFiles("shaders", test::glslExtensions))
        EXPECT_LE(test::lines(test::sourceText(file)).size(), 800U) << file;
}

}  // namespace
}  // namespace vitrine
