#include "render/gl/renderer.h"

#include "render/failure.h"
#include "render/gl/block_arena.h"
#include "render/gl/context.h"
#include "render/gl/frame_block.h"
#include "render/gl/frame_clock.h"
#include "render/gl/pass_state.h"
#include "render/gl/program_cache.h"
#include "render/gl/resources.h"
#include "render/gl/uploads.h"
#include "render/measure/clock.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <thread>

namespace vitrine::render::gl {
namespace {

/// Where a pass's blocks lie in the arena.
struct PassRanges {
    BlockArena::Range frame;
    std::vector<std::pair<int, BlockArena::Range>> blocks;
    std::vector<BlockArena::Range> objects;
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

/// Names what is drawn while it lives, for debuggers; closed also when a program does not build.
class DebugGroup {
public:
    explicit DebugGroup(const char* name) { glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name); }
    ~DebugGroup() { glPopDebugGroup(); }
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

/// Counts the samples that the draws between its making and `end` let pass.
class SamplesQuery {
public:
    SamplesQuery()
    {
        GLuint name = 0;
        glCreateQueries(GL_SAMPLES_PASSED, 1, &name);
        query_ = QueryName(name);
        glBeginQuery(GL_SAMPLES_PASSED, name);
    }
    static void end() { glEndQuery(GL_SAMPLES_PASSED); }
    /// Waits for the draws to finish.
    [[nodiscard]] std::int64_t result() const
    {
        GLint64 count = 0;
        glGetQueryObjecti64v(query_.name(), GL_QUERY_RESULT, &count);
        return count;
    }

private:
    QueryName query_;
};

}  // namespace

/// What siblings have in common.
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
    BlockArena arena;
    VertexArrayName noVertices;
    KeptKeys kept;
    std::map<std::string, std::set<std::string>> writersOfKept;  ///< Image -> passes whose key vouches for it.
    bool timeSteps = false;
    std::thread::id thread = std::this_thread::get_id();
    std::function<bool()> unwanted;
    TextureName screen;  ///< What `screenPixels` draws into.
    FramebufferName screenBuffer;
    glm::ivec2 screenSize{0};

    explicit State(std::shared_ptr<Shared> common) : shared(std::move(common)), programs(shared->programs), uploads(shared->uploads)
    {
        GLuint name = 0;
        glCreateVertexArrays(1, &name);
        noVertices = VertexArrayName(name);
    }

    PassRanges gather(const Pass& pass, const FramePlan& plan, BlockArena::Range planFrame)
    {
        PassRanges ranges;
        ranges.frame = planFrame;
        if (pass.view) {
            const FrameBlock block = frameBlock(*pass.view, plan.time, plan.sample, plan.seed);
            ranges.frame = arena.add(&block, sizeof block);
        }
        for (const auto& [binding, bytes] : pass.blocks)
            if (!bytes.empty()) ranges.blocks.emplace_back(binding, arena.add(bytes.data(), bytes.size()));
        for (const Draw& draw : pass.draws) ranges.objects.push_back(draw.object.empty() ? BlockArena::Range{} : arena.add(draw.object.data(), draw.object.size()));
        return ranges;
    }

    void bindInputs(const std::vector<Input>& inputs)
    {
        for (const Input& input : inputs) {
            if (const auto* name = std::get_if<std::string>(&input.source)) resources.image(*name).bind(input.unit);
            else uploads.texture(std::get<std::shared_ptr<const render::Texture>>(input.source)).bind(input.unit);
        }
    }

    void run(const Pass& pass, const PassRanges& ranges)
    {
        if (pass.work == Work::simulation) {
            if (pass.simulate) pass.simulate();
            return;
        }
        glUseProgram(programs.use(pass.shader));
        arena.bind(BLOCK_FRAME, ranges.frame);
        for (const auto& [binding, range] : ranges.blocks) arena.bind(binding, range);
        bindInputs(pass.inputs);
        if (pass.work == Work::compute) dispatch(pass, resources);
        else raster(pass, ranges);
        for (const std::string& name : pass.mipmaps) resources.image(name).makeMipmaps();
    }

