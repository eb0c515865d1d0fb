#include "exhibits/jobs/mesh/mesh_job.h"

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/table/expression.h"
#include "exhibits/framework/table/typed_number.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/jobs/mesh/mesh_picture.h"
#include "exhibits/sdf_scenes/scene_mesh.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "exhibits/sdf_scenes/sdf_scenes.h"
#include "exhibits/sdf_scenes/shown_scene.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/number_text.h"
#include "render/text/joined.h"
#include "render/text/message.h"
#include "render/text/nearest_word.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::jobs {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

struct MeshTable final : Parameters {
    Group sceneGroup = group("Scene");
    File file = Parameters::file("scene",
                                 "Scene file. Empty in the window: the scene that SDF Scenes shows, with its present "
                                 "values and time.",
                                 extensions("json"), positional(), mustBeGiven());
    Text set = text("set", "Value of one of the scene's parameters, name=value. Numbers are in SI units.", several(),
                    labeled("Values of the scene"));
    Real time = real("time", 0, second, Range{-1e9, 1e9}.soft(0, 60), "Time at which a moving scene is meshed.");

    Group meshGroup = group("Mesh");
    Real cell = real("cell", 0.01, meter, Range{1e-6, 1000, logarithmic}.soft(0.001, 0.1),
                     "Edge length of a cell. Parts that are thinner than a cell are lost.");
    std::array<Real, 3> low =
        corner({"lowX", "lowY", "lowZ"}, "low", -endless, "-inf",
               "Lower corner of the box that is meshed; the mesh is cut at its sides. Inf: the whole scene.");
    std::array<Real, 3> high =
        corner({"highX", "highY", "highZ"}, "high", endless, "inf", "Upper corner of the box that is meshed.");
    Count triangles =
        count("triangles", 0, Range{4, 100000000, logarithmic}.soft(100, 1e6),
              "Number of triangles to which the mesh is simplified. All: as many as the cells give.", reads(0, "all"));
    Real deviation = real("deviation", 0, meter, Range{1e-7, 1000, logarithmic}.soft(1e-5, 0.1),
                          "Largest estimated distance between the simplified and the original surface. None: "
                          "any distance, until the number of triangles is reached.",
                          reads(0, "none"));
    Real memory = real("memoryMb", 0, none, Range{1, 1e9, logarithmic}.soft(100, 1e5),
                       "Largest amount of memory for meshing, in megabytes. Auto: half of the machine's.",
                       reads(0, "auto"), labeled("Memory limit in MB"));

private:
    std::array<Real, 3> corner(std::array<std::string_view, 3> names, std::string_view name, double unset,
                               std::string_view word, std::string_view help)
    {
        const auto one = [&](std::string_view axis) {
            return real(axis, unset, meter, {-1e6, 1e6}, help, reads(unset, word), tuple(name, ','));
        };
        return {one(names[0]), one(names[1]), one(names[2])};
    }
};

const MeshTable& meshTable()
{
    static const MeshTable table;
    return table;
}

struct MeshInputs final : JobInputs {
    std::shared_ptr<const scenes::Scene> scene;
};

std::optional<glm::dvec3> cornerOf(const ParameterValues& values, const std::array<Real, 3>& rows)
{
    const glm::dvec3 corner{values[rows[0]], values[rows[1]], values[rows[2]]};
    if (!std::isfinite(corner.x) || !std::isfinite(corner.y) || !std::isfinite(corner.z)) return std::nullopt;
    return corner;
}

/// Scene that an exhibit shows in the window.
struct ShownInWindow {
    std::string path;
    std::vector<std::string> values = {};  ///< Parameters that are not initial, each as "name=value".
    double seconds = 0;                    ///< Time of a moving scene.
    std::optional<render::Box> part = {};  ///< Box around the view's target, for a scene without an end.
    bool isEdited = false;                 ///< Whether its edits are not in the file yet.
};

/// Returns the cube around the view's target that the picture shows; nullopt for a scene that has an end.
std::optional<render::Box> shownPart(const scenes::ShownScene& shown, double seconds, const std::vector<double>& given)
{
    const std::vector<double> numbers = shown.scene->numbersAt(seconds, given);
    const render::Box box = scenes::SceneField(shown.program, shown.program->words(numbers)).box();
    if (std::isfinite(glm::length(box.high - box.low))) return std::nullopt;
    const scenes::SceneCamera camera = scenes::sceneCamera(*shown.scene, numbers, 0);
    const double reach = glm::length(camera.eye - camera.target) * std::tan(camera.fovY / 2);
    return render::Box{camera.target - reach, camera.target + reach};
}

