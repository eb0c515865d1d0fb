#pragma once

#include "exhibits/framework/table/derive.h"
#include "exhibits/kit/sdf_exhibit.h"

namespace vitrine::test {

struct BallParameters : virtual Parameters {
    Group shape = group("Ball");
    Real radius = real("radius", 0.3, meter, Range{0.01, 2}.soft(0.1, 0.6), "Radius of the ball.");
};
struct BallTable final : BallParameters, SdfMaterialParameters, SdfParameters {};

/// A ball: the simplest distance field.
class Ball final : public SdfExhibit {
public:
    explicit Ball(int place = 5, std::shared_ptr<const render::ShaderSources> shaders = {})
        : SdfExhibit({.field = "ball/ball.glsl", .generated = std::move(shaders)}), place_(place)
    {
    }
    [[nodiscard]] std::string_view name() const override { return "ball"; }
    [[nodiscard]] std::string_view title() const override { return "Ball"; }
    [[nodiscard]] std::string_view summary() const override { return "The simplest distance field."; }
    [[nodiscard]] int place() const override { return place_; }
    [[nodiscard]] const BallTable& parameters() const override { return table_; }
    [[nodiscard]] SdfBody body(const ParameterValues& values, double) const override
    {
        const double radius = values[table_.radius];
        return {.values = values,
                .box = {glm::dvec3(-radius), glm::dvec3(radius)},
                .distance = [radius](const glm::dvec3& p) { return glm::length(p) - radius; },
                .shape = derive::keyOf(values, {table_.radius.row})};
    }

private:
    [[nodiscard]] const SdfParameters& rows() const override { return table_; }
    [[nodiscard]] const SdfMaterialParameters* materialParameters() const override { return &table_; }

    BallTable table_;
    int place_;
};

}  // namespace vitrine::test
