#pragma once

#include "exhibits/study/study.h"

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <span>
#include <vector>

namespace vitrine::test {

/// Table with parameters that trade accuracy for work, and one that does not.
struct KnownTable final : Parameters {
    Group group1 = group("Accuracy");
    Count steps = count("steps", 8, {1, 1024, logarithmic}, "More is exact.", quality(256));
    Count rays = count("rays", 4, {1, 64, logarithmic}, "More is exact.", quality(64));
    Choice<int> method = choice("method", 0, {"rough", "fair", "exact"}, "The last is exact.", quality(2));
    Toggle shortcut = toggle("shortcut", true, "Off is exact.", exactAt(0));
    Real hue = real("hue", 0.5, none, {0, 1}, "No question of accuracy.");
};

/// Error and cost of a picture with given values, by formulas and not by drawing.
struct KnownLaw {
    std::function<double(const KnownTable&, const ParameterValues&, double viewDifficulty)> error;
    std::function<double(const KnownTable&, const ParameterValues&, double viewDifficulty)> cost;
    bool noisy = false;  ///< The error is the standard deviation of noise; otherwise an offset.
};

/// Exhibit that passes the results of the law to the backend, in one pass.
class KnownExhibit final : public Exhibit {
public:
    explicit KnownExhibit(KnownLaw law) : law_(std::move(law)) {}
    [[nodiscard]] std::string_view name() const override { return "known"; }
    [[nodiscard]] std::string_view title() const override { return "Known"; }
    [[nodiscard]] std::string_view summary() const override { return "Its law is known."; }
    [[nodiscard]] int place() const override { return 9; }
    [[nodiscard]] const KnownTable& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override { return {glm::dvec3(-1), glm::dvec3(1)}; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override { return {{0, 0, 4}, {0, 0, 0}, 0.8}; }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override
    {
        return std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] std::vector<StudyView> studyViews(const ParameterValues& values) const override
    {
        std::vector<StudyView> views;
        for (const double difficulty : {1.0, 1.5, 2.0, 1.25, 1.75})
            views.push_back({"difficulty " + std::to_string(difficulty), bestView(values), difficulty, values});
        return views;
    }
    void plan(const PlanContext& context, render::FramePlan& plan) const override
    {
        render::Pass pass;
        pass.name = "known";
        const double difficulty = context.time;
        const double numbers[2] = {law_.error(table_, context.values, difficulty), law_.noisy ? 1.0 : 0.0};
        const std::span<const std::byte> bytes = std::as_bytes(std::span(numbers));
        pass.blocks[0] = render::Bytes(bytes.begin(), bytes.end());
        pass.counts["work"] = std::llround(1000 * law_.cost(table_, context.values, difficulty));
        pass.colors = {{radianceImage, render::Load::keep, {}, -1, 0},
                       {normalImage, render::Load::keep, {}, -1, 0},
                       {evaluationsImage, render::Load::keep, {}, -1, 0}};
        plan.add(std::move(pass));
    }

private:
    KnownLaw law_;
    KnownTable table_;
};

/// Backend that draws the results of KnownExhibit. Its milliseconds are the work, with noise if `timeNoise` is set.
class KnownBackend final : public render::RenderBackend {
public:
    double timeNoise = 0;
    int drawn = 0;
    int provisional = 0;  ///< Number of frames that left work for later ones, or used earlier ones.

    void seed(unsigned number) { engine_.seed(number); }

    render::FrameReport draw(const render::FramePlan& plan) override
    {
        ++drawn;
        provisional += plan.allSlices && plan.resetHistory ? 0 : 1;
        const render::Pass& pass = *plan.find("known");
        std::memcpy(numbers_, pass.blocks.at(0).data(), sizeof numbers_);
        size_ = plan.view.raster.drawn();
        render::FrameReport report;
        report.counters = {{"work", pass.counts.at("work")}, {"passes", 3}, {"images", drawn}};
        report.milliseconds = static_cast<double>(pass.counts.at("work")) / 1000 * (1 + timeNoise * (random() - 0.5));
        report.clock = "the law";
        report.clockTrusted = true;
        return report;
    }
    [[nodiscard]] render::Image read(const std::string& name) override
    {
        render::Image image(size_.x, size_.y, 4);
        if (name != "frame") return image;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const double sign = numbers_[1] == 0 ? (i % 8 < 4 ? 1.0 : -1.0) : std::sqrt(3.0) * (2 * random() - 1);
            image.pixels[i] = i % 4 == 3 ? 1.0F : static_cast<float>(0.5 + numbers_[0] * sign);
        }
        return image;
    }
    [[nodiscard]] const render::PersistentState& persistentState() const override { return kept_; }
    [[nodiscard]] int largestSide() const override { return 4096; }

private:
    double random() { return std::uniform_real_distribution<double>(0, 1)(engine_); }

    double numbers_[2] = {};
    glm::ivec2 size_{1};
    std::mt19937 engine_{1};
    render::PersistentState kept_;
};

/// Returns a law in which errors fall with the work, and each parameter contributes to both.
inline KnownLaw sumOfParts()
{
    KnownLaw law;
    law.error = [](const KnownTable& t, const ParameterValues& v, double difficulty) {
        const double method = v[t.method] == 0 ? 0.02 : v[t.method] == 1 ? 0.004 : 0;
        return difficulty * (0.2 / v[t.steps] - 0.2 / 256 + 0.05 / std::sqrt(v[t.rays]) - 0.05 / 8 + method +
                             (v[t.shortcut] ? 0.001 : 0));
    };
    law.cost = [](const KnownTable& t, const ParameterValues& v, double difficulty) {
        return difficulty * (1 + 0.1 * v[t.steps] + 0.3 * v[t.rays] + 0.5 * v[t.method]) * (v[t.shortcut] ? 0.6 : 1);
    };
    return law;
}

}  // namespace vitrine::test