/// Returns the scene that the exhibit of scenes shows; nullopt if there is no such exhibit.
std::optional<ShownInWindow> shownInWindow(const JobScene& scene)
{
    const auto subject = scene.museum ? scene.museum->find("sdf_scenes") : std::nullopt;
    const auto* exhibit = subject ? capability<scenes::SdfScenes>(scene.museum->subject(*subject)) : nullptr;
    if (!exhibit) return std::nullopt;
    const ParameterValues& values = scene.state.values[*subject];
    const auto& table = static_cast<const scenes::SdfScenesTable&>(values.table());
    ShownInWindow shown{exhibit->document(values).path};
    shown.isEdited = !exhibit->unsavedText(values).empty();
    const scenes::ShownScene& now = exhibit->shown(values);
    const scenes::Scene& read = *now.scene;
    std::vector<double> given;
    for (std::size_t i = 0; i < table.ofScene.size(); ++i) {
        given.push_back(values[table.ofScene[i]]);
        if (given.back() != read.parameters()[i].initial)
            shown.values.push_back(read.parameters()[i].name + '=' + render::shortestNumber(given.back()));
    }
    if (read.animated())
        shown.seconds =
            values[table.moment] + (values[table.animate] && std::isfinite(scene.frame.time) ? scene.frame.time : 0);
    shown.part = shownPart(now, shown.seconds, given);
    return shown;
}

/// Returns whether neither --low nor --high is given.
bool isWholeScene(const ParameterValues& values)
{
    const MeshTable& t = meshTable();
    const auto isUnset = [&](const Real& parameter) { return values.isInitial(parameter.row); };
    return std::all_of(t.low.begin(), t.low.end(), isUnset) && std::all_of(t.high.begin(), t.high.end(), isUnset);
}

/// Returns the box between --low and --high; nullopt if neither is given. Throws Failure (ErrorKind::usage) if the
/// corners do not form a box.
std::optional<render::Box> partOf(const ParameterValues& values)
{
    const MeshTable& t = meshTable();
    const auto low = cornerOf(values, t.low), high = cornerOf(values, t.high);
    if (isWholeScene(values)) return std::nullopt;
    if (!low || !high)
        throw Failure(ErrorKind::usage, "--low and --high belong together: two corners of the part that is meshed.");
    const glm::dvec3 size = *high - *low;
    if (!(size.x > 0 && size.y > 0 && size.z > 0))
        throw Failure(ErrorKind::usage, "--high: each of the three numbers must be above that of --low.");
    return render::Box{*low, *high};
}

/// Returns the values of the scene's parameters, with those given as "name=value". Throws Failure (ErrorKind::usage).
std::vector<double> parametersOf(const scenes::Scene& scene, const ParameterValues& values)
{
    std::vector<double> all;
    for (const scenes::SceneParameter& parameter : scene.parameters()) all.push_back(parameter.initial);
    for (const std::string& set : linesOf(values[meshTable().set])) {
        const std::size_t equals = set.find('=');
        const std::string name = set.substr(0, equals);
        if (equals == std::string::npos) throw Failure(ErrorKind::usage, "--set " + set + ": give name=value.");
        const std::string typed = set.substr(equals + 1);
        std::size_t i = 0;
        while (i < all.size() && scene.parameters()[i].name != name) ++i;
        if (i == all.size()) {
            std::vector<std::string> names;
            for (const scenes::SceneParameter& parameter : scene.parameters()) names.push_back(parameter.name);
            throw Failure(ErrorKind::usage, "--set " + name + ": the scene has no " +
                                                (names.empty() ? "parameters."
                                                               : "parameter of that name" + didYouMean(name, names) +
                                                                     " it has " + joined(names, ", ") + "."));
        }
        const scenes::SceneParameter& parameter = scene.parameters()[i];
        std::optional<double> value = evaluate(typed, Unit::none);
        if (!value) value = evaluate(typed, parameter.unit);
        if (!value) refuseDecimalComma("--set " + name, typed);
        if (!value || !(*value >= parameter.low && *value <= parameter.high))
            throw Failure(ErrorKind::usage, "--set " + name + "=" + typed + ": give a number from " +
                                                render::shortestNumber(parameter.low) + " to " +
                                                render::shortestNumber(parameter.high) + " " +
                                                std::string(info(parameter.unit).storedSymbol) + ".");
        all[i] = *value;
    }
    return all;
}

