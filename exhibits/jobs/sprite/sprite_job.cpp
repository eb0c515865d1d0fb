#include "exhibits/jobs/sprite/sprite_job.h"

#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/jobs/sprite/sprite_animation.h"
#include "exhibits/jobs/sprite/sprite_description.h"
#include "exhibits/jobs/sprite/sprite_files.h"
#include "render/failure.h"

namespace vitrine::jobs {
namespace {

constexpr std::int64_t draftPixels = 1U << 20U;  // Most pixels of all frames of a preview.

const SpriteSubject& objectOf(const JobInputs& inputs)
{
    return *static_cast<const SpriteInputs&>(inputs).object;
}

/// Spec of the animated picture of a sheet with these options.
render::VideoSpec specOf(const ParameterValues& values, const SpriteSubject& object, double frameSeconds)
{
    return animationSpec(values, spriteRequest(values, object).frames, frameSeconds);
}

/// Sentence on why these values make no sheet; empty: they do.
std::string whyNotMade(const ParameterValues& values, const SpriteSubject& object)
{
    const SpriteTable& t = spriteTable();
    if (std::string why = whyNoSheet(spriteRequest(values, object)); !why.empty()) return why;
    if (values[t.palette] == SpritePalette::file && values[t.paletteFile].empty())
        return "No file of the palette is chosen; choose one, or another palette.";
    if (values[t.directionNames] == SpriteDirectionNames::compass && values[t.directions] > mostCompassDirections)
        return "There are compass points for at most 16 directions; choose fewer directions, or numbers as names.";
    try {
        const double seconds = sheetOptions(values, object, {}, {}).frameSeconds;
        const bool isAnimated = values[t.animated] != SpriteAnimation::none;
        return isAnimated ? render::whyNoVideo(specOf(values, object, seconds)) : std::string();
    } catch (const Failure& unknownAnimation) {
        return unknownAnimation.what();
    }
}

std::vector<Fact> factsOf(const ParameterValues& values, const SpriteSubject& object)
{
    const SpriteTable& t = spriteTable();
    const SpriteRequest request = spriteRequest(values, object);
    return {{"Frames", static_cast<double>(request.frames) * request.directions},
            {"Frame size", std::to_string(values[t.width]) + " × " + std::to_string(values[t.height]), "px"}};
}

}  // namespace

SpriteRun::SpriteRun(JobOrder order)
    : order_(std::move(order)), object_(static_cast<const SpriteInputs&>(*order_.inputs).object),
      shots_(order_.scene.state.values[order_.scene.subject], object_, spriteRequest(order_.values, *object_))
{
}

JobRun::Next SpriteRun::next() const
{
    if (!shots_.finished()) return Next::draw;
    return sheet_ ? Next::done : Next::work;
}

void SpriteRun::step(const Watch&)
{
    if (shots_.finished()) {
        makeSheet();
        return;
    }
    if (!backend_) backend_ = order_.backend ? order_.backend() : nullptr;
    if (!backend_) throw Failure(ErrorKind::openGl, "No sprites can be drawn: there is no graphics context.");
    shots_.step(*backend_);
    if (shots_.finished()) backend_.reset();
}

double SpriteRun::progress() const
{
    return shots_.progress();
}

std::string_view SpriteRun::doing() const
{
    return shots_.finished() ? "making the sheet" : "drawing frames";
}

void SpriteRun::makeSheet()
{
    const std::filesystem::path& out = order_.out;
    const auto& palette = static_cast<const SpriteInputs&>(*order_.inputs).palette;
    SpriteSheet sheet =
        spriteSheet(shots_.frames(), sheetOptions(order_.values, *object_, palette, out.filename().string()));
    sheet.settings = lookPreset(order_.scene.state.values[order_.scene.subject]);
    report_.warnings = sheet.warnings;
    report_.facts = factsOf(order_.values, *object_);
    report_.facts.push_back({"Colors", static_cast<double>(sheet.palette.size())});
    report_.facts.push_back(
        {"Sheet", std::to_string(sheet.color.width) + " × " + std::to_string(sheet.color.height), "px"});
    if (!out.empty()) {
        for (const render::NamedBytes& file : sheetBytes(sheet, order_.values, out))
            staged_.push_back(render::stagedFile(file.path, file.bytes));
        if (const std::filesystem::path file = animationFile(order_.values, out); !file.empty())
            staged_.push_back(
                stagedAnimation(sheet, order_.values, specOf(order_.values, *object_, sheet.frameSeconds), file));
        staged_.push_back(render::stagedFile(documentFile(out), documentText(SpriteJob(), order_, report_.facts)));
        for (const auto& file : staged_) report_.files.push_back(file->target());
    }
    sheet_ = std::make_unique<SpriteSheet>(std::move(sheet));
}

void SpriteRun::publish()
{
    render::publishAll(staged_);
}

JobNeeds SpriteJob::needs() const
{
    return {.subject = spriteLookName, .extensions = {"png"}, .inWindow = true, .preview = PreviewForm::sprites};
}

std::shared_ptr<const JobInputs> SpriteJob::read(const ParameterValues& values) const
{
    const SpriteTable& t = spriteTable();
    auto inputs = std::make_shared<SpriteInputs>(spriteSubject(values));
    if (values[t.palette] == SpritePalette::file && !values[t.paletteFile].empty())
        inputs->palette = readPalette(values[t.paletteFile]);
    return inputs;
}

JobPlan SpriteJob::plan(const ParameterValues& values, const JobScene&, const JobInputs& inputs,
                        const std::filesystem::path& out) const
{
    const SpriteSubject& object = objectOf(inputs);
    JobPlan plan;
    plan.warnings = object.warnings();
    plan.offers["animation"] = object.animations();
    plan.refusal = whyNotMade(values, object);
    const SpriteTable& t = spriteTable();
    if (values[t.godot] && values[t.normals] && values[t.normalY] == SpriteNormalY::down)
        plan.warnings.emplace_back("Godot reads normals with +Y up, and these point down; let +Y point up.");
    plan.facts = factsOf(values, object);
    if (out.empty()) return plan;
    if (plan.refusal.empty()) plan.refusal = refusedExtension(*this, out);
    plan.files = sheetFiles(values, out);
    if (const std::filesystem::path file = animationFile(values, out); !file.empty())
        plan.files.push_back({file, "animation"});
    plan.files.push_back({documentFile(out), "settings"});
    return plan;
}

std::unique_ptr<JobRun> SpriteJob::start(JobOrder order) const
{
    return std::make_unique<SpriteRun>(std::move(order));
}

ParameterValues SpriteJob::draft(const ParameterValues& values, const JobInputs& inputs) const
{
    const SpriteTable& t = spriteTable();
    ParameterValues fewer = values;
    fewer.set(t.frames, spriteRequest(values, objectOf(inputs)).frames);
    const std::int64_t each = std::int64_t{values[t.width]} * values[t.height];
    while (each * fewer[t.frames] * fewer[t.directions] > draftPixels) {
        if (fewer[t.frames] > 8)
            fewer.set(t.frames, fewer[t.frames] / 2);
        else if (fewer[t.directions] > 4)
            fewer.set(t.directions, fewer[t.directions] / 2);
        else if (fewer[t.frames] > 1)
            fewer.set(t.frames, fewer[t.frames] / 2);
        else if (fewer[t.directions] > 1)
            fewer.set(t.directions, 1);
        else
            break;
    }
    return fewer;
}

JobForecast SpriteJob::forecast(const ParameterValues& values, const FinishedDraft& draft,
                                const std::filesystem::path&) const
{
    const SpriteTable& t = spriteTable();
    const double cells = static_cast<double>(values[t.directions]) * std::max(values[t.frames], draft.values[t.frames]);
    return {{}, draft.seconds * cells / (static_cast<double>(draft.values[t.directions]) * draft.values[t.frames])};
}

}  // namespace vitrine::jobs
