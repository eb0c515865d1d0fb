#include "tests/render/gl/renderer_bench.h"

namespace vitrine::test {
namespace {

struct Opened {
    render::gl::HeadlessContext context{true};
    render::gl::DebugLog log;
};

Opened& opened()
{
    static auto* only = new Opened;  // Never destroyed, because the driver is unloaded before statics are destroyed.
    return *only;
}

std::shared_ptr<const render::ShaderSources> source(const std::string& path, const std::string& text)
{
    return std::make_shared<const render::ShaderSources>(std::map<std::string, std::string>{{path, text}});
}

}  // namespace

void RendererTest::SetUp()
{
    errorsBefore_ = opened().log.errors().size();
    renderer_ = std::make_unique<render::gl::Renderer>();
}

void RendererTest::TearDown()
{
    renderer_.reset();
    const std::string errors = opened().log.errors().substr(errorsBefore_);
    EXPECT_TRUE(expectsErrors_ || errors.empty()) << errors;
}

render::gl::HeadlessContext& RendererTest::context()
{
    return opened().context;
}

render::FramePlan RendererTest::planOf(glm::ivec2 size)
{
    render::FramePlan plan;
    plan.view = render::makeView({{0, 0, 5}, {0, 0, 0}}, {.size = size});
    plan.image({.name = "frame", .format = render::Format::rgba32f});
    return plan;
}

render::FrameReport RendererTest::draw(render::FramePlan& plan)
{
    EXPECT_EQ(plan.errors(), std::vector<std::string>());
    plan.prune({"frame"}, renderer_->persistentState());
    return renderer_->draw(plan);
}

render::Pass RendererTest::fill(const std::string& name, const std::string& image, const std::string& body,
                                const std::string& before)
{
    render::Pass pass;
    pass.name = name;
    pass.shader = {"lib/fullscreen.vert", name + ".frag", "", {}};
    pass.shader.sources =
        source(name + ".frag", before + "\nlayout(location = 0) out vec4 color;\nvoid main()\n{\n" + body + "\n}\n");
    pass.colors = {render::Attachment::cleared(image)};
    pass.draws = {render::Draw{}};
    return pass;
}

render::Pass RendererTest::compute(const std::string& name, const std::string& body, const std::string& before)
{
    render::Pass pass;
    pass.name = name;
    pass.work = render::Work::compute;
    pass.shader.compute = name + ".comp";
    pass.shader.sources =
        source(name + ".comp", before + "\nlayout(local_size_x = 1) in;\nvoid main()\n{\n" + body + "\n}\n");
    return pass;
}

}  // namespace vitrine::test