    void raster(const Pass& pass, const PassRanges& ranges)
    {
        const Target target(pass, resources);
        applyState(pass.state);
        for (std::size_t i = 0; i < pass.draws.size(); ++i) {
            const Draw& draw = pass.draws[i];
            bindInputs(draw.inputs);
            arena.bind(BLOCK_OBJECT, ranges.objects[i]);
            glFrontFace(draw.mirrored ? GL_CW : GL_CCW);
            if (draw.mesh) {
                uploads.mesh(draw.mesh).draw(draw.instances);
            } else {
                glBindVertexArray(noVertices.name());
                glDrawArraysInstanced(GL_TRIANGLES, 0, 3, draw.instances);
            }
        }
    }

    /// What was written into these images is not there any more.
    void forget(const std::vector<std::string>& images)
    {
        for (const std::string& image : images) {
            for (const std::string& pass : writersOfKept[image]) kept.erase(pass);
            writersOfKept.erase(image);
        }
    }

    /// Passes from `first` on were not run: what they have in common with others that were is made again as a whole.
    void forgetFrom(const FramePlan& plan, std::size_t first)
    {
        for (std::size_t i = first; i < plan.passes().size(); ++i)
            if (plan.passes()[i].key) forget(outputsOf(plan.passes()[i]));
    }

    [[nodiscard]] bool abandoned() const
    {
        if (!unwanted) return false;
        // A software renderer draws when it is waited for: without that, all of the frame would lie ahead at the last question.
        if (info.software) glFinish();
        return unwanted();
    }

    void remember(const Pass& pass)
    {
        if (!pass.key) return;
        kept[pass.name] = *pass.key;
        for (const std::string& image : outputsOf(pass)) writersOfKept[image].insert(pass.name);
    }
};

Renderer::Renderer() : Renderer(std::make_unique<State>(std::make_shared<Shared>())) {}

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state))
{
    if (const std::string why = whyUnusable(state_->info); !why.empty()) throw Failure(Blame::openGl, why);
}

Renderer::~Renderer() = default;

std::unique_ptr<Renderer> Renderer::sibling() const
{
    return std::unique_ptr<Renderer>(new Renderer(std::make_unique<State>(state_->shared)));
}

std::vector<Stored> Renderer::stored() const
{
    std::vector<Stored> all = state_->uploads.stored();
    all.insert(all.begin(), state_->resources.stored());
    all.push_back({"programs", static_cast<std::int64_t>(state_->programs.size()), 0});
    return all;
}

FrameReport Renderer::draw(const FramePlan& plan)
{
    State& s = *state_;
    if (std::this_thread::get_id() != s.thread) throw std::logic_error("a renderer draws on the thread that made it, and on no other");
    FrameReport report;
    report.skipped = plan.skipped();
    const ClockChoice& choice = trustedClock(s.info.software);
    report.clock = choice.name;
    report.clockTrusted = choice.trusted;
    const glm::ivec2 size = plan.view.raster.drawn();
    if (size.x <= 0 || size.y <= 0) return report;

    GLint callersFramebuffer = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &callersFramebuffer);
    glFinish();
    const double wallStart = wallSeconds();
    FrameClock clock(choice.method);
    clock.mark();
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    s.uploads.sweep();
    s.programs.beginFrame();
    s.forget(s.resources.prepare(plan, size));

    s.arena.clear();
    const FrameBlock frame = frameBlock(plan.view, plan.time, plan.sample, plan.seed);
    const BlockArena::Range planFrame = s.arena.add(&frame, sizeof frame);
    std::vector<PassRanges> ranges;
    for (const Pass& pass : plan.passes()) ranges.push_back(s.gather(pass, plan, planFrame));
    s.arena.upload();

    std::vector<SamplesQuery> samplesQueries;
    if (s.timeSteps) clock.mark();
    std::size_t next = 0;
    try {
        for (; next < plan.passes().size(); ++next) {
            const Pass& pass = plan.passes()[next];
            if (s.abandoned()) throw Abandoned();
            const DebugGroup group(pass.name.c_str());
            if (pass.countSamples) samplesQueries.emplace_back();
            s.run(pass, ranges[next]);
            if (pass.countSamples) SamplesQuery::end();
            s.remember(pass);
            report.ran.push_back({pass.name, pass.reason, pass.work, -1, pass.bound, pass.effects});
            if (s.timeSteps) clock.mark();
            countDraws(pass, report.counters);
        }
    } catch (...) {
        s.forgetFrom(plan, next);
        throw;
    }
    s.programs.dropIdle();
    clock.mark();
    glFinish();
    report.wallMilliseconds = 1e3 * (wallSeconds() - wallStart);
    for (const SamplesQuery& query : samplesQueries) report.counters["samples"] += query.result();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(callersFramebuffer));
    report.counters["passes"] = static_cast<std::int64_t>(plan.passes().size());
    report.counters["images"] = static_cast<std::int64_t>(s.resources.imageCount());
    report.counters["programs"] = static_cast<std::int64_t>(s.programs.size());
    const std::vector<double> intervals = clock.seconds();
    for (const double seconds : intervals) report.milliseconds += 1e3 * seconds;
    if (s.timeSteps)  // The first interval prepares: images, blocks.
        for (std::size_t i = 0; i < report.ran.size(); ++i) report.ran[i].milliseconds = 1e3 * intervals[i + 1];
    report.overheadMilliseconds = 1e3 * choice.overheadSeconds * static_cast<double>(intervals.size());
    return report;
}

