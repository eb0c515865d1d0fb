// A field with a material of its own, which differs from point to point, and a table without rows for it.

#include "tests/kit/ball_shot.h"

namespace vitrine {
namespace {

using namespace test;

struct PaintedBallTable final : test::BallParameters, SdfParameters {};

/// Red on its left half, green on its right.
class PaintedBall final : public SdfExhibit {
public:
    PaintedBall() : SdfExhibit({.field = "ball/ball.glsl", .material = "ball/paint.glsl", .generated = shaders()}) {}
    [[nodiscard]] std::string_view name() const override { return "painted_ball"; }
    [[nodiscard]] std::string_view title() const override { return "Painted Ball"; }
    [[nodiscard]] std::string_view summary() const override { return "Two colors on one field."; }
    [[nodiscard]] int place() const override { return 1; }
    [[nodiscard]] const PaintedBallTable& parameters() const override { return table_; }
    [[nodiscard]] SdfBody body(const ParameterValues& values, double time) const override
    {
        SdfBody ball = test::Ball().body(test::Ball().parameters().initial(), time);
        ball.values = values;
        return ball;
    }

private:
    static std::shared_ptr<const render::ShaderSources> shaders()
    {
        auto texts = test::ballShaders()->textByPath();
        texts["ball/paint.glsl"] = "FieldMaterial fieldMaterial(vec3 p)\n{\n"
                                   "    vec3 paint = p.x < 0.0 ? vec3(0.8, 0.0, 0.0) : vec3(0.0, 0.8, 0.0);\n"
                                   "    return FieldMaterial(paint, 0.0, 1.0, 0.0, 1.0);\n}\n";
        return std::make_shared<render::ShaderSources>(std::move(texts));
    }
    [[nodiscard]] const SdfParameters& rows() const override { return table_; }

    PaintedBallTable table_;
};

class PaintedBallTest : public test::GlTest {};

TEST_F(PaintedBallTest, HasTheColorOfEachPointWhetherMarchedOrAMesh)
{
    const auto museum = test::museumOf(std::make_unique<PaintedBall>());
    for (const bool mesh : {false, true}) {
        BallShot shot(*museum, "painted_ball");
        const PaintedBallTable table;
        shot.values().set(table.shownAs, mesh ? SdfShown::mesh : SdfShown::field);
        const Picture p = shot.take();
        int red = 0, green = 0;
        p.each([&](int x, int y) {
            if (!p.hit(x, y) || std::abs(x - p.width() / 2) < 2) return;
            const glm::dvec3 color = p.color(x, y);
            // Without specular light, a color that the paint does not have comes from grazing reflection alone.
            if (p.normal(x, y).z < 0.7) return;
            red += color.r > 4 * color.g;
            green += color.g > 4 * color.r;
            EXPECT_EQ(color.r > color.g, x < p.width() / 2) << x << ',' << y;
        });
        EXPECT_GT(red, 100) << mesh;
        EXPECT_GT(green, 100) << mesh;
    }
}

TEST(PaintedBallOnPaper, NeedsNoParametersOfAMaterial)
{
    const PaintedBallTable table;
    EXPECT_FALSE(table.find("baseColor"));
    const auto asked = [](const Parameters& of, std::size_t row) {
        return parametersOf(of.rows()[row].actsWhen.value());
    };
    using Names = std::vector<std::string_view>;
    EXPECT_EQ(asked(table, table.ambientOcclusion.row), Names{"shownAs"}) << "there is no glass to except";
    EXPECT_EQ(asked(test::ballTable(), test::ballTable().ambientOcclusion.row),
              (Names{"shownAs", "material", "heatMap"}));
}

}  // namespace
}  // namespace vitrine
