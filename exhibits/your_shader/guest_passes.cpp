#include "exhibits/your_shader/guest_passes.h"

#include "exhibits/framework/table/derive.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/your_shader/guest_built_in.h"
#include "exhibits/your_shader/guest_glsl.h"
#include "exhibits/your_shader/guest_keys.h"
#include "exhibits/your_shader/guest_pictures.h"
#include "exhibits/your_shader/guest_sound.h"
#include "exhibits/your_shader/size_expression.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace vitrine::guest {
namespace {

constexpr std::int64_t mostBufferBytes = std::int64_t{1} << 30U;

std::string_view viewOf(const render::Bytes& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Plans the steps of one work.
class WorkPlan {
public:
    WorkPlan(const WorkShot& shot, const render::PersistentState& kept, render::FramePlan& plan)
        : shot_(shot), work_(shot.work), kept_(kept), plan_(plan)
    {
    }

    std::optional<WorkPicture> run()
    {
        if (!findSizes()) return std::nullopt;
        if (kept_.stopped.contains(timeKey())) {
            plan_.warnOfFile("your_shader/time",
                             "Your Shader: a frame of " + work_.path.string() +
                                 " takes too long here; lower its parameters or “Loop rounds”, or draw it smaller.",
                             "The frame stays empty.");
            return std::nullopt;
        }
        readPressedKeys();
        const double rate = shot_.values[shot_.table.rate];
        const double steps = std::floor(shot_.time * rate + 1e-6);
        if (!work_.isKept) {
            const auto frame = static_cast<std::int64_t>(std::clamp(steps, -2e9, 2e9));
            // A shader that reads no time is the same at every time, and is not drawn again.
            const StepTime time =
                work_.readsTime ? StepTime{shot_.time, steps > 0 ? 1 / rate : 0, rate, frame} : StepTime{.rate = rate};
            declareImages();
            planStep("your_shader/", "in view", 0, time, true);
            return picture(0);
        }
        if (steps > static_cast<double>(lastStep))
            plan_.warn("your_shader/steps", "Step " + std::to_string(lastStep) +
                                                " is shown, the last one that is computed; choose an earlier moment or "
                                                "a smaller rate.");
        const auto wanted = static_cast<std::int64_t>(std::clamp(steps, 0.0, static_cast<double>(lastStep)));
        declareImages();
        return picture(planSteps(wanted, rate));
    }

private:
    bool findSizes();
    void readPressedKeys();
    void declareImages();
    [[nodiscard]] std::string imageOf(std::size_t target, std::int64_t step) const;
    [[nodiscard]] glm::ivec2 sizeOf(std::string_view picture) const;
    /// The same for a pass, which has names for its channels, too: "iChannel0".
    [[nodiscard]] glm::ivec2 sizeIn(std::size_t pass, std::string_view picture) const;
    [[nodiscard]] std::optional<double> inputNumber(std::string_view name) const;
    [[nodiscard]] render::Bytes bytesOfInputs(const StepTime&) const;

    std::int64_t planSteps(std::int64_t wanted, double rate);
    [[nodiscard]] std::uint64_t identity(double rate) const;
    /// Identifies what the duration of a picture depends on, other than the moment.
    [[nodiscard]] std::uint64_t timeKey() const;
    [[nodiscard]] std::int64_t heldStep(std::uint64_t identity, std::int64_t wanted) const;
    void clearBefore0();
    void planStep(const std::string& namePrefix, const std::string& reason, std::int64_t step, const StepTime&,
                  bool hasKey);
    void markStep(std::int64_t step, std::uint64_t identity, bool isOnly);
    [[nodiscard]] std::vector<render::SampledTexture> inputsOf(const WorkPass&, std::int64_t step,
                                                               const StepTime&) const;
    [[nodiscard]] std::shared_ptr<const render::Texture> textureOf(const PassPicture&, const StepTime&) const;
    [[nodiscard]] glm::ivec2 sizeOf(const PassPicture&) const;
    /// Returns the picture of another exhibit that a pass reads; null: it reads something else.
    [[nodiscard]] const ShownPicture* shownBy(const PassPicture&) const;
    [[nodiscard]] render::Pass passOf(std::size_t i, std::int64_t step, const StepTime&, int face) const;
    [[nodiscard]] WorkPicture picture(std::int64_t step) const;

    /// States that say which step the images hold, for even and odd steps.
    [[nodiscard]] static std::string stateOf(std::int64_t step)
    {
        return step % 2 == 0 ? "your_shader.even" : "your_shader.odd";
    }
    [[nodiscard]] static std::string marker(std::int64_t step)
    {
        return step % 2 == 0 ? "your_shader/even step" : "your_shader/odd step";
    }
    [[nodiscard]] static std::uint64_t keyOf(std::uint64_t identity, std::int64_t step)
    {
        return render::Hash().addValue(identity).addValue(step).value();
    }

    const WorkShot& shot_;
    const Work& work_;
    const render::PersistentState& kept_;
    render::FramePlan& plan_;
    std::vector<glm::ivec2> sizes_;  ///< Sizes of the targets.
    std::vector<KeyPress> keys_;
};

std::optional<double> WorkPlan::inputNumber(std::string_view name) const
{
    for (std::size_t i = 0; i < work_.shader->inputs.size(); ++i) {
        const Input& input = work_.shader->inputs[i];
        const std::vector<std::size_t>& rows = shot_.table.ofInputs[i];
        if (input.name != name || rows.size() != 1) continue;
        const double* number = std::get_if<double>(&shot_.values.row(rows[0]));
        if (!number) return std::nullopt;
        if (input.type != InputType::choice) return shown(*number, shot_.values.rows()[rows[0]].unit);
        return input.choices[std::min(static_cast<std::size_t>(*number), input.choices.size() - 1)].value;
    }
    return std::nullopt;
}

bool WorkPlan::findSizes()
{
    std::int64_t bytes = 0;
    for (const Target& target : work_.targets) {
        glm::ivec2 size = shot_.size;
        for (const int axis : {0, 1}) {
            const PassSize made = passSize(axis == 0 ? target.width : target.height, shot_.size.x, shot_.size.y,
                                           shot_.size[axis], [&](std::string_view name) { return inputNumber(name); });
            if (!made.problem.empty()) {
                plan_.warn("your_shader/" + target.name, "The size of the buffer " + target.name +
                                                             " cannot be computed: " + made.problem.english() + '.');
                return false;
            }
            size[axis] = std::min(made.pixels, Limits::side);
        }
        sizes_.push_back(size);
        const int texelBytes = target.isCube ? 6 * 8 : target.isFloat ? 16 : 4;
        bytes += std::int64_t{size.x} * size.y * texelBytes * (target.isKept ? 2 : 1);
    }
    if (bytes <= mostBufferBytes) return true;
    plan_.warn("your_shader/buffers", "The buffers of the shader need " + std::to_string(bytes >> 20) +
                                          " MB, more than 1024 MB; draw a smaller picture.");
    return false;
}

void WorkPlan::readPressedKeys()
{
    if (!work_.readsKeys) return;
    KeyPresses read = readKeys(shot_.values[shot_.table.keys]);
    if (!read.problem.empty()) plan_.warn("your_shader/keys", read.problem.english());
    keys_ = std::move(read.presses);
}

std::string WorkPlan::imageOf(std::size_t target, std::int64_t step) const
{
    const std::string name = "your_shader.target" + std::to_string(target + 1);
    return work_.targets[target].isKept ? name + (step % 2 == 0 ? ".even" : ".odd") : name;
}

void WorkPlan::declareImages()
{
    const std::size_t shown = work_.passes.back().target;
    for (std::size_t i = 0; i < work_.targets.size(); ++i) {
        const Target& target = work_.targets[i];
        // The picture in the hall is seen from afar, and read there only.
        const bool hasLevels = target.hasLevels || (shot_.inHall && i == shown && !target.isRead);
        const auto side = static_cast<unsigned>(std::max(sizes_[i].x, sizes_[i].y));
        for (const std::int64_t step : {0, 1})
            plan_.image({.name = imageOf(i, step),
                         .format = target.isCube    ? render::Format::rgba16f
                                   : target.isFloat ? render::Format::rgba32f
                                                    : render::Format::rgba8,
                         .type = target.isCube ? render::TextureType::cube : render::TextureType::flat,
                         .size = sizes_[i],
                         .levels = hasLevels ? static_cast<int>(std::bit_width(side)) : 1,
                         .persistent = true,
                         .repeat = target.repeats,
                         .nearest = target.isNearest});
    }
    for (const WorkPass& pass : work_.passes)
        for (const PassPicture& picture : pass.pictures)
            if (isBuiltIn(picture.from)) planBuiltIn(picture.from, plan_);
}

glm::ivec2 WorkPlan::sizeOf(std::string_view name) const
{
    for (std::size_t i = 0; i < work_.targets.size(); ++i)
        if (work_.targets[i].name == name) return sizes_[i];
    for (std::size_t i = 0; i < work_.shader->inputs.size(); ++i)
        if (work_.shader->inputs[i].name == name) return sizeOf({.from = PassPicture::From::input, .index = i});
    return glm::ivec2(1);
}

glm::ivec2 WorkPlan::sizeOf(const PassPicture& picture) const
{
    if (picture.isTarget()) return sizes_[picture.index];
    if (isBuiltIn(picture.from)) return sizeOfBuiltIn(picture.from);
    if (const ShownPicture* shown = shownBy(picture)) return shown->size;
    const auto texture = textureOf(picture, {});
    return {texture->width, texture->height};
}

const ShownPicture* WorkPlan::shownBy(const PassPicture& picture) const
{
    if (picture.from != PassPicture::From::input || picture.index >= shot_.ofInputs.size()) return nullptr;
    const std::optional<ShownPicture>& shown = shot_.ofInputs[picture.index].shown;
    return shown ? &*shown : nullptr;
}

glm::ivec2 WorkPlan::sizeIn(std::size_t pass, std::string_view name) const
{
    int unit = 0;
    for (const PictureUse& use : picturesOf(*work_.shader, work_.shader->passes[pass])) {
        if (use.name == name && use.source == PictureUse::Source::channel)
            for (const PassPicture& picture : work_.passes[pass].pictures) {
                if (picture.unit == unit) return sizeOf(picture);
            }
        ++unit;
    }
    return sizeOf(name);
}

render::Bytes WorkPlan::bytesOfInputs(const StepTime& time) const
{
    return inputBytes(work_, shot_.table, shot_.values, time, [&](std::string_view name) { return sizeOf(name); });
}

/// Returns a hash of everything that the steps depend on. In the window the values are left out: the shader continues
/// from what its buffers hold, unless the visitor chose otherwise.
std::uint64_t WorkPlan::timeKey() const
{
    render::Hash hash;
    hash.addValue(work_.id).addValue(shot_.size);
    derive::addToKey(hash, shot_.values);
    return hash.value();
}

std::uint64_t WorkPlan::identity(double rate) const
{
    render::Hash hash;
    hash.addValue(work_.id).addValue(rate).addValue(shot_.values[shot_.table.loopRounds]);
    hash.addValue(shot_.values[shot_.table.restarts]);
    for (const glm::ivec2& size : sizes_) hash.addValue(size);
    for (const auto* pictures : {&shot_.ofInputs, &shot_.files})
        for (const LoadedPicture& picture : *pictures) hash.addValue(picture.id);
    const bool goesOn = !plan_.allSlices && shot_.values[shot_.table.afterChange] == ShaderChange::goesOn;
    if (!work_.isKept || goesOn) return hash.value();
    for (const LoadedPicture& picture : shot_.ofInputs)
        if (picture.shown) hash.addValue(picture.shown->key);
    // Each input counts by the value of its parameter. The value of an event in the shader differs from step to step.
    for (const std::vector<std::size_t>& rows : shot_.table.ofInputs)
        for (const std::size_t row : rows) {
            if (const auto* number = std::get_if<double>(&shot_.values.row(row))) hash.addValue(*number);
            if (const auto* color = std::get_if<glm::dvec3>(&shot_.values.row(row))) hash.addValue(*color);
        }
    for (const Real row : {shot_.table.mouseX, shot_.table.mouseY, shot_.table.pressX, shot_.table.pressY})
        hash.addValue(shot_.values[row]);
    hash.add(shot_.values[shot_.table.keys]);
    return hash.addValue(shot_.values[shot_.table.mouseDown]).value();
}

/// Returns the latest step up to `wanted` that the images hold; -1 if there is none.
std::int64_t WorkPlan::heldStep(std::uint64_t identity, std::int64_t wanted) const
{
    const auto holds = [&](std::int64_t step) {
        const auto found = kept_.passes.find(marker(step));
        return found != kept_.passes.end() && found->second == keyOf(identity, step);
    };
    // Step `wanted` may be drawn again, which needs the images of the step before it.
    if (holds(wanted + 1)) return -1;
    for (std::int64_t step = wanted; step >= 0; --step)
        if (holds(step)) return step;
    return -1;
}

std::int64_t WorkPlan::planSteps(std::int64_t wanted, double rate)
{
    const std::uint64_t id = identity(rate);
    const std::int64_t held = heldStep(id, wanted);
    std::int64_t last = wanted;
    if (!plan_.allSlices && shot_.values[shot_.table.animate]) last = std::min(wanted, held + stepsPerFrame);
    if (held < 0) clearBefore0();
    const std::int64_t first = std::min(held + 1, last);
    for (std::int64_t step = first; step <= last; ++step) {
        const auto number = static_cast<double>(step);
        const StepTime time{number / rate, step > 0 ? 1 / rate : 0, rate, step};
        const bool isLast = step == last;
        const std::string reason =
            isLast && last < wanted
                ? "step " + std::to_string(step) + " of " + std::to_string(wanted) + "; more follow in the next frames"
                : "step " + std::to_string(step);
        planStep(isLast ? "your_shader/" : "your_shader/step " + std::to_string(step) + '/', reason, step, time,
                 isLast);
        if (step + 1 >= last) markStep(step, id, first == last);
    }
    return last;
}

/// Empties what step 0 reads.
void WorkPlan::clearBefore0()
{
    for (std::size_t i = 0; i < work_.targets.size(); ++i) {
        if (!work_.targets[i].isKept) continue;
        render::Pass pass;
        pass.name = "your_shader/empty " + work_.targets[i].name;
        pass.reason = "the steps begin with empty buffers";
        pass.phase = render::PassPhase::simulate;
        pass.shader = meshDepth().shader;
        pass.colors = {render::Attachment::cleared(imageOf(i, 1))};
        if (plan_.images().at(imageOf(i, 1)).levels > 1) pass.mipmaps = {imageOf(i, 1)};
        plan_.add(std::move(pass));
    }
}

/// Returns the texture of a picture that no pass draws.
std::shared_ptr<const render::Texture> WorkPlan::textureOf(const PassPicture& picture, const StepTime& time) const
{
    using From = PassPicture::From;
    switch (picture.from) {
    case From::keyboard: return keyboardPicture(keys_, time);
    case From::file: return shot_.files[picture.index].texture ? shot_.files[picture.index].texture : blackPicture();
    case From::input:
    case From::waveform:
    case From::spectrum: break;
    default: return blackPicture();
    }
    const LoadedPicture& loaded = shot_.ofInputs[picture.index];
    const Input& input = work_.shader->inputs[picture.index];
    const int columns = input.high.empty() ? soundColumns : static_cast<int>(std::clamp(input.high[0], 1.0, 4096.0));
    if (input.type == InputType::audio) return waveformPicture(loaded.sound.get(), columns, time.seconds);
    if (input.type == InputType::spectrum) return spectrumPicture(loaded.sound.get(), columns, time.seconds);
    return loaded.texture ? loaded.texture : blackPicture();
}

std::vector<render::SampledTexture> WorkPlan::inputsOf(const WorkPass& pass, std::int64_t step,
                                                       const StepTime& time) const
{
    using From = PassPicture::From;
    std::vector<render::SampledTexture> inputs;
    for (const PassPicture& picture : pass.pictures) {
        if (picture.isTarget())
            inputs.push_back({picture.unit, imageOf(picture.index, picture.from == From::thisStep ? step : step + 1)});
        else if (isBuiltIn(picture.from))
            inputs.push_back({picture.unit, planBuiltIn(picture.from, plan_)});
        else if (const ShownPicture* shown = shownBy(picture))
            inputs.push_back({picture.unit, shown->image});
        else
            inputs.push_back({picture.unit, textureOf(picture, time)});
    }
    return inputs;
}

/// Returns a pass of a step, or that of one face of a cube map.
render::Pass WorkPlan::passOf(std::size_t i, std::int64_t step, const StepTime& time, int face) const
{
    static constexpr std::array<const char*, 6> faces{"+x", "-x", "+y", "-y", "+z", "-z"};
    const ParameterValues& values = shot_.values;
    const YourShaderTable& table = shot_.table;
    Mouse mouse{{values[table.mouseX], values[table.mouseY]}, values[table.mouseDown], {}};
    if (values[table.pressX] >= 0 && values[table.pressY] >= 0)
        mouse.pressedAt = glm::dvec2(values[table.pressX], values[table.pressY]);
    const WorkPass& of = work_.passes[i];
    const bool isCube = work_.targets[of.target].isCube;
    const std::string target = imageOf(of.target, step);
    render::Pass pass;
    pass.name = std::to_string(i + 1) + ' ' + work_.shader->passes[i].name;
    if (isCube) (pass.name += ' ') += faces[static_cast<std::size_t>(face)];
    pass.phase = render::PassPhase::simulate;
    pass.shader = {.vertex = generatedVertex,
                   .fragment = generatedFragment,
                   .defines = {"GUEST_ROUNDS " + std::to_string(values[table.loopRounds]) + 'u'},
                   .sources = of.sources};
    pass.blocks[BLOCK_EXHIBIT] = frameBytes(work_, {i, sizes_[of.target], face}, time, mouse,
                                            [&](std::string_view name) { return sizeIn(i, name); });
    pass.inputs = inputsOf(of, step, time);
    pass.colors = {isCube ? render::Attachment::clearedSlice(target, face) : render::Attachment::cleared(target)};
    pass.draws = {render::Draw{.instances = trianglesOf(*work_.shader)}};
    pass.unbounded = timeKey();
    if (plan_.images().at(target).levels > 1 && (!isCube || face == 5)) pass.mipmaps = {target};
    return pass;
}

/// Adds the passes of one step. With a key, they are left out while nothing that they depend on changes.
void WorkPlan::planStep(const std::string& namePrefix, const std::string& reason, std::int64_t step,
                        const StepTime& time, bool hasKey)
{
    const render::Bytes inputs = bytesOfInputs(time);
    std::vector<render::Pass> passes;
    render::Hash key;
    key.addValue(identity(time.rate)).addValue(step);
    if (work_.readsKeys) key.add(shot_.values[shot_.table.keys]);
    for (const LoadedPicture& picture : shot_.ofInputs)
        if (picture.shown) key.add(picture.shown->image).addValue(picture.shown->key);
    for (std::size_t i = 0; i < work_.passes.size(); ++i) {
        const Target& target = work_.targets[work_.passes[i].target];
        // Only the last step shows a picture.
        if (!hasKey && !target.isKept && !target.isRead) continue;
        for (int face = 0; face < (target.isCube ? 6 : 1); ++face) {
            render::Pass pass = passOf(i, step, time, face);
            pass.name.insert(0, namePrefix);
            pass.reason = reason;
            pass.blocks[BLOCK_PARAMETERS] = inputs;
            key.add(viewOf(pass.blocks[BLOCK_EXHIBIT]));
            passes.push_back(std::move(pass));
        }
    }
    key.add(viewOf(inputs));
    for (render::Pass& pass : passes) {
        if (hasKey) pass.contentHash = key.value();
        plan_.add(std::move(pass));
    }
}

/// Records that the images of this step are complete. The record is lost with any of them. A frame that is abandoned
/// between several steps leaves no step complete.
void WorkPlan::markStep(std::int64_t step, std::uint64_t identity, bool isOnly)
{
    render::Pass pass;
    pass.name = marker(step);
    pass.reason = "step " + std::to_string(step) + " is complete";
    pass.phase = render::PassPhase::simulate;
    pass.work = render::Work::simulation;
    pass.unbounded = timeKey();  // A step that was stopped is not complete.
    pass.writes = {stateOf(step)};
    for (std::size_t i = 0; i < work_.targets.size(); ++i)
        for (const std::int64_t each : {step, step + 1})
            if (work_.targets[i].isKept && (each == step || !isOnly)) pass.writes.push_back(imageOf(i, each));
    pass.contentHash = keyOf(identity, step);
    plan_.add(std::move(pass));
}

WorkPicture WorkPlan::picture(std::int64_t step) const
{
    WorkPicture picture{imageOf(work_.passes.back().target, step), {}, {}};
    if (!work_.isKept) return picture;
    picture.reads = {stateOf(0), stateOf(1)};
    for (std::size_t i = 0; i < work_.targets.size(); ++i) {
        if (!work_.targets[i].isKept) continue;
        picture.reads.push_back(imageOf(i, step));
        if (work_.targets[i].isFloat && !work_.targets[i].isCube && picture.floats.size() < mostMarkedImages)
            picture.floats.push_back(imageOf(i, step));
    }
    return picture;
}

}  // namespace

std::optional<WorkPicture> planWork(const WorkShot& shot, const render::PersistentState& kept, render::FramePlan& plan)
{
    return WorkPlan(shot, kept, plan).run();
}

}  // namespace vitrine::guest
