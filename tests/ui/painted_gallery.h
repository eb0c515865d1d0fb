#pragma once

#include "tests/ui/sample_tables.h"

#include "exhibits/framework/scene/offers_comparisons.h"
#include "exhibits/hall/hall_model.h"
#include "ui/viewport/render_thread.h"
#include "ui/viewport/renderers.h"

#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

namespace vitrine::test {

/// Exhibit with a table and nothing to draw, on the plinth in the middle of the hall.
class PlainExhibit final : public Exhibit, public HasButton, public OffersComparisons {
public:
    [[nodiscard]] std::string_view name() const override { return "sdf_morph"; }
    [[nodiscard]] std::string_view title() const override { return "Torus to mug"; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "One solid with one hole, from torus to mug and back.";
    }
    [[nodiscard]] std::string_view buttonText() const override { return "melt it"; }
    [[nodiscard]] Message whyDisabled(const ParameterValues&) const override { return disabled; }
    [[nodiscard]] int place() const override { return 1; }
    [[nodiscard]] const SampleTable& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override
    {
        return {{-0.4, -0.3, -0.4}, {0.4, 0.8, 0.4}};
    }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override
    {
        return {{0.6, 0.4, 3}, {0.2, 0, 0}, 0.9};
    }
    [[nodiscard]] std::vector<OfferedComparison> comparisons() const override
    {
        return {{"chalk", "Chalk & dust", "As rough as it gets.", {{"roughness", 0.8}}}};
    }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override { return INFINITY; }
    [[nodiscard]] double nextChangeOf(const ExhibitState& state) const override
    {
        return moves || state.sinceOwnPress < movesFor ? 0 : changesIn;
    }

    [[nodiscard]] std::shared_ptr<const PreparedPart> prepare(const PrepareContext& context) const override
    {
        if (!file.empty()) (void)context.assets.get<int>("plain.file", file, read);
        return nullptr;
    }

    bool moves = false;
    double movesFor = 0;          ///< Seconds after a press.
    double changesIn = INFINITY;  ///< Seconds until it looks different, without an animation before.
    Message disabled = {};        ///< Reason why its button cannot be pressed; empty: it can.
    std::string file;             ///< File that it shows; empty: none. Set this and `read` only while nothing is drawn.
    std::function<render::AssetStore::Made<int>(const std::string&)> read;

private:
    SampleTable table_;
};

/// Backend that always draws gray.
class BlankBackend final : public render::RenderBackend {
public:
    render::FrameReport draw(const render::FramePlan& plan) override
    {
        size_ = glm::max(glm::ivec2(ui::RenderThread::taskTile), plan.view.raster.size);
        return {};
    }
    /// Returns a uniform gray image, at least as large as a tile and as the last picture; depth has one channel.
    [[nodiscard]] render::Image read(const std::string& name) override
    {
        return {size_.x, size_.y, name.find("epth") == std::string::npos ? 4 : 1, 0.5F};
    }
    [[nodiscard]] const render::PersistentState& persistentState() const override { return kept_; }
    [[nodiscard]] int largestSide() const override { return 16384; }

private:
    render::PersistentState kept_;
    glm::ivec2 size_{ui::RenderThread::taskTile};
};

/// Hall with plain exhibits.
struct PlainMuseum {
    explicit PlainMuseum(std::unique_ptr<Exhibit> another = nullptr) : museum(exhibits(std::move(another))) {}

