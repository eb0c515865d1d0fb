#include "render/gl/renderer.h"

#include "render/failure.h"
#include "render/gl/context.h"
#include "render/gl/draw_scopes.h"
#include "render/gl/family_inputs.h"
#include "render/gl/frame_block.h"
#include "render/gl/frame_clock.h"
#include "render/gl/framebuffers.h"
#include "render/gl/mipmaps.h"
#include "render/gl/pass_state.h"
#include "render/gl/program_cache.h"
#include "render/gl/resources.h"
#include "render/gl/screen.h"
#include "render/gl/unbounded_time.h"
#include "render/gl/uniform_allocator.h"
#include "render/gl/uploads.h"
#include "render/measure/clock.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <thread>

namespace vitrine::render::gl {
namespace {

/// Ranges of a pass's blocks in the uniform buffer.
struct PassRanges {
    UniformAllocator::Range frame;
    std::vector<UniformAllocator::Range> temporal;  ///< One for each slice that runs in this frame.
    std::vector<std::pair<int, UniformAllocator::Range>> blocks;
    std::vector<UniformAllocator::Range> objects;
    // Replace `blocks` and `objects` if the last good program of the family is used.
    std::vector<std::pair<int, UniformAllocator::Range>> lastBlocks;
    std::vector<UniformAllocator::Range> lastObjects;
};

void countDraws(const Pass& pass, std::map<std::string, std::int64_t>& counters)
{
    for (const Draw& draw : pass.draws) {
        ++counters["draws"];
        const std::int64_t triangles = draw.mesh ? static_cast<std::int64_t>(draw.mesh->indices.size() / 3) : 1;
        counters["triangles"] += triangles * draw.instances;
    }
    for (const auto& [name, count] : pass.counts) counters[name] += count;
}

HistoryRecord recordOf(const History& history, const FramePlan& plan)
{
    return {history.image, history.view.value_or(plan.view), plan.time, history.dependencies};
}

}  // namespace

/// State shared by sibling renderers.
struct Renderer::Shared {
    ProgramCache programs;
    Uploads uploads;
};

struct Renderer::State {
    ContextInfo info = currentContextInfo();
    std::shared_ptr<Shared> shared;
    ProgramCache& programs;
    Uploads& uploads;
    Resources resources;
    UniformAllocator arena;
    VertexArrayName noVertices;
    PersistentState kept;
    LastInputs lastInputs;
    std::map<std::string, std::set<std::string>> writersOfKept;  ///< Image -> passes with a key that wrote it.
    bool timeSteps = false;
    std::thread::id thread = std::this_thread::get_id();
    std::function<bool()> isCanceled;
    UnboundedTime unbounded{info.software};
    Screen screen;  ///< Target of `screenPixels`.

    explicit State(std::shared_ptr<Shared> common)
        : shared(std::move(common)), programs(shared->programs), uploads(shared->uploads)
    {
        GLuint name = 0;
        glCreateVertexArrays(1, &name);
        noVertices = VertexArrayName(name);
    }

    /// Returns the pass's FRAME block: for its own view, the whole picture (image with own pixels), or the plan's view.
    UniformAllocator::Range frameRange(const Pass& pass, const FramePlan& plan, UniformAllocator::Range planFrame)
    {
        const ImageInfo* own = nullptr;
        for (const std::string& name : outputsOf(pass))
            if (const auto image = plan.images().find(name);
                image != plan.images().end() && image->second.hasOwnPixels())
                own = &image->second;
        if (!pass.view && !own) return planFrame;
        const View view = pass.view ? *pass.view : viewOfOwnPixels(plan.view, *own);
        return arena.add(std140Bytes(frameBlock(view, plan.time, own ? 0 : plan.sample, plan.seed)));
    }