scenes::MeshRequest requestOf(const ParameterValues& values)
{
    const MeshTable& t = meshTable();
    const double machine = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    scenes::MeshRequest request;
    request.cell = values[t.cell];
    request.part = partOf(values);
    request.mostBytes = static_cast<std::uint64_t>(values[t.memory] > 0 ? values[t.memory] * 1e6 : machine / 2);
    return request;
}

/// Returns the check of the mesh. Throws Failure (ErrorKind::check) if it is empty or not closed. `isPart`: it is
/// limited by --low and --high.
scenes::MeshCheck checked(const scenes::SceneMesh& mesh, bool isPart)
{
    if (mesh.indices.empty() && isPart)
        throw Failure(ErrorKind::check, "Nothing solid lies between --low and --high; nothing was written. Give other "
                                        "corners, or a smaller --cell for what is thinner than a cell.");
    if (mesh.indices.empty())
        throw Failure(ErrorKind::check,
                      "Nothing in the scene is as thick as a cell; nothing was written. Give a smaller "
                      "--cell, or a thickness to the sheets of the scene.");
    scenes::MeshCheck check = scenes::checkMesh(mesh);
    if (!check.good())
        throw Failure(ErrorKind::check, "The mesh is not closed or no manifold (" + std::to_string(check.openEdges) +
                                            " edges, " + std::to_string(check.brokenVertices) + " vertices, " +
                                            std::to_string(check.emptyTriangles + check.foldedTriangles) +
                                            " triangles); nothing was written. Give a slightly different --cell.");
    return check;
}

class MeshRun final : public JobRun {
public:
    explicit MeshRun(JobOrder order)
        : order_(std::move(order)), scene_(static_cast<const MeshInputs&>(*order_.inputs).scene),
          field_(scene_, order_.values[meshTable().time], parametersOf(*scene_, order_.values))
    {
    }

    [[nodiscard]] Next next() const override { return isDone_ ? Next::done : Next::work; }
    void step(const Watch& watch) override
    {
        const auto part = [&](double done) { return watch(progress_ = done); };
        if (!mesher_) {
            mesher_ = std::make_unique<scenes::SceneMesher>(field_, requestOf(order_.values), part);
            if (!watch(0)) throw Stopped();
            return;
        }
        std::optional<scenes::SceneMesh> mesh = mesher_->mesh(part);
        if (!mesh) throw Stopped();
        scenes::MeshCheck check = checked(*mesh, partOf(order_.values).has_value());
        if (!watch(1)) throw Stopped();
        unsimplified_ = mesh->indices.size() / 3;
        const std::optional<double> deviation = simplify(*mesh, check);
        tell(*mesh, check);
        if (deviation) report_.facts.push_back({"Deviation at most", 1000 * *deviation, "mm"});
        stage(*mesh);
        if (order_.out.empty()) mesh_ = std::move(*mesh);
        isDone_ = true;
    }
    [[nodiscard]] double progress() const override { return progress_; }
    [[nodiscard]] std::string_view doing() const override { return "meshing"; }
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override { render::publishAll(staged_); }
    [[nodiscard]] render::Image previewPicture() const override
    {
        const ParameterValues& values = order_.values;
        const std::vector<double> numbers = scene_->numbersAt(values[meshTable().time], parametersOf(*scene_, values));
        const scenes::SceneCamera camera = scenes::sceneCamera(*scene_, numbers, 0);
        return meshPicture(mesh_, camera.eye - camera.target, camera.up, {960, 720});
    }

