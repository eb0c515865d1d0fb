#pragma once

#include "exhibits/study/study_store.h"
#include "tests/exhibits/study/known_law.h"
#include "ui/viewport/renderers.h"

#include <QString>

#include <chrono>
#include <thread>

namespace vitrine::test {

/// Returns a store of studies in a folder of the test.
inline study::StudyStore storeIn(const QString& folder)
{
    const std::filesystem::path path = folder.toStdString();
    return {path / "studies", path / "trash"};
}

inline std::vector<std::unique_ptr<Exhibit>> knownExhibit()
{
    KnownLaw law;
    law.error = [](const KnownTable& t, const ParameterValues& v, double d) {
        return d * (0.2 / v[t.steps] + 0.05 / v[t.rays] + (v[t.shortcut] ? 0.001 : 0) + 0.01 * (2 - v[t.method]));
    };
    law.cost = [](const KnownTable& t, const ParameterValues& v, double d) {
        return d * (1 + 0.1 * v[t.steps] + 0.3 * v[t.rays] + v[t.method]);
    };
    std::vector<std::unique_ptr<Exhibit>> all;
    all.push_back(std::make_unique<KnownExhibit>(std::move(law)));
    return all;
}

/// Backend whose frames take a given time, so that the measurement can be observed.
class TimedBackend final : public render::RenderBackend {
public:
    TimedBackend(bool clockTrusted, std::chrono::milliseconds frame) : clockTrusted_(clockTrusted), frame_(frame) {}
    render::FrameReport draw(const render::FramePlan& plan) override
    {
        if (frame_.count() > 0) std::this_thread::sleep_for(frame_);
        render::FrameReport report = known_.draw(plan);
        report.clockTrusted = clockTrusted_;
        return report;
    }
    [[nodiscard]] render::Image read(const std::string& image) override { return known_.read(image); }
    [[nodiscard]] const render::PersistentState& persistentState() const override { return known_.persistentState(); }
    [[nodiscard]] int largestSide() const override { return known_.largestSide(); }

private:
    KnownBackend known_;
    bool clockTrusted_;
    std::chrono::milliseconds frame_;
};

/// Museum with renderers that measure it by a backend without GL; other functions are not used.
class KnownGallery final : public ui::Renderers {
public:
    Museum museum{knownExhibit()};
    KnownTable table;
    std::thread::id measuredOn;
    // Both are used for all studies started later.
    bool clockTrusted = true;
    std::chrono::milliseconds frame{0};  ///< Time of each frame. Above 0 only where a test watches the measurement.

    void open() override {}
    void close() override {}
    render::FrameReport draw(const SceneState&, const FrameRequest&, const IsCanceled&) override { return {}; }
    [[nodiscard]] QImage screenImage(const QSize&) override { return {}; }
    [[nodiscard]] QImage drawRegion(const SceneState&, const FrameRequest&, const PictureRegion&, int,
                                    const IsCanceled&) override
    {
        return {};
    }
    [[nodiscard]] render::Image shownPicture() override { return {}; }
    void timeSteps(bool) override {}
    bool reloadChangedShaders() override { return false; }
    [[nodiscard]] std::vector<render::gl::ShaderProblem> problems() const override { return {}; }
    [[nodiscard]] ui::PictureJob makePicture(const SceneState&, const PictureRequest&) override { return {}; }
    void nextPicture(ui::PictureJob&, const SceneState&, const PictureRequest&) override {}
    [[nodiscard]] ui::StudyJob makeStudy(const study::StudyRequest& request) override
    {
        measuredOn = std::this_thread::get_id();
        ui::StudyJob job;
        job.machine = {{"renderer", "the painter"}, {"processors", 2}};
        job.backend = std::make_unique<TimedBackend>(clockTrusted, frame);
        job.study = std::make_unique<study::Study>(museum, *job.backend, request);
        return job;
    }
};

}  // namespace vitrine::test
