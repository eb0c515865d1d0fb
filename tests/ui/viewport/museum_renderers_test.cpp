// Renderers of the window's thread with a museum: which programs they wait for.

#include "tests/ui/ui_main.h"

#include "exhibits/museum/museum.h"
#include "ui/viewport/museum_renderers.h"

#include <QtTest>

#include <map>
#include <memory>
#include <string>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

struct FilledTable final : Parameters {
    Count number = count("number", 1, {1, 100}, "What the shader returns.");
};

/// Exhibit that fills the picture with a number from its generated shader.
class Filled final : public Exhibit {
public:
    inline static const FilledTable table;

    [[nodiscard]] std::string_view name() const override { return "filled"; }
    [[nodiscard]] std::string_view title() const override { return "Filled"; }
    [[nodiscard]] std::string_view summary() const override { return "A number."; }
    [[nodiscard]] int place() const override { return 1; }
    [[nodiscard]] const Parameters& parameters() const override { return table; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override { return {glm::dvec3(-1), glm::dvec3(1)}; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override { return {{0, 0, 4}, {0, 0, 0}, 0.8}; }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override { return INFINITY; }
    void plan(const PlanContext& context, render::FramePlan& plan) const override
    {
        render::Pass pass;
        pass.name = "filled/fill";
        pass.reason = "it is in view";
        pass.phase = render::PassPhase::opaque;
        pass.shader = {.vertex = "lib/fullscreen.vert", .fragment = "filled.frag"};
        pass.shader.sources = std::make_shared<const render::ShaderSources>(std::map<std::string, std::string>{
            {"filled.frag", "layout(location = 0) out vec4 color;\nvoid main()\n{\n    color = vec4(" +
                                std::to_string(context.values[table.number]) + ".0);\n}\n"}});
        pass.shader.programFamily = "filled";
        pass.colors = {render::Attachment::whole(radianceImage)};
        pass.draws = {render::Draw{}};
        plan.add(std::move(pass));
    }
};

}  // namespace

class MuseumRenderersTest : public QObject {
    Q_OBJECT

private slots:
    void framesWaitForNoProgramOfASlotAndFinishedPicturesDo()
    {
        std::vector<std::unique_ptr<Exhibit>> exhibits;
        exhibits.push_back(std::make_unique<Filled>());
        const Museum museum(std::move(exhibits));
        MuseumRenderers renderers(museum);
        renderers.open();
        SceneState sceneState = museum.initialSceneState();
        sceneState.hall().setParameter(*sceneState.hall().table().find("reflectionProbe"), 0.0);
        FrameRequest frame;
        frame.camera = museum.exhibit(1).bestView(sceneState.values[1]);
        frame.raster.size = {16, 9};
        frame.alone = 1;
        frame.transparent = true;
        const Renderers::IsCanceled never = [] { return false; };
        QVERIFY(!renderers.draw(sceneState, frame, never).unfinished);  // The first program is waited for.
        bool unfinished = false;
        for (int number = 2; number < 8 && !unfinished; ++number) {
            sceneState.values[1].set(Filled::table.number, number);
            unfinished = renderers.draw(sceneState, frame, never).unfinished;
        }
        QVERIFY2(unfinished, "every frame waited for its program");

        sceneState.values[1].set(Filled::table.number, 9);
        PictureRequest picture;
        picture.frame = frame;
        picture.frame.averageIn = AverageIn::radiance;
        PictureJob job = renderers.makePicture(sceneState, picture);
        while (job.maker->step()) {
        }
        QCOMPARE(job.maker->picture().at(8, 4, 0), 9.0F);
        job = {};
        renderers.close();
    }

    void theSecondLookIsDrawnAsTheFirstWouldBeAndLeavesItAlone()
    {
        std::vector<std::unique_ptr<Exhibit>> exhibits;
        exhibits.push_back(std::make_unique<Filled>());
        const Museum museum(std::move(exhibits));
        MuseumRenderers renderers(museum);
        renderers.open();
        const QSize screen(16, 9);
        SceneState a = museum.initialSceneState();
        a.hall().setParameter(*a.hall().table().find("reflectionProbe"), 0.0);
        a.hall().setParameter(*a.hall().table().find("exposure"), -3.0);
        SceneState b = a;
        b.hall().setParameter(*b.hall().table().find("exposure"), 0.0);
        FrameRequest frame;
        frame.camera = museum.exhibit(1).bestView(a.values[1]);
        frame.raster.size = {16, 9};
        frame.alone = 1;
        frame.resetHistory = frame.finished = true;
        const Renderers::IsCanceled never = [] { return false; };
        static_cast<void>(renderers.draw(b, frame, never));
        const QImage expected = renderers.screenImage(screen);
        static_cast<void>(renderers.draw(a, frame, never));
        const QImage first = renderers.screenImage(screen);
        QVERIFY2(first != expected, "a control: the exposure is seen");
        const OtherDrawn second = renderers.drawOther(b, frame, screen);
        QVERIFY(second.image == expected);
        QVERIFY(!second.report.ran.empty());
        QVERIFY(renderers.screenImage(screen) == first);
        renderers.forgetOther();
        QVERIFY(renderers.drawOther(b, frame, screen).image == expected);
        renderers.close();
    }
};

VITRINE_UI_TEST(MuseumRenderersTest)

#include "museum_renderers_test.moc"