    PassRanges gather(const Pass& pass, const FramePlan& plan, UniformAllocator::Range planFrame,
                      const std::set<std::string>& lost)
    {
        PassRanges ranges;
        ranges.frame = frameRange(pass, plan, planFrame);
        if (pass.temporal.used) {
            const std::vector<std::string> inputs = inputsOf(pass);
            // The plan may have been made for the state of another renderer, or for an earlier state of this one.
            const bool missing = std::any_of(lost.begin(), lost.end(), [&](const std::string& image) {
                return std::any_of(inputs.begin(), inputs.end(), [&](const std::string& name) {
                    return name == previous(image) || (name == image && plan.slicedImages().contains(image) &&
                                                       pass.sliceCount == 1 && !madeByNow(plan, image));
                });
            });
            for (int part = pass.temporal.firstSlice; part < pass.temporal.endSlice; ++part)
                ranges.temporal.push_back(
                    arena.add(std140Bytes(temporalBlock(pass, part, pass.temporal.valid && !missing))));
        }
        ranges.blocks = blockRanges(pass.blocks);
        for (const Draw& draw : pass.draws) ranges.objects.push_back(objectRange(draw.object));
        if (const FamilyInputs* last = lastInputs.ofOthers(pass)) {
            ranges.lastBlocks = blockRanges(last->blocks);
            for (const Bytes& object : last->objects) ranges.lastObjects.push_back(objectRange(object));
        }
        return ranges;
    }

    std::vector<std::pair<int, UniformAllocator::Range>> blockRanges(const std::map<int, Bytes>& blocks)
    {
        std::vector<std::pair<int, UniformAllocator::Range>> ranges;
        for (const auto& [binding, bytes] : blocks)
            if (!bytes.empty()) ranges.emplace_back(binding, arena.add(bytes));
        return ranges;
    }

    UniformAllocator::Range objectRange(const Bytes& object)
    {
        return object.empty() ? UniformAllocator::Range{} : arena.add(object);
    }

    /// Collects the blocks of all passes and uploads them in one call.
    std::vector<PassRanges> uploadBlocks(const FramePlan& plan, const std::set<std::string>& lost)
    {
        arena.clear();
        const UniformAllocator::Range planFrame =
            arena.add(std140Bytes(frameBlock(plan.view, plan.time, plan.sample, plan.seed)));
        std::vector<PassRanges> ranges;
        for (const Pass& pass : plan.passes()) ranges.push_back(gather(pass, plan, planFrame, lost));
        arena.upload();
        return ranges;
    }

    void countHeld(std::map<std::string, std::int64_t>& counters) const
    {
        counters["images"] = static_cast<std::int64_t>(resources.imageCount());
        counters["programs"] = static_cast<std::int64_t>(programs.size());
    }

    /// Returns whether this frame completes an image that a sliced pass draws.
    static bool madeByNow(const FramePlan& plan, const std::string& image)
    {
        return std::any_of(plan.passes().begin(), plan.passes().end(), [&](const Pass& pass) {
            const std::vector<std::string> written = outputsOf(pass);
            return pass.sliceCount > 1 && pass.temporal.endSlice == pass.sliceCount &&
                   std::find(written.begin(), written.end(), image) != written.end();
        });
    }

    void bindBuffers(const std::vector<BufferUse>& buffers)
    {
        for (const BufferUse& use : buffers) {
            if (use.texels != Texels::none) {
                const auto& bytes = std::get<std::shared_ptr<const Bytes>>(use.source);
                glBindTextureUnit(static_cast<GLuint>(use.binding), uploads.texels(bytes, use.texels));
                continue;
            }
            const auto* name = std::get_if<std::string>(&use.source);
            const GLuint buffer = name
                                      ? resources.buffer(*name)
                                      : uploads.bytes(std::get<std::shared_ptr<const Bytes>>(use.source)).buffer.name();
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(use.binding), buffer);
        }
    }

    void bindInputs(const std::vector<SampledTexture>& inputs)
    {
        for (const SampledTexture& input : inputs) {
            if (const auto* name = std::get_if<std::string>(&input.source))
                resources.image(*name).bind(input.unit);
            else
                uploads.texture(std::get<std::shared_ptr<const render::Texture>>(input.source)).bind(input.unit);
        }
    }