    PlainExhibit* plain = nullptr;
    Museum museum;

private:
    std::vector<std::unique_ptr<Exhibit>> exhibits(std::unique_ptr<Exhibit> another)
    {
        std::vector<std::unique_ptr<Exhibit>> all;
        all.push_back(std::make_unique<PlainExhibit>());
        plain = static_cast<PlainExhibit*>(all.front().get());
        if (another) all.push_back(std::move(another));
        return all;
    }
};

/// Museum of plain exhibits, and renderers whose picture has one color: its red is the roughness of exhibit 1.
class PaintedGallery final : public ui::Renderers {
public:
    /// Null: the museum that is shared by all galleries without another exhibit.
    explicit PaintedGallery(std::shared_ptr<PlainMuseum> own = nullptr) : own_(std::move(own))
    {
        exhibit().moves = false;
        exhibit().movesFor = 0;
        exhibit().changesIn = INFINITY;
        exhibit().disabled = {};
        exhibit().file.clear();
    }
    [[nodiscard]] const Museum& museum() { return shown().museum; }
    [[nodiscard]] PlainExhibit& exhibit() { return *shown().plain; }
    [[nodiscard]] const SampleTable& table() { return exhibit().parameters(); }
    /// Returns the center of the exhibit's button in world space.
    [[nodiscard]] static glm::dvec3 button()
    {
        static const hall::HallModel building;
        return (*building.place(1)->worldFromButton)[3];
    }
    /// Returns the camera of a visitor who looks at the button from this distance on the floor, in meters.
    [[nodiscard]] static render::Camera towardsButton(double meters)
    {
        const glm::dvec3 aside = button() + meters * glm::normalize(glm::dvec3(0.3, 0, 1));
        return {{aside.x, 1.65, aside.z}, button(), 0.9};
    }

    void open() override
    {
        ++opened;
        thread = std::this_thread::get_id();
    }
    void close() override { ++closed; }
    render::FrameReport draw(const SceneState& sceneState, const FrameRequest& request,
                             const IsCanceled& isCanceled) override
    {
        strangers += std::this_thread::get_id() == thread ? 0 : 1;
        const Prepared prepared = museum().prepare(sceneState, request);
        if (beforeDrawing) beforeDrawing(request, isCanceled);
        if (thrown) std::rethrow_exception(thrown);
        red_ = static_cast<float>(prepared.sceneState.values[1][table().roughness]);
        green_ = green(request);
        {
            const std::scoped_lock lock(mutex_);
            requests_.push_back(request);
            drawn_ = sceneState;
        }
        render::FrameReport report;
        report.ran = {{"hall/walls", "in view", render::Work::raster, 12.25},
                      {"sdf_morph/march", "in view, 1.2 m away", render::Work::raster, 31.5}};
        report.skipped = {{"probe/capture", "unchanged since the last frame", render::Work::raster}};
        report.skipped.insert(report.skipped.end(), complaints.begin(), complaints.end());
        report.milliseconds = 43.8;
        report.unfinished = unfinishedFrames > 0 && unfinishedFrames-- > 0;
        report.clock = "process CPU time around glFinish";
        report.clockTrusted = true;
        return report;
    }
    [[nodiscard]] QImage screenImage(const QSize& screen) override
    {
        QImage image(screen, QImage::Format_RGBX8888);
        image.fill(QColor::fromRgbF(red_, green_, 0.4F));
        return image;
    }
    [[nodiscard]] QImage drawRegion(const SceneState&, const FrameRequest&, const PictureRegion& region, int,
                                    const IsCanceled&) override
    {
        strangers += std::this_thread::get_id() == thread ? 0 : 1;
        QImage image(region.size.x, region.size.y, QImage::Format_RGBX8888);
        image.fill(Qt::blue);
        return image;
    }
    [[nodiscard]] ui::OtherDrawn drawOther(const SceneState& sceneState, const FrameRequest& request,
                                           const QSize& screen) override
    {
        strangers += std::this_thread::get_id() == thread ? 0 : 1;
        {
            const std::scoped_lock lock(mutex_);
            otherRequests_.push_back(request);
        }
        if (otherThrown) std::rethrow_exception(otherThrown);
        ui::OtherDrawn drawn;
        drawn.image = QImage(screen, QImage::Format_RGBX8888);
        const double red = sceneState.values[1][table().roughness];
        drawn.image.fill(QColor::fromRgbF(static_cast<float>(red), green(request), 0.4F));
        drawn.report.ran = {{"hall/walls", "in view", render::Work::raster, 10.5},
                            {"fur/shells", "in view", render::Work::raster, 7.25}};
        drawn.report.counters = {{"draws", 2}};
        drawn.report.milliseconds = 17.8;
        return drawn;
    }
    void forgetOther() override { ++othersForgotten; }
    [[nodiscard]] QImage drawSmall(const SceneState& sceneState, const FrameRequest&, const QSize& screen) override
    {
        strangers += std::this_thread::get_id() == thread ? 0 : 1;
        ++smallDrawn;
        if (beforeSmall) beforeSmall();
        QImage image(screen, QImage::Format_RGBX8888);
        const double red = sceneState.values[1][table().roughness];
        image.fill(QColor::fromRgbF(static_cast<float>(red), 0.45F, 0.4F));
        return image;
    }
    void forgetSmall() override { ++smallForgotten; }
    [[nodiscard]] render::Image shownPicture() override
    {
        ++pictureReads;
        const FrameRequest last = requests().back();
        render::Image picture(last.raster.size.x, last.raster.size.y, 4);
        picture.channelNames = {"R", "G", "B", "A"};
        for (float& value : picture.pixels) value = red_;
        return picture;
    }
    void buildBetter(const SceneState&, const FrameRequest& request) override
    {
        strangers += std::this_thread::get_id() == thread ? 0 : 1;
        betterBuilds += request.idle ? 1 : 100;
    }
    void timeSteps(bool) override {}
    bool reloadChangedShaders() override { return false; }
    [[nodiscard]] std::vector<render::gl::ShaderProblem> problems() const override { return shaderProblems; }
    [[nodiscard]] ui::PictureJob makePicture(const SceneState&, const PictureRequest&) override { return {}; }
    void nextPicture(ui::PictureJob&, const SceneState&, const PictureRequest&) override {}
    [[nodiscard]] ui::StudyJob makeStudy(const study::StudyRequest&) override { return {}; }

