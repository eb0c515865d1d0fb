#pragma once

#include "exhibits/jobs/kit/job.h"
#include "exhibits/jobs/kit/job_document.h"
#include "render/files/atomic_write.h"
#include "render/image/image_io.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::test {

enum class ContactSource : int { pictures, folder };

struct ContactTable final : Parameters {
    Group pictureGroup = group("Pictures");
    Choice<ContactSource> source =
        choice("source", ContactSource::pictures, {"pictures", "folder"}, "Origin of the pictures.");
    File pictures = file("pictures", "Pictures in reading order.", several(), positional(),
                         implies(source, ContactSource::pictures), when(source, ContactSource::pictures));
    File folder = file("folder", "Folder of pictures, in the order of their names.",
                       implies(source, ContactSource::folder), when(source, ContactSource::folder));
    Text title = text("title", "Title of the sheet.", mustBeGiven());

    Group sheetGroup = group("Sheet");
    Count columns = count("columns", 0, {1, 64}, "Number of pictures in a row.", reads(0, "auto"));
    Count width = count("width", 16, {1, 4096, logarithmic}, "Size of a picture in pixels.", tuple("tileSize", 'x'));
    Count height = count("height", 12, {1, 4096, logarithmic}, "Size of a picture in pixels.", tuple("tileSize", 'x'));
    Toggle border = toggle("border", true, "Leave paper around the pictures.");
    Real borderWidth = real("borderWidth", 0.002, millimeter, Range{0, 0.05}.soft(0, 0.01), "Width of the border.",
                            option("border-mm", millimeter), when(border));
    Real pixelsPerInch = real("pixelsPerInch", std::numeric_limits<double>::infinity(), none, {1, 10000, logarithmic},
                              "Resolution in the file.", reads(std::numeric_limits<double>::infinity(), "none"),
                              reads(-1, "screen"), option("dpi"));
    Real turn = real("turn", 0, degree, {degrees(-180), degrees(180)}, "Turn of the sheet.", typedIn(degree));
    Color paper = color("paper", {1, 1, 1}, "Color of the paper.");
};

/// A contact sheet: a whole job in one file, with a parameter of every trait.
class ContactJob : public jobs::Job {
public:
    struct Inputs final : jobs::JobInputs {
        std::vector<render::Image> pictures;
    };

    /// One step for each picture.
    class Run final : public jobs::JobRun {
    public:
        explicit Run(jobs::JobOrder order) : order_(std::move(order)) {}
        [[nodiscard]] Next next() const override { return done_ <= pictures().size() ? Next::work : Next::done; }
        void step(const jobs::Watch& watch) override
        {
            if (!watch(progress())) throw jobs::Stopped();
            if (done_++ < pictures().size()) return;
            report_.facts = {{"Pictures", static_cast<double>(pictures().size())}};
            if (order_.out.empty()) return;
            const std::filesystem::path document = jobs::documentFile(order_.out);
            staged_.push_back(render::stagedPicture(order_.out, sheet(), render::PictureFormat::png8));
            staged_.push_back(render::stagedFile(document, jobs::documentText(ContactJob(), order_, report_.facts)));
            report_.files = {order_.out, document};
        }
        [[nodiscard]] double progress() const override
        {
            return static_cast<double>(done_) / static_cast<double>(pictures().size() + 1);
        }
        [[nodiscard]] std::string_view doing() const override { return "laying out pictures"; }
        [[nodiscard]] const jobs::JobReport& report() const override { return report_; }
        void publish() override { render::publishAll(staged_); }

    private:
        [[nodiscard]] const std::vector<render::Image>& pictures() const
        {
            return static_cast<const Inputs&>(*order_.inputs).pictures;
        }
        [[nodiscard]] render::Image sheet() const
        {
            static const ContactTable t;
            const int columns = columnsOf(order_.values, pictures().size());
            const int wide = order_.values[t.width], high = order_.values[t.height];
            const int rows = (static_cast<int>(pictures().size()) + columns - 1) / columns;
            render::Image made(columns * wide, rows * high, 3);
            for (int y = 0; y < made.height; ++y)
                for (int x = 0; x < made.width; ++x) {
                    const auto i = static_cast<std::size_t>(y / high * columns + x / wide);
                    for (int c = 0; c < 3; ++c) {
                        made.at(x, y, c) = 1;
                        if (i >= pictures().size()) continue;
                        const render::Image& from = pictures()[i];
                        made.at(x, y, c) = from.at(x % wide * from.width / wide, y % high * from.height / high, c);
                    }
                }
            return made;
        }

        jobs::JobOrder order_;
        std::size_t done_ = 0;
        std::vector<std::unique_ptr<render::PartFile>> staged_;
        jobs::JobReport report_;
    };

    [[nodiscard]] std::string_view name() const override { return "contact"; }
    [[nodiscard]] std::string_view title() const override { return "Contact sheet"; }
    [[nodiscard]] std::string_view summary() const override { return "Lay out pictures on a sheet"; }
    [[nodiscard]] const Parameters& parameters() const override { return table_; }
    [[nodiscard]] jobs::JobNeeds needs() const override { return {.extensions = {"png"}}; }
    [[nodiscard]] std::shared_ptr<const jobs::JobInputs> read(const ParameterValues& values) const override
    {
        std::vector<std::string> files = linesOf(values[table_.pictures]);
        if (values[table_.source] == ContactSource::folder) {
            files.clear();
            for (const auto& each : std::filesystem::directory_iterator(values[table_.folder]))
                files.push_back(each.path().string());
            std::sort(files.begin(), files.end());
        }
        auto inputs = std::make_shared<Inputs>();
        for (const std::string& file : files) inputs->pictures.push_back(render::readImage(file));
        return inputs;
    }
    [[nodiscard]] jobs::JobPlan plan(const ParameterValues& values, const jobs::JobScene&,
                                     const jobs::JobInputs& inputs, const std::filesystem::path& out) const override
    {
        const auto count = static_cast<const Inputs&>(inputs).pictures.size();
        jobs::JobPlan plan;
        if (count == 0) plan.refusal = "There are no pictures; name some.";
        plan.facts = {{"Columns", static_cast<double>(columnsOf(values, count))}};
        if (out.empty()) return plan;
        if (plan.refusal.empty()) plan.refusal = jobs::refusedExtension(*this, out);
        plan.files = {{out, "sheet"}, {jobs::documentFile(out), "settings"}};
        return plan;
    }
    [[nodiscard]] std::unique_ptr<jobs::JobRun> start(jobs::JobOrder order) const override
    {
        return std::make_unique<Run>(std::move(order));
    }

private:
    [[nodiscard]] static int columnsOf(const ParameterValues& values, std::size_t count)
    {
        static const ContactTable t;
        if (values[t.columns] > 0) return values[t.columns];
        return std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))));
    }

    ContactTable table_;
};

}  // namespace vitrine::test
