#include "tests/support/plan_text.h"

#include "render/hash.h"

#include <map>
#include <mutex>
#include <sstream>
#include <type_traits>

namespace vitrine::test {
namespace {

using namespace render;

template <typename T> std::string_view bytesIn(const std::vector<T>& values)
{
    static_assert(std::is_trivially_copyable_v<T>);
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Returns the description of an object, computed once. Keeps the object alive, so that its address is not used again.
template <typename T, typename F> std::string remembered(const std::shared_ptr<const T>& object, F describe)
{
    static std::mutex mutex;
    static std::map<std::shared_ptr<const T>, std::string> known;
    if (!object) return "nothing";
    const std::lock_guard lock(mutex);
    std::string& text = known[object];
    if (text.empty()) text = describe(*object);
    return text;
}

std::string textOf(const std::shared_ptr<const Mesh>& mesh)
{
    return remembered(mesh, [](const Mesh& m) {
        Hash hash;
        for (const Vertex& v : m.vertices)
            hash.addValue(v.position).addValue(v.normal).addValue(v.uv).addValue(v.extra);
        hash.add(bytesIn(m.indices));
        return m.name + '#' + std::to_string(m.vertices.size()) + '#' + std::to_string(hash.value());
    });
}

std::string textOf(const std::shared_ptr<const Texture>& picture)
{
    return remembered(picture, [](const Texture& t) {
        Hash hash;
        hash.add(bytesIn(t.bytes)).add(bytesIn(t.floats));
        return t.name + '#' + std::to_string(t.width) + 'x' + std::to_string(t.height) + 'x' +
               std::to_string(t.layers) + '#' + std::to_string(hash.value());
    });
}

struct Line {
    std::ostringstream text;

    template <typename T> Line& operator<<(const T& value)
    {
        if constexpr (std::is_enum_v<T>)
            text << static_cast<int>(value) << ' ';
        else
            text << value << ' ';
        return *this;
    }
    Line& operator<<(const Bytes& bytes) { return *this << Hash().add(bytesIn(bytes)).value(); }
    template <typename T> void values(const T& v) { *this << Hash().addValue(v).value(); }
    template <typename T> void all(const std::vector<T>& list)
    {
        text << '[';
        for (const T& one : list) *this << one;
        text << ']';
    }
    Line& operator<<(const Attachment& a)
    {
        *this << a.image << a.load << a.layer << a.level;
        values(a.clear);
        return *this;
    }
    Line& operator<<(const SampledTexture& input)
    {
        *this << input.unit;
        if (const auto* name = std::get_if<std::string>(&input.source)) return *this << *name;
        return *this << textOf(std::get<std::shared_ptr<const Texture>>(input.source));
    }
    Line& operator<<(const Draw& d)
    {
        *this << textOf(d.mesh) << d.instances << d.mirrored << d.object;
        all(d.inputs);
        return *this;
    }
    Line& operator<<(const ContributionBound& b) { return *this << b.relative << b.absolute << b.whyNone; }
    Line& operator<<(const Effect& e) { return *this << e.name << e.bound; }
};

std::string textOf(const Pass& p)
{
    Line line;
    line.text.precision(17);
    line << "pass" << p.name << p.reason << p.phase << p.work << p.shader.vertex << p.shader.fragment
         << p.shader.compute << p.shader.prelude;
    line.all(p.shader.defines);
    line << p.state.depthTest << p.state.depthWrite << p.state.cull << p.state.blend << p.state.meanWeight
         << p.state.depthClamp << p.state.depthBias.x << p.state.depthBias.y;
    line.all(p.colors);
    if (p.depth) line << *p.depth;
    line.all(p.storage);
    line.all(p.inputs);
    line.all(p.reads);
    line.all(p.writes);
    for (const auto& [binding, bytes] : p.blocks) line << binding << bytes;
    if (p.view) line.values(p.view->clipFromWorld);
    line.all(p.draws);
    line.values(p.groups);
    line.all(p.mipmaps);
    for (const auto& [name, count] : p.counts) line << name << count;
    line << p.countSamples << p.bound;
    line.all(p.effects);
    if (p.contentHash) line << *p.contentHash;
    return line.text.str();
}

}  // namespace

std::string wholeText(const FramePlan& plan)
{
    Line head;
    head.values(plan.view.clipFromWorld);
    head << plan.time << plan.seed << plan.sample << plan.runEverything;
    std::string text = head.text.str() + '\n';
    for (const Pass& pass : plan.passes()) text += textOf(pass) + '\n';
    for (const CulledPass& s : plan.skipped()) {
        Line line;
        line << "skipped" << s.name << s.reason << s.work << s.complaint << s.boundIsZero << s.unreadable;
        text += line.text.str() + '\n';
    }
    for (const auto& [name, image] : plan.images()) {
        Line line;
        line << "image" << name << image.format << image.type << image.size.x << image.size.y << image.scale
             << image.layers << image.levels << image.persistent << image.comparison << image.repeat << image.nearest
             << image.divisor << image.ownPixels;
        text += line.text.str() + '\n';
    }
    return text;
}

}  // namespace vitrine::test
