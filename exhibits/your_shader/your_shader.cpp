#include "exhibits/your_shader/your_shader.h"

#include "exhibits/framework/files/file_path.h"
#include "exhibits/framework/files/table_change.h"
#include "exhibits/kit/portal.h"
#include "exhibits/your_shader/crash_guard.h"
#include "exhibits/your_shader/guest_input.h"
#include "exhibits/your_shader/guest_passes.h"
#include "exhibits/your_shader/guest_pictures.h"
#include "exhibits/your_shader/guest_reader.h"
#include "exhibits/your_shader/guest_work.h"
#include "render/failure.h"
#include "render/files/assets.h"
#include "render/files/read_file.h"
#include "render/hash.h"
#include "render/plan/render_backend.h"
#include "render/video/sound_file.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vitrine::guest {
namespace {

/// The frame of the tenth place hangs on the wall; its screen is a little in front of it.
Portal screenPortal()
{
    Portal portal;
    portal.behind = -0.02;
    return portal;
}

/// Returns the place on the screen under a ray from the front, from 0 to 1, also beside the screen.
std::optional<glm::dvec2> placeUnder(const render::Ray& ray)
{
    const Portal portal = screenPortal();
    const double z = -portal.behind;
    if (!(ray.direction.z < 0) || !(ray.origin.z > z)) return std::nullopt;
    const glm::dvec3 hit = ray.at((z - ray.origin.z) / ray.direction.z);
    return 0.5 + 0.5 * glm::dvec2(hit) / portal.halfSize;
}

struct PreparedShader final : PreparedPart {
    explicit PreparedShader(ParameterValues with) : values(std::move(with)) {}

    ParameterValues values;  ///< With the inputs of the shader that is shown.
    std::vector<LoadedPicture> ofInputs, files;
    bool isLeftOff = false;  ///< The program ended while it first drew the shader.

    [[nodiscard]] const YourShaderTable& table() const { return static_cast<const YourShaderTable&>(values.table()); }
};

/// Returns the picture of a file, or the test picture. Reports a file that cannot be read.
LoadedPicture pictureFrom(const std::string& path, const ParameterInfo& parameter, std::string_view title,
                          render::AssetStore& assets, PreparedShader& part)
{
    const bool mipmaps = part.table().work->shader->form == Form::shadertoy;
    if (path.empty()) return {testPicture(mipmaps), 1};
    const auto read =
        assets.get<render::Texture>(mipmaps ? "your_shader.mipmapped_picture" : "your_shader.picture", path,
                                    [mipmaps](const std::string& file) { return readPicture(file, mipmaps); });
    if (!read.failure.empty())
        part.unreadable.push_back({"your_shader/pictures", unreadableFile(parameter, title, read.failure),
                                   message("A test picture takes its place.")});
    return {read.value ? read.value : testPicture(mipmaps), read.id};
}

/// Returns the sound of a file, or silence. Reports a file that cannot be read.
LoadedPicture soundFrom(const std::string& path, const ParameterInfo& parameter, std::string_view title,
                        render::AssetStore& assets, PreparedShader& part)
{
    if (path.empty()) return {};
    const auto read = assets.get<render::Sound>("your_shader.sound", path, [](const std::string& file) {
        auto sound = std::make_shared<render::Sound>(render::readSound(file));
        const std::uint64_t bytes = sound->samples.size() * sizeof(float);
        return render::AssetStore::Made<render::Sound>{std::move(sound), bytes};
    });
    if (!read.failure.empty())
        part.unreadable.push_back({"your_shader/sounds", unreadableFile(parameter, title, read.failure),
                                   message("The shader hears silence.")});
    return {nullptr, read.id, read.value};
}

constexpr const char* firstPicturePass = "your_shader/first picture";

/// Returns whether the window has not shown this edited shader yet. Its first picture in the hall has half the width,
/// so that an edit is seen soon; the next frame has the whole one.
bool isFirstPicture(const Work& work, const render::PersistentState& kept, const render::FramePlan& plan)
{
    if (plan.allSlices || plan.runEverything || work.isKept) return false;
    const auto shown = kept.slices.find(firstPicturePass);
    return shown == kept.slices.end() || shown->second.hash != work.id;
}

/// Returns the pass that records that an edited shader was shown. It takes two frames.
render::Pass recordOfFirstPicture(const Work& work)
{
    render::Pass pass;
    pass.name = firstPicturePass;
    pass.reason = "the shader is new, and its first picture is small";
    pass.phase = render::PassPhase::simulate;
    pass.work = render::Work::simulation;
    pass.writes = {"your_shader.shown"};
    pass.contentHash = work.id;
    pass.sliceCount = 2;
    return pass;
}

/// Returns the values without the inputs of the shader.
ParameterValues commonValues(const YourShaderTable& table, const ParameterValues& values)
{
    std::vector<std::string> notes;
    return underTable(values, {std::shared_ptr<const Parameters>(), &table}, notes);
}

/// Returns the parameters of the first shader, which is only read here: its translation takes a process of its own.
std::shared_ptr<const YourShaderTable> firstTable()
{
    try {
        const auto read = readShaderFile(render::asset("shaders") / YourShaderTable::firstShader);
        return read.shader ? std::make_shared<const YourShaderTable>(*read.shader) : nullptr;
    } catch (const Failure&) {
        return nullptr;  // The program's assets are not installed.
    }
}

}  // namespace