    /// Draws the pass and returns the program used.
    ProgramInUse run(const Pass& pass, const PassRanges& ranges, ProgramCache::Building building)
    {
        if (pass.work == Work::simulation) return {};
        ProgramInUse used = programs.use(pass.shader, building);
        const FamilyInputs* last = used.ofSources ? lastInputs.ofOthers(pass) : nullptr;
        // Another renderer drew with that program, so its inputs are not known here.
        if (used.ofSources && (!last || last->sources != *used.ofSources)) {
            used = programs.use(pass.shader, ProgramCache::Building::isWaitedFor);
            last = nullptr;
        }
        glUseProgram(used.program);
        arena.bind(BLOCK_FRAME, ranges.frame);
        for (const auto& [binding, range] : last ? ranges.lastBlocks : ranges.blocks) arena.bind(binding, range);
        bindInputs(pass.inputs);
        if (last) bindInputs(last->textures);
        if (used.fallback.empty()) lastInputs.keep(pass);
        bindBuffers(pass.buffers);
        if (last) bindBuffers(last->buffers);
        for (int part = pass.temporal.firstSlice; part < pass.temporal.endSlice; ++part) {
            if (pass.temporal.used)
                arena.bind(BLOCK_TEMPORAL, ranges.temporal[static_cast<std::size_t>(part - pass.temporal.firstSlice)]);
            if (pass.work == Work::compute)
                dispatch(pass, resources);
            else
                raster(pass, last ? ranges.lastObjects : ranges.objects, part == pass.temporal.firstSlice);
        }
        if (std::any_of(pass.buffers.begin(), pass.buffers.end(),
                        [](const BufferUse& use) { return use.access != Access::read; }))
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
        for (const std::string& name : pass.mipmaps) makeMipmaps(resources.target(name), programs);
        // A slice drawn by a fallback program is drawn again with the right one.
        if (pass.sliceCount == 1 || (pass.temporal.endSlice == pass.sliceCount && used.fallback.empty()))
            for (const std::string& name : outputsOf(pass)) resources.finished(name);
        return used;
    }

    void raster(const Pass& pass, const std::vector<UniformAllocator::Range>& objects, bool clears)
    {
        bindTarget(pass, resources, clears);
        applyState(pass.state);
        if (pass.unbounded && unbounded.isLimited()) {
            const glm::ivec2 size = resources.target(pass.colors.at(0).image).size(pass.colors[0].level);
            while (const std::optional<glm::ivec2> rows = unbounded.nextBand(size)) {
                limitTo(pass.columns, *rows);
                drawAll(pass, objects);
                glFinish();
                if (isCanceled && isCanceled()) break;  // The loop over the passes abandons the frame.
            }
        } else {
            limitTo(pass.columns);
            drawAll(pass, objects);
        }
        limitTo(std::nullopt);
    }

    void drawAll(const Pass& pass, const std::vector<UniformAllocator::Range>& objects)
    {
        for (std::size_t i = 0; i < pass.draws.size(); ++i) {
            const Draw& draw = pass.draws[i];
            bindInputs(draw.inputs);
            bindBuffers(draw.buffers);
            arena.bind(BLOCK_OBJECT, objects[i]);
            glFrontFace(draw.mirrored ? GL_CW : GL_CCW);
            if (draw.cull) applyCulling(*draw.cull);
            if (draw.mesh) {
                uploads.mesh(draw.mesh).draw(draw.instances);
            } else {
                glBindVertexArray(noVertices.name());
                glDrawArraysInstanced(GL_TRIANGLES, 0, 3, draw.instances);
            }
        }
    }

    /// Discards the records of these images, whose content is lost.
    void forget(const std::set<std::string>& images)
    {
        for (const std::string& image : images) {
            for (const std::string& pass : writersOfKept[image]) {
                kept.passes.erase(pass);
                kept.slices.erase(pass);
            }
            writersOfKept.erase(image);
            kept.histories.erase(image);
        }
    }