Image Renderer::read(const std::string& name)
{
    const Texture& texture = state_->resources.image(name);
    const bool depth = texture.format() == Format::depth32f;
    const bool single = depth || texture.format() == Format::r16f || texture.format() == Format::r32f;
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

const KeptKeys& Renderer::kept() const
{
    return state_->kept;
}

int Renderer::largestSide() const
{
    return std::min(state_->info.maxTextureSize, 16384);
}

void Renderer::abandonWhen(std::function<bool()> unwanted)
{
    state_->unwanted = std::move(unwanted);
}

ScreenPixels Renderer::screenPixels(const std::string& image, glm::ivec2 screen, glm::ivec2 offset, glm::ivec2 part)
{
    State& s = *state_;
    if (part.x <= 0 || part.y <= 0 || !s.resources.has(image)) return {};
    if (s.screenSize != screen) {
        GLuint name = 0;
        glCreateTextures(GL_TEXTURE_2D, 1, &name);
        s.screen = TextureName(name);
        glTextureStorage2D(name, 1, GL_RGBA8, screen.x, screen.y);
        glCreateFramebuffers(1, &name);
        s.screenBuffer = FramebufferName(name);
        glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, s.screen.name(), 0);
        s.screenSize = screen;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, s.screenBuffer.name());
    glViewport(offset.x, offset.y, part.x, part.y);
    applyState(RasterState{});
    glUseProgram(s.programs.use({"lib/fullscreen.vert", "lib/present.frag", "", {}}));
    s.resources.image(image).bind(UNIT_SOURCE);
    glBindVertexArray(s.noVertices.name());
    glFrontFace(GL_CCW);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ScreenPixels pixels{part.x, part.y, std::vector<std::uint8_t>(static_cast<std::size_t>(part.x) * static_cast<std::size_t>(part.y) * 4)};
    std::vector<std::uint8_t> fromBelow(pixels.rgba.size());
    glReadPixels(offset.x, offset.y, part.x, part.y, GL_RGBA, GL_UNSIGNED_BYTE, fromBelow.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    const auto row = static_cast<std::ptrdiff_t>(part.x) * 4;
    for (std::ptrdiff_t y = 0; y < part.y; ++y) std::copy_n(fromBelow.begin() + (part.y - 1 - y) * row, row, pixels.rgba.begin() + y * row);
    return pixels;
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

void Renderer::abandon()
{
    state_->resources.abandon();
    state_->uploads.abandon();
    state_->programs.abandon();
    state_->arena.abandon();
    state_->noVertices.abandon();
    state_->screen.abandon();
    state_->screenBuffer.abandon();
}

}  // namespace vitrine::render::gl
