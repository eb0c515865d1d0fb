#include "app/command.h"

#include "app/number_option.h"
#include "app/picture_options.h"
#include "app/progress.h"
#include "app/useless_option.h"
#include "exhibits/framework/expression.h"
#include "exhibits/sdf_scenes/scene_mesh.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/number_text.h"

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <cstdio>
#include <memory>

namespace vitrine::app {
namespace {

struct MeshOptions {
    std::string file, out, cell = "1cm", low, high;
    std::vector<std::string> sets;
    double time = 0;
    double memoryMb = 0;
};

std::shared_ptr<const scenes::Scene> readOrThrow(const std::string& file)
{
    scenes::ReadScene read = scenes::readSceneFile(file);
    if (read.scene) {
        for (const scenes::Finding& shape : read.scene->leftOut)
            std::fprintf(stderr, "vitrine: %s This shape is left out.\n", shape.text().c_str());
        return read.scene;
    }
    const std::size_t others = read.findings.size() - 1;
    throw Failure(
        read.fileRead ? Blame::check : Blame::file,
        read.findings.front().text() +
            (others > 0 ? " And " + std::to_string(others) + " more; `vitrine scene check` lists them." : ""));
}

/// A plain number in SI, or one with a unit of its own.
std::optional<double> numberOption(const std::string& typed, Unit unit)
{
    const std::optional<double> plain = evaluate(typed, Unit::none);
    return plain ? plain : evaluate(typed, unit);
}

double lengthOption(const std::string& option, const std::string& typed)
{
    const std::optional<double> value = numberOption(typed, Unit::meter);
    if (!value) refuseDecimalComma(option, typed);
    if (!value || !(*value > 0))
        throw Failure(Blame::usage, option + " \"" + typed + "\": give a length, such as 5mm.");
    return *value;
}

/// The values of the scene's parameters, with those of "name=value" in their places.
std::vector<double> parameterValues(const scenes::Scene& scene, const std::vector<std::string>& sets)
{
    std::vector<double> values;
    std::string names;
    for (const scenes::SceneParameter& parameter : scene.parameters()) {
        values.push_back(parameter.initial);
        names += (names.empty() ? "" : ", ") + parameter.name;
    }
    for (const std::string& set : sets) {
        const std::size_t equals = set.find('=');
        const std::string name = set.substr(0, equals);
        const std::string typed = equals == std::string::npos ? "" : set.substr(equals + 1);
        std::size_t i = 0;
        while (i < values.size() && scene.parameters()[i].name != name) ++i;
        if (equals == std::string::npos) throw Failure(Blame::usage, "--set " + set + ": give name=value.");
        if (i == values.size())
            throw Failure(Blame::usage, "--set " + name + ": the scene has no such parameter" +
                                            (names.empty() ? " and no other." : "; it has " + names + "."));
        const scenes::SceneParameter& parameter = scene.parameters()[i];
        const std::optional<double> value = numberOption(typed, parameter.unit);
        if (!value) refuseDecimalComma("--set " + name, typed);
        if (!value || !(*value >= parameter.low && *value <= parameter.high))
            throw Failure(Blame::usage, "--set " + name + "=" + typed + ": give a number from " +
                                            render::shortestNumber(parameter.low) + " to " +
                                            render::shortestNumber(parameter.high) + " " +
                                            std::string(info(parameter.unit).storedSymbol) + ".");
        values[i] = *value;
    }
    return values;
}

scenes::MeshRequest meshRequest(const MeshOptions& options)
{
    scenes::MeshRequest request;
    request.cell = lengthOption("--cell", options.cell);
    if (options.low.empty() != options.high.empty())
        throw Failure(Blame::usage, "--low and --high belong together: two corners of the part that is meshed.");
    if (!options.low.empty()) {
        request.part = render::Box{parseTriple("--low", options.low, Unit::meter),
                                   parseTriple("--high", options.high, Unit::meter)};
        const glm::dvec3 size = request.part->high - request.part->low;
        if (!(size.x > 0 && size.y > 0 && size.z > 0))
            throw Failure(Blame::usage, "--high: all three numbers are above those of --low.");
    }
    const double machine = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    request.mostBytes = static_cast<std::uint64_t>(options.memoryMb > 0 ? options.memoryMb * 1e6 : machine / 2);
    return request;
}

void sayPlan(const scenes::MeshPlan& plan)
{
    const double skipped = 100 * (1 - static_cast<double>(plan.nearSurface) / plan.allCells());
    std::fprintf(stderr,
                 "vitrine: %s of %s cells are near the surface, %.2f %% are skipped; at most %s MB of memory.\n",
                 render::shortNumber(static_cast<double>(plan.nearSurface)).c_str(),
                 render::shortNumber(plan.allCells()).c_str(), skipped,
                 render::shortNumber(static_cast<double>(plan.bytes) / 1e6).c_str());
}

/// Throws Failure (Blame::check) where the mesh is not what it should be.
scenes::MeshCheck checked(const scenes::SceneMesh& mesh)
{
    if (mesh.indices.empty())
        throw Failure(Blame::check, "No point of the scene is inside, as far as these cells can tell: sheets need a "
                                    "thickness, and what is thinner than a cell a smaller --cell.");
    scenes::MeshCheck check = scenes::checkMesh(mesh);
    if (!check.good())
        throw Failure(Blame::check, "The mesh is not closed or no manifold (" + std::to_string(check.openEdges) +
                                        " edges, " + std::to_string(check.brokenVertices) + " vertices, " +
                                        std::to_string(check.emptyTriangles) +
                                        " triangles); nothing was written. Give a slightly different --cell.");
    return check;
}

int mesh(const CLI::App& command, const MeshOptions& options)
{
    const auto format = scenes::meshFormat(options.out);
    if (!format) throw Failure(Blame::usage, "--out " + options.out + ": give a name that ends in .glb, .stl or .ply.");
    const scenes::MeshRequest request = meshRequest(options);
    const auto scene = readOrThrow(options.file);
    refuseOn(command, "--time", !scene->animated(), "a scene in which nothing moves");
    const scenes::SceneField field(scene, options.time, parameterValues(*scene, options.sets));
    {
        const render::PartFile writable(options.out);
    }
    const StopSignal stop;
    ProgressLine line("meshing");
    const auto progress = [&](double part) { return line.show(part); };
    scenes::SceneMesher mesher(field, request, progress);
    if (StopSignal::stopped()) return StopSignal::exitCode;
    sayPlan(mesher.plan());
    const std::optional<scenes::SceneMesh> made = mesher.mesh(progress);
    if (!made) return StopSignal::exitCode;
    const scenes::MeshCheck check = checked(*made);
    if (StopSignal::stopped()) return StopSignal::exitCode;
    const std::string name = scene->name.empty() ? "scene" : scene->name;
    render::atomicWrite(options.out, scenes::meshFile(*made, *format, name));
    std::printf("%s: %zu vertices, %zu triangles; closed, a manifold; %s m³, %s m²\n", options.out.c_str(),
                made->vertices.size(), made->indices.size() / 3, render::shortNumber(check.volume).c_str(),
                render::shortNumber(check.area).c_str());
    if (mesher.plan().lost > 0)
        std::fprintf(stderr,
                     "vitrine: %llu cells hold parts that are thinner than a cell; a smaller --cell keeps them.\n",
                     static_cast<unsigned long long>(mesher.plan().lost));
    return 0;
}

}  // namespace

void addSceneMeshCommand(CLI::App& parser, Action& chosen)
{
    CLI::App* command = parser.add_subcommand("mesh", "Write the surface of a scene file as a closed mesh");
    auto options = std::make_shared<MeshOptions>();
    command->add_option("file", options->file, "Scene file")->required();
    command->add_option("--cell", options->cell, "Edge of a cell: 5mm")->capture_default_str();
    command->add_option("--out", options->out, "Where to: .glb, .stl (in millimeters) or .ply")->required();
    command->add_option("--set", options->sets, "name=value: a parameter of the scene")
        ->take_all()
        ->allow_extra_args(true);
    addNumber(*command, "--time", options->time, {.unit = Unit::second}, "Seconds, for what moves")
        ->capture_default_str();
    command->add_option("--low", options->low, "x,y,z: a corner of the part that is meshed, and cut there");
    command->add_option("--high", options->high, "x,y,z: the opposite corner");
    addNumber(*command, "--memory-mb", options->memoryMb, {1, 1e9},
              "How much memory it may take; half of the machine's by default");
    command->callback(
        [&chosen, options, command] { chosen = [options, command] { return mesh(*command, *options); }; });
}

}  // namespace vitrine::app
