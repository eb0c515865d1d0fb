#include "render/gl/frame_clock.h"

#include "render/gl/framebuffers.h"
#include "render/gl/pass_state.h"
#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/glsl/std140.h"
#include "render/measure/clock.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <array>
#include <map>
#include <string>

namespace vitrine::render::gl {
namespace {

#include "shaders/lib/clock_load_block.glsl"

constexpr int side = 256;                // 16 of llvmpipe's tiles: shows if a query measures only the last tile.
constexpr double smallestLoad = 0.7e-3;  // Seconds: far above the cost of starting and reading a clock.
// Four times as many stays below llvmpipe's limit of 65,535 loop iterations per invocation.
constexpr int mostRounds = 16000;
constexpr int repetitions = 3;
constexpr int attempts = 3;  // Several, because other programs may disturb one.

/// Draw of known cost with the GL objects it needs. The destructor undoes its bindings.
class KnownLoad {
public:
    KnownLoad()
        : target_({.name = "clock", .format = Format::rgba8}, {side, side}),
          program_(buildProgram(ShaderSource(), {"lib/fullscreen.vert", "lib/clock_load.frag", "", {}}))
    {
        GLuint name = 0;
        glCreateVertexArrays(1, &name);
        vertices_ = VertexArrayName(name);
        glCreateFramebuffers(1, &name);
        framebuffer_ = FramebufferName(name);
        glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, target_.name(), 0);
        glCreateBuffers(1, &name);
        block_ = BufferName(name);
        glNamedBufferStorage(name, static_cast<GLsizeiptr>(std140Bytes(ClockLoadBlock{}).size()), nullptr,
                             GL_DYNAMIC_STORAGE_BIT);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
        glViewport(0, 0, side, side);
        applyState(RasterState{});
        glFrontFace(GL_CCW);
        glUseProgram(program_.program.name());
        glBindVertexArray(vertices_.name());
        glBindBufferBase(GL_UNIFORM_BUFFER, BLOCK_OBJECT, block_.name());
    }
    ~KnownLoad()
    {
        glUseProgram(0);
        glBindVertexArray(0);
        glBindBufferBase(GL_UNIFORM_BUFFER, BLOCK_OBJECT, 0);
    }
    KnownLoad(const KnownLoad&) = delete;
    KnownLoad& operator=(const KnownLoad&) = delete;

    [[nodiscard]] bool usable() const { return static_cast<bool>(program_.program); }

    [[nodiscard]] ClockSample timed(int rounds, int load) const
    {
        const std::vector<std::byte> block = std140Bytes(ClockLoadBlock{.rounds = rounds * load});
        glNamedBufferSubData(block_.name(), 0, static_cast<GLsizeiptr>(block.size()), block.data());
        glFinish();
        FrameClock query(ClockMethod::query);
        const double cpu = processCpuSeconds();
        const double wall = wallSeconds();
        query.mark();
        glDrawArrays(GL_TRIANGLES, 0, 3);
        query.mark();
        glFinish();
        ClockSample sample{
            .load = static_cast<double>(load), .wall = wallSeconds() - wall, .cpu = processCpuSeconds() - cpu};
        sample.query = query.seconds().front();
        return sample;
    }

private:
    Texture target_;
    BuiltProgram program_;
    VertexArrayName vertices_;
    FramebufferName framebuffer_;
    BufferName block_;
    // Last member: it is destroyed first, so that the caller's framebuffer is bound again before the others are
    // deleted.
    CallersFramebuffer callers_;
};

/// Returns the seconds that the two marks around a frame cost by themselves: CPU time if that is the clock, else wall
/// time. Takes the median, because one interruption by another program may be longer than all marks together.
double overheadOf(ClockMethod method)
{
    const auto now = method == ClockMethod::cpu ? processCpuSeconds : wallSeconds;
    std::array<double, 31> costs{};
    glFinish();
    for (double& cost : costs) {
        const double start = now();
        FrameClock clock(method);
        clock.mark();
        clock.mark();
        if (method == ClockMethod::query) (void)clock.seconds();
        cost = now() - start;
    }
    std::nth_element(costs.begin(), costs.begin() + costs.size() / 2, costs.end());
    return costs[costs.size() / 2];
}

ClockChoice tryClocks(bool software)
{
    ClockChoice choice = chooseClock({}, software, 0);
    const KnownLoad load;
    if (!load.usable()) return choice;
    (void)load.timed(16, 1);  // The first draw compiles the program.
    int rounds = 64;
    while (rounds < mostRounds && load.timed(rounds, 1).wall < smallestLoad) rounds *= 2;
    for (int attempt = 0; attempt < attempts && !choice.trusted; ++attempt) {
        std::vector<ClockSample> samples;
        for (int i = 0; i < repetitions; ++i)
            for (const int k : {1, 2, 4}) samples.push_back(load.timed(std::min(rounds, mostRounds), k));
        choice = chooseClock(samples, software, 0);
    }
    choice.overheadSeconds = overheadOf(choice.method);
    return choice;
}

}  // namespace

void FrameClock::mark()
{
    if (method_ == ClockMethod::query) {
        GLuint name = 0;
        glCreateQueries(GL_TIMESTAMP, 1, &name);
        queries_.emplace_back(name);
        glQueryCounter(name, GL_TIMESTAMP);
        return;
    }
    glFinish();
    readings_.push_back(method_ == ClockMethod::cpu ? processCpuSeconds() : wallSeconds());
}

std::vector<double> FrameClock::seconds()
{
    for (const QueryName& query : queries_) {
        GLuint64 nanoseconds = 0;  // 32 bits would wrap after four seconds.
        glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &nanoseconds);
        readings_.push_back(1e-9 * static_cast<double>(nanoseconds));
    }
    queries_.clear();
    std::vector<double> between;
    for (std::size_t i = 1; i < readings_.size(); ++i) between.push_back(readings_[i] - readings_[i - 1]);
    return between;
}

const ClockChoice& trustedClock(bool software)
{
    static std::map<std::string, ClockChoice> known;
    const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string name = renderer ? renderer : "";
    const auto found = known.find(name);
    return found != known.end() ? found->second : known.emplace(name, tryClocks(software)).first->second;
}

}  // namespace vitrine::render::gl