YourShader::YourShader() : first_(firstTable()) {}

render::Box YourShader::bounds(const ParameterValues&) const
{
    return portalBounds(screenPortal());
}

render::Camera YourShader::bestView(const ParameterValues&) const
{
    return portalView(screenPortal());
}

std::vector<StudyView> YourShader::studyViews(const ParameterValues& values) const
{
    std::vector<StudyView> views;
    for (const auto& [name, seconds] :
         {std::pair("best view", 0), std::pair("3 s later", 3), std::pair("11 s later", 11)}) {
        ParameterValues still = values;
        still.set(table_.animate, false);
        still.set(table_.moment, values[table_.moment] + seconds);
        views.push_back({name, bestView(values), 0, std::move(still)});
    }
    return views;
}

double YourShader::nextChange(const ParameterValues& values, double) const
{
    const auto& table = static_cast<const Table&>(values.table());
    // The first shader reads the time.
    const bool moves = !table.work || table.work->readsTime || table.work->isKept;
    return values[table_.animate] && moves ? 0 : std::numeric_limits<double>::infinity();
}

double YourShader::nextChangeOf(const ExhibitState& state) const
{
    return nextChange(state.values, state.time);
}

DynamicParameters YourShader::dynamicParameters(const ParameterValues& values, render::AssetStore& assets) const
{
    const std::string& file = values[table_.file];
    const std::string& text = values[table_.document];
    const bool isFirst = text.empty() && (file.empty() || file == Table::firstShader);
    if (isFirst && first_) return {first_, {}};
    const ParameterInfo& row = table_.rows()[text.empty() ? table_.file.row : table_.document.row];
    const auto reading = readWork(pathOf(values), assets, text, sources_);
    if (reading->table) return {reading->table, {}};
    return {nullptr, reading->why.empty() ? Message() : unreadableFile(row, title(), reading->why)};
}

std::filesystem::path YourShader::pathOf(const ParameterValues& values) const
{
    const std::string path = filePath(table_.rows()[table_.file.row], values[table_.file]);
    return path.empty() ? render::asset("shaders") / Table::firstShader : std::filesystem::path(path);
}

DocumentPlace YourShader::document(const ParameterValues& values) const
{
    const std::filesystem::path path = pathOf(values);
    const std::string& named = values[table_.file];
    return {table_.file.row,
            table_.document.row,
            path.string(),
            !named.empty() && path == named,
            path.extension().string().substr(path.has_extension() ? 1 : 0),
            table_.draft.row};
}

std::string YourShader::documentText(const ParameterValues& values) const
{
    if (std::string text = unsavedText(values); !text.empty()) return text;
    try {
        return render::readFile(pathOf(values), Limits::textBytes);
    } catch (const Failure&) {
        return {};  // The message about the file says why.
    }
}

bool YourShader::isDocument(const std::string& text) const
{
    return readShaderText(text, "shader").shader != nullptr;
}

EditedText YourShader::withText(const ParameterValues& values, const std::string& text,
                                render::AssetStore& assets) const
{
    const std::string written = text.empty() ? "\n" : text;  // An empty document would be none.
    const auto reading = readWork(pathOf(values), assets, written, sources_);
    EditedText edited{values, reading->table != nullptr, {}};
    for (const Finding& each : reading->findings)
        edited.findings.push_back({each.file, each.line, each.column, each.isError, each.sentence});
    if (!reading->table && edited.findings.empty())
        edited.findings.push_back({pathOf(values).string(), 1, 1, true, reading->why});
    edited.values.set(table_.draft, edited.isShown ? std::string() : written);
    if (!edited.isShown) return edited;
    edited.values.set(table_.document, written);
    std::vector<std::string> notes;
    edited.values = underTable(edited.values, reading->table, notes);
    return edited;
}

std::vector<TextTemplate> YourShader::templates() const
{
    const auto shader = [](const char* name) { return std::string("templates/") + name; };
    return {{message("Plain fragment shader"), shader("plain.frag")},
            {message("ISF, with inputs in its head"), shader("isf.fs")},
            {message("Shadertoy code"), shader("shadertoy.glsl")}};
}

