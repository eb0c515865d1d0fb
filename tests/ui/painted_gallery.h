#pragma once

#include "tests/ui/sample_tables.h"

#include "ui/viewport/gallery.h"

#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

namespace vitrine::test {

/// An exhibit with a table and nothing to draw.
class PlainExhibit final : public Exhibit, public HasButton {
public:
    PlainExhibit(std::string_view name, std::string_view title, int place) : name_(name), title_(title), place_(place)
    {
    }

    [[nodiscard]] std::string_view name() const override { return name_; }
    [[nodiscard]] std::string_view title() const override { return title_; }
    [[nodiscard]] std::string_view summary() const override
    {
        return "One solid with one hole, from torus to mug and back.";
    }
    [[nodiscard]] std::string_view buttonText() const override { return "melt it"; }
    [[nodiscard]] int place() const override { return place_; }
    [[nodiscard]] const Parameters& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override { return {{-1, 0, -1}, {1, 2, 1}}; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override
    {
        return {{0, 1.5, 3}, {0, 1, 0}, 0.9};
    }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override { return INFINITY; }
    [[nodiscard]] const SampleTable& table() const { return table_; }

private:
    std::string_view name_, title_;
    int place_;
    SampleTable table_;
};

/// A building with a table and nothing to draw.
class PlainHall final : public Subject {
public:
    [[nodiscard]] std::string_view name() const override { return "hall"; }
    [[nodiscard]] std::string_view title() const override { return "Hall"; }
    [[nodiscard]] std::string_view summary() const override { return "Walls and light."; }
    [[nodiscard]] const SampleTable& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override { return {{-6, 0, -12}, {6, 9, 12}}; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override
    {
        return {{0, 1.5, 3}, {0, 1, 0}, 0.9};
    }

private:
    SampleTable table_;
};

/// A gallery of plain exhibits whose picture is one color: roughness of exhibit 1 is its red.
class PaintedGallery final : public ui::Gallery {
public:
    /// With another exhibit after the plain ones, or none.
    explicit PaintedGallery(std::unique_ptr<Exhibit> another = nullptr) : another_(std::move(another))
    {
        if (another_) subjects_.push_back(another_.get());
    }
    [[nodiscard]] const SampleTable& table(std::size_t i) const
    {
        return i == hallIndex ? hall_.parameters() : exhibit_.table();
    }

    [[nodiscard]] Subjects subjects() const override { return subjects_; }
    [[nodiscard]] Look initialLook() const override
    {
        Look look;
        for (const Subject* subject : subjects_) look.values.push_back(subject->parameters().initial());
        return look;
    }
    [[nodiscard]] render::Camera bestView(std::size_t, const ParameterValues&) const override
    {
        return {{0, 1.5, 3}, {0, 1, 0}, 0.9};
    }
    [[nodiscard]] glm::dvec3 walk(const glm::dvec3&, const glm::dvec3& to) const override
    {
        return {to.x, to.y, std::max(to.z, 2.0)};
    }
    [[nodiscard]] std::optional<LookedAt> lookedAt(const Look&) const override { return looked; }
    /// The exhibit in the middle, its button at the right.
    [[nodiscard]] std::optional<Pointed> pick(const Look&, const FrameRequest&, glm::dvec2 ndc) const override
    {
        const Pointed exhibit{1, "Torus to mug", 3, false, false, {{0, 1.5, 3}, {0, 1, 0}, 0.9}};
        if (glm::length(ndc) < 0.3) return exhibit;
        if (glm::length(ndc - glm::dvec2(0.8, 0)) < 0.1)
            return Pointed{1, "E – melt it", 1, true, buttonInReach, exhibit.view};
        return std::nullopt;
    }
    [[nodiscard]] std::vector<int> emptyPlaces() const override { return {2, 3, 4, 5, 6, 7, 8, 9}; }
    /// Moves for `movesFor` seconds after a press.
    [[nodiscard]] double nextChange(const Look&, const FrameRequest& request) const override
    {
        return request.sincePressed.size() > 1 && request.sincePressed[1] < movesFor ? 0 : INFINITY;
    }

    [[nodiscard]] TabledLook readTables(const Look& look) const override
    {
        return vitrine::readTables(subjects_, assets_, look);
    }

