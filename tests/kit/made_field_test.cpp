// A body with shaders of its own state: another text for another shape, one program for all its numbers.

#include "tests/kit/ball_shot.h"
#include "tests/support/museum_on_paper.h"

namespace vitrine {
namespace {

using test::BallShot;

enum class MadeShape : int { ball, box };

struct MadeParameters : virtual Parameters {
    Group shape = group("Shape");
    Choice<MadeShape> kind = choice("kind", MadeShape::ball, {"ball", "box"}, "Of which the text is made.");
    Real size = real("size", 0.3, meter, {0.01, 2}, "Of half of it.");
};
struct MadeTable final : MadeParameters, SdfMaterialParameters, SdfParameters {};

/// Its field is written at run time, by the kind of its shape.
class Made final : public SdfExhibit {
public:
    Made() : SdfExhibit({.field = "made/field.glsl", .generated = textOf("1.0")})
    {
        bodies_[0] = sdfSources({.field = "made/field.glsl", .generated = textOf("length(p) - parameters.size")});
        bodies_[1] = sdfSources({.field = "made/field.glsl", .generated = textOf("sdfBox(p, vec3(parameters.size))")});
    }
    [[nodiscard]] std::string_view name() const override { return "made"; }
    [[nodiscard]] std::string_view title() const override { return "Made"; }
    [[nodiscard]] std::string_view summary() const override { return "A field of texts."; }
    [[nodiscard]] int place() const override { return 1; }
    [[nodiscard]] const MadeTable& parameters() const override { return table_; }
    [[nodiscard]] SdfBody body(const ParameterValues& values, double) const override
    {
        const double size = values[table_.size];
        const auto kind = static_cast<std::size_t>(values[table_.kind]);
        return {.values = values,
                .box = {glm::dvec3(-size), glm::dvec3(size)},
                .distance = [size](const glm::dvec3& p) { return glm::length(p) - size; },
                .shape = derive::keyOf(values, {table_.kind.row, table_.size.row}),
                .sources = bodies_[kind]};
    }

private:
    [[nodiscard]] static std::shared_ptr<const render::ShaderSources> textOf(const std::string& distance)
    {
        return std::make_shared<const render::ShaderSources>(std::map<std::string, std::string>{
            {"made/field.glsl",
             "#include \"lib/sdf.glsl\"\nfloat fieldDistance(vec3 p)\n{\n    return " + distance + ";\n}\n"}});
    }
    [[nodiscard]] const SdfParameters& rows() const override { return table_; }
    [[nodiscard]] const SdfMaterialParameters* materialParameters() const override { return &table_; }

    MadeTable table_;
    std::array<std::shared_ptr<const render::ShaderSources>, 2> bodies_;
};

const Museum& madeMuseum()
{
    static const auto opened = test::museumOf(std::make_unique<Made>());
    return *opened;
}
const MadeTable& madeTable()
{
    static const MadeTable table;
    return table;
}

class MadeField : public test::GlTest {};

TEST_F(MadeField, IsDrawnByTheTextOfItsState)
{
    BallShot shot(madeMuseum(), "made");
    const test::Picture ball = shot.take();
    shot.values().set(madeTable().kind, MadeShape::box);
    const test::Picture box = shot.take();
    // Seen along z: the front of the box is a square, the ball within it a disk.
    const auto pixelAt = [&](double x, double y) {
        const double scale = 0.5 * ball.height() / (2 - 0.3) / ball.view.tanHalfFov.y;
        return glm::ivec2(ball.width() / 2 + std::lround(x * scale), ball.height() / 2 - std::lround(y * scale));
    };
    const glm::ivec2 middle = pixelAt(0, 0), corner = pixelAt(0.27, 0.27);
    EXPECT_TRUE(ball.hit(middle.x, middle.y));
    EXPECT_TRUE(box.hit(middle.x, middle.y));
    EXPECT_FALSE(ball.hit(corner.x, corner.y));
    EXPECT_TRUE(box.hit(corner.x, corner.y));
    shot.values().set(madeTable().kind, MadeShape::ball);
    EXPECT_FALSE(shot.take().hit(corner.x, corner.y)) << "and back";
}

TEST(MadeFieldOnPaper, CompilesForAShapeAndNotForItsNumbers)
{
    BallShot shot(madeMuseum(), "made");
    shot.inHall();
    test::letTheSunIn(shot.hall());
    const auto planned = [&] { return test::planned(shot.museum, shot.sceneState, shot.request.frame); };
    const render::FramePlan first = planned();
    shot.values().set(madeTable().size, 0.31);
    const render::FramePlan larger = planned();
    shot.values().set(madeTable().kind, MadeShape::box);
    const render::FramePlan other = planned();
    std::set<std::string> families;
    for (const char* step : {"made/march", "made/cone", "made/shadow"}) {
        ASSERT_TRUE(first.find(step) && larger.find(step) && other.find(step)) << step;
        const render::ShaderKey& key = first.find(step)->shader;
        EXPECT_EQ(key, larger.find(step)->shader) << step << ": a number compiles";
        EXPECT_NE(key.sources->hash(), other.find(step)->shader.sources->hash()) << step;
        EXPECT_FALSE(key.programFamily.empty()) << step << ": the picture would wait for its program";
        EXPECT_EQ(key.programFamily, other.find(step)->shader.programFamily) << step;
        families.insert(key.programFamily);
    }
    families.insert(first.find("made/march")->depthOnly->shader.programFamily);
    EXPECT_EQ(families.size(), 4U) << "programs of one family take the same inputs";
    const render::FramePlan fixed = test::planned(test::ballMuseum(), BallShot().sceneState, BallShot().request.frame);
    EXPECT_TRUE(fixed.find("ball/march")->shader.programFamily.empty()) << "shaders that never change are waited for";
}

}  // namespace
}  // namespace vitrine