    /// Returns the mesh of a finished run without an output.
    [[nodiscard]] const scenes::SceneMesh& mesh() const { return mesh_; }
    /// Returns the number of triangles that the cells gave, before the mesh was simplified.
    [[nodiscard]] std::size_t unsimplified() const { return unsimplified_; }
    /// Returns the upper bound on the memory, in bytes.
    [[nodiscard]] double memory() const { return mesher_ ? static_cast<double>(mesher_->plan().bytes) : 0; }

private:
    /// Simplifies the mesh and checks it again. Returns the deviation in meters; nothing if no limit is given. Throws
    /// Failure (ErrorKind::check) if the result is not closed.
    std::optional<double> simplify(scenes::SceneMesh& mesh, scenes::MeshCheck& check) const
    {
        const scenes::Simplification limits{order_.values[meshTable().triangles], order_.values[meshTable().deviation]};
        if (limits.triangles == 0 && limits.deviation == 0) return std::nullopt;
        scenes::SimplifiedMesh result = scenes::simplified(mesh, limits);
        check = scenes::checkMesh(result.mesh);
        // The cells of a draft may be too large for what the whole mesh can be simplified to.
        if (order_.out.empty() && (!check.good() || result.mesh.indices.empty())) {
            check = scenes::checkMesh(mesh);
            return std::nullopt;
        }
        if (!check.good() || result.mesh.indices.empty())
            throw Failure(ErrorKind::check,
                          "The mesh is not closed any more when it is simplified that far; nothing was written. Give "
                          "more --triangles, or a smaller --deviation.");
        mesh = std::move(result.mesh);
        return result.deviation;
    }
    void tell(const scenes::SceneMesh& mesh, const scenes::MeshCheck& check)
    {
        const scenes::MeshPlan& plan = mesher_->plan();
        report_.facts = {{"Vertices", static_cast<double>(mesh.vertices.size())},
                         {"Triangles", static_cast<double>(mesh.indices.size() / 3)},
                         {"Volume", check.volume, "m³"},
                         {"Area", check.area, "m²"},
                         {"Cells near the surface", static_cast<double>(plan.nearSurface)},
                         {"Skipped cells", 100 * (1 - static_cast<double>(plan.nearSurface) / plan.allCells()), "%"},
                         {"Memory at most", std::round(static_cast<double>(plan.bytes) / 1e6), "MB"}};
        if (plan.lost > 0)
            report_.warnings.push_back(std::to_string(plan.lost) +
                                       " cells hold parts that are thinner than a cell; a smaller --cell keeps them.");
    }
    void stage(const scenes::SceneMesh& mesh)
    {
        const std::filesystem::path& out = order_.out;
        if (out.empty()) return;
        const auto format = scenes::meshFormat(out.string());
        const std::string name = scene_->name.empty() ? "scene" : scene_->name;
        staged_.push_back(render::stagedFile(out, scenes::meshFile(mesh, *format, name)));
        staged_.push_back(render::stagedFile(documentFile(out), documentText(MeshJob(), order_, report_.facts)));
        report_.files = {out, documentFile(out)};
    }

    JobOrder order_;
    std::shared_ptr<const scenes::Scene> scene_;
    scenes::SceneField field_;
    std::unique_ptr<scenes::SceneMesher> mesher_;
    std::vector<std::unique_ptr<render::PartFile>> staged_;
    JobReport report_;
    scenes::SceneMesh mesh_;
    std::size_t unsimplified_ = 0;
    double progress_ = 0;
    bool isDone_ = false;
};

}  // namespace

const Parameters& MeshJob::parameters() const
{
    return meshTable();
}

JobNeeds MeshJob::needs() const
{
    return {.extensions = {scenes::meshEndings.begin(), scenes::meshEndings.end()},
            .inWindow = true,
            .preview = PreviewForm::picture};
}

ParameterValues MeshJob::withScene(const ParameterValues& values, const JobScene& scene) const
{
    const MeshTable& t = meshTable();
    if (!values[t.file].empty()) return values;
    const std::optional<ShownInWindow> shown = shownInWindow(scene);
    if (!shown) return values;
    ParameterValues whole = values;
    whole.set(t.file, shown->path);
    std::vector<std::string> lines = shown->values;
    for (const std::string& typed : linesOf(values[t.set])) lines.push_back(typed);  // The last value counts.
    whole.set(t.set, joined(lines, "\n"));
    if (values.isInitial(t.time.row)) whole.set(t.time, shown->seconds);
    if (shown->part && isWholeScene(values))
        for (int axis = 0; axis < 3; ++axis) {
            whole.set(t.low.at(static_cast<std::size_t>(axis)), shown->part->low[axis]);
            whole.set(t.high.at(static_cast<std::size_t>(axis)), shown->part->high[axis]);
        }
    return whole;
}