std::vector<std::string> YourShader::furtherFiles(const ParameterValues& values) const
{
    const auto& table = static_cast<const Table&>(values.table());
    std::vector<std::string> files;
    if (!table.work) return files;
    files = table.work->beside;
    for (const std::filesystem::path& file : table.work->files) files.push_back(file.string());
    return files;
}

std::shared_ptr<const PreparedPart> YourShader::prepare(const PrepareContext& context) const
{
    if (!context.seen) return nullptr;
    auto part = std::make_shared<PreparedShader>(context.values);
    const ParameterInfo& row = table_.rows()[table_.file.row];
    if (!part->table().work) {
        const auto first = readWork(render::asset("shaders") / Table::firstShader, context.assets, {}, sources_);
        if (!first->table) {
            if (!first->why.empty())
                part->unreadable.push_back(
                    {"your_shader/file", unreadableFile(row, title(), first->why), message("The frame stays empty.")});
            return part;
        }
        std::vector<std::string> notes;
        part->values = underTable(context.values, first->table, notes);
    }
    const YourShaderTable& table = part->table();
    CrashGuard& guard = CrashGuard::ofProcess();
    part->isLeftOff = guard.leavesOff(*table.work);
    if (part->isLeftOff) {
        part->unreadable.push_back(
            {"your_shader/file",
             unreadableFile(
                 row, title(),
                 message("The program ended while it drew {1} for the first time, so it is not drawn; save the "
                         "file to try it again.",
                         table.work->path)),
             message("The frame stays empty.")});
        return part;
    }
    guard.begin(*table.work);
    render::Hash id;
    id.addValue(table.work->id);
    for (std::size_t i = 0; i < table.ofInputs.size(); ++i) {
        part->ofInputs.emplace_back();
        if (table.ofInputs[i].empty()) continue;
        const std::size_t at = table.ofInputs[i].front();
        if (table.rows()[at].kind != Kind::file || !table.sourceOf(i, part->values).empty()) continue;
        const auto read = table.work->shader->inputs[i].type == InputType::image ? &pictureFrom : &soundFrom;
        part->ofInputs.back() =
            read(std::get<std::string>(part->values.row(at)), table.rows()[at], title(), context.assets, *part);
        id.addValue(part->ofInputs.back().id);
    }
    for (const std::filesystem::path& file : table.work->files) {
        part->files.push_back(pictureFrom(file.string(), row, title(), context.assets, *part));
        id.addValue(part->files.back().id);
    }
    part->filesId = id.value();
    return part;
}

void YourShader::offerPictures(std::vector<PictureSource> sources)
{
    sources_ = std::move(sources);
}

std::vector<std::string> YourShader::shownPictures(const ParameterValues& values) const
{
    const auto& table = static_cast<const Table&>(values.table());
    std::vector<std::string> sources;
    for (std::size_t i = 0; table.work && i < table.ofInputs.size(); ++i)
        if (const std::string source = table.sourceOf(i, values); !source.empty() && table.work->readsPicture(i))
            sources.push_back(source);
    return sources;
}

glm::ivec2 YourShader::screenSize(const ParameterValues& values, std::optional<glm::ivec2> alone) const
{
    const int width = values[table_.screenWidth];
    return alone ? glm::max(*alone, glm::ivec2(1)) : glm::ivec2(width, std::max(width * 2 / 3, 1));
}

glm::ivec2 YourShader::pictureSize(const ParameterValues& values, std::optional<glm::ivec2> alone) const
{
    const glm::ivec2 size = screenSize(values, alone);
    const double scale = std::min(1.0, static_cast<double>(values[table_.pictureSide]) / std::max(size.x, size.y));
    return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * scale)), glm::ivec2(1));
}

void YourShader::plan(const PlanContext& context, render::FramePlan& plan) const
{
    if (shownPictures(context.values).empty())
        planFrom(context, {}, plan);
    else
        planShowing(context, {}, {}, plan);
}

void YourShader::planFrom(const PlanContext& context, const render::PersistentState& kept,
                          render::FramePlan& plan) const
{
    const auto* prepared = static_cast<const PreparedShader*>(context.prepared);
    planScreen(context, kept, prepared ? prepared->ofInputs : std::vector<LoadedPicture>(), plan);
}