    /// Passes from `first` on did not run: images that they share with passes that ran must be drawn again completely.
    void forgetFrom(const FramePlan& plan, std::size_t first)
    {
        for (std::size_t i = first; i < plan.passes().size(); ++i)
            if (plan.passes()[i].contentHash) {
                const std::vector<std::string> outputs = outputsOf(plan.passes()[i]);
                forget({outputs.begin(), outputs.end()});
            }
    }

    [[nodiscard]] bool abandoned() const
    {
        // A software renderer draws only when it is waited for. Without the wait, all work would still be pending at
        // the last check. llvmpipe also keeps each pending pass with its textures, deleted ones included, in one of up
        // to 64 scenes, and clears a scene only when it needs it again: of two passes, it needs the same one.
        if (info.software) glFinish();
        return isCanceled && isCanceled();
    }

    void remember(const Pass& pass, const FramePlan& plan, const std::set<std::string>& lost)
    {
        const std::vector<std::string> written = outputsOf(pass);
        // If the image with the first slices was lost, the later slices are useless.
        if (pass.temporal.firstSlice > 0 &&
            std::any_of(written.begin(), written.end(), [&](const std::string& image) { return lost.contains(image); }))
            return;
        for (const std::string& image : written)
            if (const auto state = plan.histories().find(image); state != plan.histories().end())
                kept.histories[image] = recordOf(state->second.history, plan);
        if (!pass.contentHash) return;
        for (const std::string& image : written) writersOfKept[image].insert(pass.name);
        const bool complete = pass.temporal.endSlice == pass.sliceCount;
        if (pass.sliceCount > 1) {
            SliceProgress& progress = kept.slices[pass.name];
            progress = {*pass.contentHash, pass.temporal.endSlice, progress.completedOnce || complete};
        }
        if (pass.temporal.provisional)
            kept.passes.erase(pass.name);
        else if (complete)
            kept.passes[pass.name] = *pass.contentHash;
    }

    /// Returns whether the outputs have to be drawn again: a fallback program drew the pass or an image that it reads.
    /// Notes them in `provisional`.
    bool isProvisional(const Pass& pass, const ProgramInUse& used, std::set<std::string>& provisional)
    {
        const std::vector<std::string> read = inputsOf(pass), written = outputsOf(pass);
        const bool is = !used.fallback.empty() || std::any_of(read.begin(), read.end(), [&](const std::string& image) {
            return provisional.contains(image);
        });
        if (!is) return false;
        provisional.insert(written.begin(), written.end());
        kept.passes.erase(pass.name);
        return true;
    }

    /// Records that an unbounded pass is not drawn, or only in part.
    void leaveOut(const Pass& pass, FrameReport& report)
    {
        const std::vector<std::string> outputs = outputsOf(pass);
        forget({outputs.begin(), outputs.end()});
        if (!report.stopped.empty())
            return report.skipped.push_back({pass.name, message("the time is over").english(), pass.work});
        report.stopped = pass.name;
        if (unbounded.isTooSlow(*pass.unbounded)) kept.stopped.insert(*pass.unbounded);
        report.unfinished = true;
    }