std::shared_ptr<const JobInputs> MeshJob::read(const ParameterValues& values) const
{
    if (values[meshTable().file].empty()) throw Failure(ErrorKind::usage, "No scene file is given; choose one.");
    scenes::ReadScene read = scenes::readSceneFile(values[meshTable().file]);
    if (!read.fileRead) throw Failure(ErrorKind::file, read.findings.front().sentence);
    if (!read.scene) {
        const std::size_t others = read.findings.size() - 1;
        const Failure first = read.findings.front().failure();
        throw Failure(ErrorKind::check,
                      others > 0
                          ? message("{1} And {2} more; `vitrine scene check` lists them.", first.message(), others)
                          : first.message(),
                      first.place());
    }
    auto inputs = std::make_shared<MeshInputs>();
    inputs->scene = std::move(read.scene);
    return inputs;
}

JobPlan MeshJob::plan(const ParameterValues& given, const JobScene& window, const JobInputs& inputs,
                      const std::filesystem::path& out) const
{
    const scenes::Scene& scene = *static_cast<const MeshInputs&>(inputs).scene;
    const ParameterValues values = withScene(given, window);
    JobPlan plan;
    for (const scenes::Finding& shape : scene.leftOut)
        plan.warnings.push_back(shape.text().english() + " This shape is left out.");
    const auto refuse = [&](const std::string& why) {
        if (plan.refusal.empty()) plan.refusal = why;
    };
    if (const auto shown = shownInWindow(window); shown && shown->isEdited && given[meshTable().file].empty())
        refuse("The scene has changes that are not in its file yet; save it first (File > Save).");
    if (isWholeScene(given) && !isWholeScene(values))
        plan.warnings.emplace_back("The scene has no end; the mesh is cut around what the view shows. Set Low and High "
                                   "for another part.");
    if (!scene.animated() && values[meshTable().time] != 0)
        refuse("--time has no effect on a scene in which nothing moves; leave it out.");
    try {
        static_cast<void>(requestOf(values));
        static_cast<void>(parametersOf(scene, values));
    } catch (const Failure& why) {
        refuse(why.what());
    }
    if (out.empty()) return plan;
    refuse(refusedExtension(*this, out));
    plan.files = {{out, "mesh"}, {documentFile(out), "settings"}};
    return plan;
}

std::unique_ptr<JobRun> MeshJob::start(JobOrder order) const
{
    return std::make_unique<MeshRun>(std::move(order));
}

ParameterValues MeshJob::draft(const ParameterValues& values, const JobInputs& inputs) const
{
    constexpr double draftCells = 64;  // Along the longest side.
    const MeshTable& t = meshTable();
    const auto& scene = static_cast<const MeshInputs&>(inputs).scene;
    const scenes::SceneField field(scene, values[t.time], parametersOf(*scene, values));
    const render::Box box = meshedBox(field, requestOf(values));
    const glm::dvec3 size = box.high - box.low;
    ParameterValues coarse = values;
    coarse.set(t.cell, std::max(values[t.cell], std::max({size.x, size.y, size.z}) / draftCells));
    return coarse;
}

JobForecast MeshJob::forecast(const ParameterValues& values, const FinishedDraft& draft,
                              const std::filesystem::path& out) const
{
    const MeshTable& t = meshTable();
    const auto& run = static_cast<const MeshRun&>(draft.run);
    // Work, triangles and memory belong to the surface, so that they grow with the square of the resolution.
    const double finer = draft.values[t.cell] / values[t.cell], more = finer * finer;
    const bool isLimited = values[t.triangles] > 0, deviates = values[t.deviation] > 0;
    double triangles = more * static_cast<double>(run.unsimplified());
    if (isLimited) triangles = std::min(triangles, static_cast<double>(values[t.triangles]));
    JobForecast forecast;
    const bool isBound = deviates && !isLimited;
    const double unit = std::pow(10.0, std::max(std::floor(std::log10(std::max(triangles, 1.0))) - 2, 0.0));
    triangles = std::round(triangles / unit) * unit;  // Three digits are known at most.
    forecast.facts.push_back({isBound ? "Triangles at most" : "Triangles about", triangles});
    if (const auto format = scenes::meshFormat(out.string()); format && !run.mesh().indices.empty()) {
        const double each = static_cast<double>(meshFile(run.mesh(), *format, "scene").size()) /
                            static_cast<double>(run.mesh().indices.size() / 3);
        forecast.facts.push_back({isBound ? "File at most" : "File about", triangles * each / 1e6, "MB"});
    }
    forecast.facts.push_back({"Memory at most", std::max(std::round(more * run.memory() / 1e6), 1.0), "MB"});
    forecast.seconds = draft.seconds * more;
    return forecast;
}

}  // namespace vitrine::jobs
