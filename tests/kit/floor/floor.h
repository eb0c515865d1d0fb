#pragma once

#include "exhibits/kit/portal.h"

#include <limits>

namespace vitrine::test {

struct FloorTable final : Parameters {
    Group look = group("Floor");
    Real green = real("green", 0.25, none, {0, 1}, "Of all squares.");
};

/// The smallest exhibit behind a deep frame: a floor of squares, in a world that is turned, shifted and three times as
/// large.
class Floor final : public Exhibit {
public:
    explicit Floor(std::shared_ptr<const render::ShaderSources> shaders, int place = 7)
        : shaders_(std::move(shaders)), place_(place)
    {
    }
    [[nodiscard]] std::string_view name() const override { return "floor"; }
    [[nodiscard]] std::string_view title() const override { return "Floor"; }
    [[nodiscard]] std::string_view summary() const override { return "The simplest world there is."; }
    [[nodiscard]] int place() const override { return place_; }
    [[nodiscard]] const FloorTable& parameters() const override { return table_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override { return portalBounds(portal()); }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override { return portalView(portal()); }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override
    {
        return std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] bool castsShadow() const override { return false; }
    void plan(const PlanContext& context, render::FramePlan& plan) const override
    {
        render::Pass pass = portalPass("floor/world", "in view", context.values, "floor/floor.frag", portal(), context);
        pass.shader.sources = shaders_;
        plan.add(std::move(pass));
    }
    [[nodiscard]] static Portal portal();

private:
    FloorTable table_;
    std::shared_ptr<const render::ShaderSources> shaders_;
    int place_;
};

}  // namespace vitrine::test