    /// Runs the passes in order. An exception, `Abandoned` included, leaves the renderer as if the remaining passes had
    /// never been planned.
    void runPasses(const FramePlan& plan, const std::vector<PassRanges>& ranges, const std::set<std::string>& lost,
                   FrameClock& clock, std::vector<SamplesQuery>& samplesQueries, FrameReport& report)
    {
        const auto building = plan.allSlices ? ProgramCache::Building::isWaitedFor : ProgramCache::Building::goesOn;
        programs.begin(plan.passes(), building);
        std::size_t next = 0;
        std::set<std::string> provisional;
        try {
            for (; next < plan.passes().size(); ++next) {
                const Pass& pass = plan.passes()[next];
                if (abandoned()) throw Abandoned();
                if (pass.unbounded && unbounded.isOver()) {
                    leaveOut(pass, report);
                    continue;
                }
                const DebugGroup group(pass.name.c_str());
                if (pass.countSamples) samplesQueries.emplace_back();
                const ProgramInUse used = run(pass, ranges[next], building);
                if (pass.countSamples) SamplesQuery::end();
                if (pass.unbounded && abandoned()) throw Abandoned();  // It may have ended between two bands.
                if (pass.unbounded && unbounded.isOver())
                    leaveOut(pass, report);
                else if (!isProvisional(pass, used, provisional))
                    remember(pass, plan, lost);
                report.unfinished = report.unfinished || used.building;
                const std::string& how = used.fallback.empty() ? used.specialized : used.fallback;
                report.ran.push_back({pass.name, how.empty() ? pass.reason : pass.reason + ", " + how, pass.work, -1,
                                      pass.bound, pass.effects, pass.variant});
                if (timeSteps) clock.mark();
                countDraws(pass, report.counters);
            }
        } catch (...) {
            forgetFrom(plan, next);
            throw;
        }
    }
};

Renderer::Renderer() : Renderer(std::make_unique<State>(std::make_shared<Shared>())) {}

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state))
{
    if (const Message why = whyUnusable(state_->info); !why.empty()) throw Failure(ErrorKind::openGl, why);
}

Renderer::~Renderer() = default;

std::unique_ptr<Renderer> Renderer::sibling() const
{
    return std::unique_ptr<Renderer>(new Renderer(std::make_unique<State>(state_->shared)));
}

std::vector<Stored> Renderer::stored() const
{
    std::vector<Stored> all = state_->uploads.stored();
    const std::vector<Stored> own = state_->resources.stored();
    all.insert(all.begin(), own.begin(), own.end());
    all.push_back({"programs", static_cast<std::int64_t>(state_->programs.size()), 0});
    return all;
}

FrameReport Renderer::draw(const FramePlan& given)
{
    State& s = *state_;
    std::optional<FramePlan> deferred;
    if (s.info.software) deferred = given.withDeferredShading();
    const FramePlan& plan = deferred ? *deferred : given;
    if (std::this_thread::get_id() != s.thread)
        throw std::logic_error("a renderer draws on the thread that made it, and on no other");
    FrameReport report;
    report.unfinished = plan.unfinished();
    report.skipped = plan.skipped();
    const ClockChoice& choice = trustedClock(s.info.software);
    report.clock = choice.name;
    report.clockTrusted = choice.trusted;
    const glm::ivec2 size = plan.view.raster.drawn();
    if (size.x <= 0 || size.y <= 0) return report;

    const CallersFramebuffer callers;
    glFinish();
    const double wallStart = wallSeconds();
    FrameClock clock(choice.method);
    clock.mark();
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    s.uploads.sweep();
    s.programs.beginFrame();
    const std::vector<std::string> notHeld = s.resources.prepare(plan);
    const std::set<std::string> lost(notHeld.begin(), notHeld.end());
    s.forget(lost);
    const std::int64_t framebuffersBefore = s.resources.framebuffersMade();

    s.unbounded.beginFrame();
    const std::vector<PassRanges> ranges = s.uploadBlocks(plan, lost);
    std::vector<SamplesQuery> samplesQueries;
    if (s.timeSteps) clock.mark();
    s.runPasses(plan, ranges, lost, clock, samplesQueries, report);
    s.programs.dropIdle();
    clock.mark();
    glFinish();
    report.wallMilliseconds = 1e3 * (wallSeconds() - wallStart);
    for (const SamplesQuery& query : samplesQueries) report.counters["samples"] += query.result();
    report.counters["passes"] = static_cast<std::int64_t>(plan.passes().size());
    report.counters["framebuffers made"] = s.resources.framebuffersMade() - framebuffersBefore;
    s.countHeld(report.counters);
    const std::vector<double> intervals = clock.seconds();
    for (const double seconds : intervals) report.milliseconds += 1e3 * seconds;
    if (s.timeSteps)  // The first interval covers preparation: images and blocks.
        for (std::size_t i = 0; i < report.ran.size(); ++i) report.ran[i].milliseconds = 1e3 * intervals[i + 1];
    report.overheadMilliseconds = 1e3 * choice.overheadSeconds * static_cast<double>(intervals.size());
    return report;
}