    void open() override
    {
        ++opened;
        thread = std::this_thread::get_id();
    }
    void close() override { ++closed; }
    render::FrameReport draw(const Look& look, const FrameRequest& request, const Unwanted& unwanted) override
    {
        strangers += std::this_thread::get_id() == thread ? 0 : 1;
        if (beforeDrawing) beforeDrawing(request, unwanted);
        if (thrown) std::rethrow_exception(thrown);
        red_ = static_cast<float>(look.values[1][table(1).roughness]);
        {
            const std::scoped_lock lock(mutex_);
            requests_.push_back(request);
            drawn_ = look;
        }
        render::FrameReport report;
        report.ran = {{"hall/opaque", "in view", render::Work::raster, 12.25},
                      {"sdf_morph/march", "in view, 1.2 m away", render::Work::raster, 31.5}};
        report.skipped = {{"probe/capture", "unchanged since the last frame", render::Work::raster}};
        report.skipped.insert(report.skipped.end(), complaints.begin(), complaints.end());
        report.milliseconds = 43.8;
        report.clock = "process CPU time around glFinish";
        report.clockTrusted = true;
        return report;
    }
    [[nodiscard]] QImage screenImage(const QSize& screen) override
    {
        QImage image(screen, QImage::Format_RGBX8888);
        image.fill(QColor::fromRgbF(red_, 0.45F, 0.4F));
        return image;
    }
    [[nodiscard]] std::optional<PictureRegion> movingRegion(const Look&, const FrameRequest&) const override
    {
        return moving;
    }
    [[nodiscard]] QImage drawRegion(const Look&, const FrameRequest&, const PictureRegion& region, int,
                                    const Unwanted&) override
    {
        strangers += std::this_thread::get_id() == thread ? 0 : 1;
        QImage image(region.size.x, region.size.y, QImage::Format_RGBX8888);
        image.fill(Qt::blue);
        return image;
    }
    [[nodiscard]] render::Image shownPicture() override
    {
        ++pictureReads;
        const FrameRequest last = requests().back();
        render::Image picture(last.raster.size.x, last.raster.size.y, 4);
        picture.channelNames = {"R", "G", "B", "A"};
        for (float& value : picture.pixels) value = red_;
        return picture;
    }
    void timeSteps(bool) override {}
    bool reloadChangedShaders() override { return false; }
    [[nodiscard]] std::vector<render::gl::ShaderProblem> problems() const override { return shaderProblems; }
    [[nodiscard]] ui::PictureJob makePicture(const Look&, const PictureRequest&) override { return {}; }
    void nextPicture(ui::PictureJob&, const Look&, const PictureRequest&) override {}
    [[nodiscard]] ui::StudyJob makeStudy(const StudyRequest&) override { return {}; }

    /// Of the pictures drawn so far.
    [[nodiscard]] std::vector<FrameRequest> requests() const
    {
        const std::scoped_lock lock(mutex_);
        return requests_;
    }
    /// What was drawn last.
    [[nodiscard]] Look drawn() const
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
    std::thread::id thread;                                                   ///< That opened it.
    std::atomic<int> strangers = 0;                                           ///< Pictures drawn on another one.
    std::function<void(const FrameRequest&, const Unwanted&)> beforeDrawing;  ///< Set while nothing is drawn.
    std::optional<PictureRegion> moving;
    std::optional<LookedAt> looked;
    bool buttonInReach = true;
    double movesFor = 0;
    std::atomic<int> pictureReads = 0;
    std::vector<render::gl::ShaderProblem> shaderProblems;
    std::exception_ptr thrown;                ///< By every frame that is drawn from now on; null: nothing.
    std::vector<render::Skipped> complaints;  ///< Of every frame that is drawn from now on.

private:
    PlainHall hall_;
    PlainExhibit exhibit_{"sdf_morph", "Torus to mug", 1};
    std::unique_ptr<Exhibit> another_;
    std::vector<const Subject*> subjects_{&hall_, &exhibit_};
    float red_ = 0;
    mutable std::mutex mutex_;
    std::vector<FrameRequest> requests_;
    Look drawn_;
    mutable render::AssetStore assets_;
};

}  // namespace vitrine::test
