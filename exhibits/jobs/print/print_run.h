#pragma once

#include "exhibits/jobs/kit/job.h"
#include "exhibits/jobs/print/view_folder.h"
#include "exhibits/printing/print_plan.h"

#include <optional>

namespace vitrine::jobs {

/// Returns the properties of the print. `ofViews`: those of the views, too, which a chart does not have.
[[nodiscard]] std::vector<Fact> printFacts(const printing::PrintPlan&, bool ofViews);

/// The ICC profile into which a print is converted, as read; empty if there is none.
struct ProfileInputs final : JobInputs {
    std::string profile;
};

/// Run that reads or renders the views of a print, and interlaces them.
class PrintRun final : public JobRun {
public:
    /// The inputs of the order are ProfileInputs.
    explicit PrintRun(JobOrder order) : order_(std::move(order)) {}

    [[nodiscard]] Next next() const override;
    void step(const Watch&) override;
    [[nodiscard]] double progress() const override;
    [[nodiscard]] std::string_view doing() const override;
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override;

private:
    enum class Stage : std::uint8_t { begin, render, write, done };

    void begin(const Watch&);
    void beginScene(const printing::PrintLayout&);
    void render();
    void beginRendering();
    void take(int view, const ::vitrine::render::Image&);
    void endRendering();
    void write(const Watch&);
    void tell(const std::optional<printing::CrossTalk>&);
    void describeRig(const printing::DepthRange&);
    [[nodiscard]] const std::string* profile() const
    {
        return &static_cast<const ProfileInputs&>(*order_.inputs).profile;
    }

    JobOrder order_;
    Stage stage_ = Stage::begin;
    double progress_ = 0;
    std::shared_ptr<const printing::PrintViews> views_;    ///< Null while there are none, and for a chart.
    std::shared_ptr<printing::PrintViews> renderedViews_;  ///< The same while they are being rendered.
    std::optional<printing::RenderedViews> rendered_;
    std::unique_ptr<ViewFolder> folder_;
    std::unique_ptr<::vitrine::render::RenderBackend> backend_;
    std::unique_ptr<printing::ViewMaker> maker_;  ///< Declared after the renderer that it uses.
    printing::StagedPrint staged_;
    JobReport report_;
};

}  // namespace vitrine::jobs