Image Renderer::read(const std::string& name)
{
    const Texture& texture = state_->resources.image(name);
    const bool depth = texture.format() == Format::depth32f;
    const bool single =
        depth || texture.format() == Format::r8 || texture.format() == Format::r16f || texture.format() == Format::r32f;
    const glm::ivec2 size = texture.size();
    const int channels = single ? 1 : 4;
    Image raw(size.x, size.y * texture.layers(), channels);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture.name(), 0, depth ? GL_DEPTH_COMPONENT : (single ? GL_RED : GL_RGBA), GL_FLOAT,
                      static_cast<GLsizei>(raw.pixels.size() * sizeof(float)), raw.pixels.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    Image flipped(raw.width, raw.height, raw.channels);
    const auto row = static_cast<std::ptrdiff_t>(raw.width) * raw.channels;
    for (std::ptrdiff_t y = 0; y < raw.height; ++y)
        std::copy_n(raw.pixels.begin() + (raw.height - 1 - y) * row, row, flipped.pixels.begin() + y * row);
    return flipped;
}

Bytes Renderer::readBuffer(const std::string& name)
{
    Bytes bytes(static_cast<std::size_t>(state_->resources.bufferBytes(name)));
    glGetNamedBufferSubData(state_->resources.buffer(name), 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
    return bytes;
}

const PersistentState& Renderer::persistentState() const
{
    return state_->kept;
}

int Renderer::largestSide() const
{
    return std::min(state_->info.maxTextureSize, 16384);
}

void Renderer::abandonWhen(std::function<bool()> isCanceled)
{
    state_->isCanceled = std::move(isCanceled);
}

void Renderer::stopUnboundedAfter(double seconds)
{
    state_->unbounded.setLimit(seconds);
}

ScreenPixels Renderer::screenPixels(const std::string& image, glm::ivec2 screen, glm::ivec2 offset, glm::ivec2 part)
{
    State& s = *state_;
    if (part.x <= 0 || part.y <= 0 || !s.resources.has(image)) return {};
    s.screen.bind(screen, offset, part);
    applyState(RasterState{});
    glUseProgram(s.programs.use({"lib/fullscreen.vert", "lib/present.frag", "", {}}).program);
    s.resources.image(image).bind(UNIT_SOURCE);
    glBindVertexArray(s.noVertices.name());
    glFrontFace(GL_CCW);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return s.screen.read(offset, part);
}

void Renderer::buildInBackground(std::shared_ptr<SharedContext> context)
{
    state_->programs.buildWith(std::move(context));
}

void Renderer::buildBetter(const FramePlan& plan)
{
    for (const Pass& pass : plan.passes())
        if (pass.shader.specialized) (void)state_->programs.useSpecialized(pass.shader);
}

void Renderer::sweep()
{
    state_->uploads.sweep();
}

void Renderer::timeSteps(bool on)
{
    state_->timeSteps = on;
}

bool Renderer::reloadChangedShaders()
{
    return state_->programs.reloadChanged();
}

const std::vector<ShaderProblem>& Renderer::problems() const
{
    return state_->programs.problems();
}

const std::vector<ProgramBuild>& Renderer::builds() const
{
    return state_->programs.builds();
}

void Renderer::abandon()
{
    state_->resources.abandon();
    state_->uploads.abandon();
    state_->programs.abandon();
    state_->arena.abandon();
    state_->noVertices.abandon();
    state_->screen.abandon();
}

}  // namespace vitrine::render::gl