    [[nodiscard]] std::unique_ptr<render::RenderBackend> makeBackend(bool) override
    {
        return std::make_unique<BlankBackend>();
    }

    /// Requests of the pictures drawn so far.
    [[nodiscard]] std::vector<FrameRequest> requests() const
    {
        const std::scoped_lock lock(mutex_);
        return requests_;
    }
    /// Requests of the pictures of B drawn so far.
    [[nodiscard]] std::vector<FrameRequest> otherRequests() const
    {
        const std::scoped_lock lock(mutex_);
        return otherRequests_;
    }
    /// Scene state of the last drawn picture.
    [[nodiscard]] SceneState drawn() const
    {
        const std::scoped_lock lock(mutex_);
        return drawn_;
    }
    void forgetRequests()
    {
        const std::scoped_lock lock(mutex_);
        requests_.clear();
    }

    std::atomic<int> opened = 0, closed = 0;
    std::thread::id thread;  ///< Thread that opened the renderers.
    /// Number of requests for specialized programs while values were idle; requests at other times add a hundred.
    std::atomic<int> betterBuilds = 0;
    std::atomic<int> strangers = 0;  ///< Number of pictures drawn on another thread.
    std::function<void(const FrameRequest&, const IsCanceled&)> beforeDrawing;  ///< Set only while nothing is drawn.
    std::atomic<int> pictureReads = 0;
    std::atomic<int> othersForgotten = 0;
    std::atomic<int> smallDrawn = 0, smallForgotten = 0;
    std::function<void()> beforeSmall;          ///< Called before each small picture; set only while none is drawn.
    std::atomic<int> unfinishedFrames = 0;      ///< Number of next frames that report unfinished work.
    std::atomic<bool> greenIsTheClock = false;  ///< Green shows the clock, with a period of two seconds.
    std::vector<render::gl::ShaderProblem> shaderProblems;
    std::exception_ptr thrown;                   ///< Thrown by all further frames; null: none.
    std::exception_ptr otherThrown;              ///< Thrown by all further frames of B; null: none.
    std::vector<render::CulledPass> complaints;  ///< Complaints of all further frames.

private:
    [[nodiscard]] PlainMuseum& shown()
    {
        static PlainMuseum shared;
        return own_ ? *own_ : shared;
    }

    [[nodiscard]] float green(const FrameRequest& request) const
    {
        return greenIsTheClock ? static_cast<float>(request.time / 2 - std::floor(request.time / 2)) : 0.45F;
    }

    std::shared_ptr<PlainMuseum> own_;
    float red_ = 0, green_ = 0.45F;
    mutable std::mutex mutex_;
    std::vector<FrameRequest> requests_, otherRequests_;
    SceneState drawn_;
};

}  // namespace vitrine::test