void YourShader::planShowing(const PlanContext& context, const render::PersistentState& kept,
                             const PlanPicture& picture, render::FramePlan& plan) const
{
    const auto* prepared = static_cast<const PreparedShader*>(context.prepared);
    if (!prepared || !prepared->table().work) return planFrom(context, kept, plan);
    if (!picture) {
        render::Pass dark =
            portalPass("your_shader/screen", "it shows this picture, and is dark in it",
                       commonValues(table_, prepared->values), "your_shader/screen.frag", screenPortal(), context);
        dark.inputs.push_back({UNIT_EXHIBIT_A, blackPicture()});
        return plan.add(std::move(dark));
    }
    std::vector<LoadedPicture> ofInputs = prepared->ofInputs;
    const YourShaderTable& table = prepared->table();
    for (std::size_t i = 0; i < ofInputs.size(); ++i) {
        const std::string source = table.sourceOf(i, prepared->values);
        if (source.empty() || !table.work->readsPicture(i)) continue;
        ofInputs[i].shown = picture(source, plan);
        if (!ofInputs[i].shown)
            plan.warn("your_shader/picture of " + source,
                      "There is no exhibit “" + source + "” here; a black picture takes its place.");
    }
    planScreen(context, kept, ofInputs, plan);
}

void YourShader::planScreen(const PlanContext& context, const render::PersistentState& kept,
                            const std::vector<LoadedPicture>& ofInputs, render::FramePlan& plan) const
{
    const auto* prepared = static_cast<const PreparedShader*>(context.prepared);
    if (!prepared || !prepared->table().work || prepared->isLeftOff)
        return plan.skip("your_shader/screen", "it is not loaded");
    const ParameterValues& values = prepared->values;
    const Work& work = *prepared->table().work;
    glm::ivec2 size =
        screenSize(values, context.alone ? std::optional(plan.view.raster.size) : std::optional<glm::ivec2>());
    const bool isEdited = !context.alone && !values[table_.document].empty();
    if (isEdited && isFirstPicture(work, kept, plan)) size = glm::max(size / 2, glm::ivec2(1));
    const WorkShot shot{
        work,          prepared->table(), values, ofInputs, prepared->files, size, shaderTime({values, context.time}),
        !context.alone};
    const std::optional<WorkPicture> picture = planWork(shot, kept, plan);
    if (!picture) return;
    render::Pass pass = portalPass("your_shader/screen", "in view", commonValues(table_, values),
                                   "your_shader/screen.frag", screenPortal(), context);
    pass.inputs.push_back({UNIT_EXHIBIT_A, picture->image});
    if (values[table_.markInvalid]) {
        pass.shader.defines.push_back("MARKED_IMAGES " + std::to_string(picture->floats.size()));
        for (std::size_t i = 0; i < picture->floats.size(); ++i)
            pass.inputs.push_back({i == 0 ? UNIT_EXHIBIT_B : UNIT_EXHIBIT_C, picture->floats[i]});
    }
    pass.reads = picture->reads;
    if (isEdited && !work.isKept) {
        render::Pass record = recordOfFirstPicture(work);
        pass.reads.insert(pass.reads.end(), record.writes.begin(), record.writes.end());
        plan.add(std::move(record));
    }
    plan.add(std::move(pass));
}

void YourShader::wasDrawn(const render::FrameReport& report) const
{
    const bool ranPasses = std::any_of(report.ran.begin(), report.ran.end(), [](const render::StepReport& step) {
        return step.name.starts_with("your_shader/") && step.name != "your_shader/screen" &&
               !step.name.starts_with("your_shader/picture of ");
    });
    if (ranPasses) CrashGuard::ofProcess().drawn();
}

double YourShader::shaderTime(const ExhibitState& state) const
{
    const double clock = state.values[table_.animate] && std::isfinite(state.time) ? state.time : 0;
    return std::clamp(state.values[table_.moment] + clock, -1e7, 1e7);
}

std::optional<std::size_t> YourShader::gripUnder(const ExhibitState& state, const render::Ray& ray, double reach) const
{
    const std::optional<glm::dvec2> place = placeUnder(ray);
    if (!place || *place != glm::clamp(*place, 0.0, 1.0)) return std::nullopt;
    return gripAt(static_cast<const Table&>(state.values.table()), state.values, *place,
                  reach / (2.0 * screenPortal().halfSize));
}

ParameterChanges YourShader::pointed(const ExhibitState& state, std::size_t grip, PointerEvent event,
                                     const render::Ray& ray) const
{
    const std::optional<glm::dvec2> place = placeUnder(ray);
    if (!place) return {};
    return pointedAt(static_cast<const Table&>(state.values.table()), grip, event, glm::clamp(*place, 0.0, 1.0));
}

bool YourShader::takesKeys(const ExhibitState& state) const
{
    const auto& table = static_cast<const Table&>(state.values.table());
    return table.work && table.work->readsKeys;
}

ParameterChanges YourShader::keyed(const ExhibitState& state, int code, bool isDown) const
{
    return keyedAt(static_cast<const Table&>(state.values.table()), state.values, code, isDown, shaderTime(state));
}

std::optional<ParameterChanges> YourShader::pushed(const ExhibitState& state, std::size_t parameter) const
{
    return pushedAt(static_cast<const Table&>(state.values.table()), state.values, parameter, shaderTime(state));
}

}  // namespace vitrine::guest
