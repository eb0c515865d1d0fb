#pragma once

#include "render/gl/context.h"
#include "render/gl/renderer.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace vitrine::test {

/// A context and a renderer without a museum: plans of a few lines, and their pixels.
class RendererTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    [[nodiscard]] static render::gl::HeadlessContext& context();
    render::gl::Renderer& renderer() { return *renderer_; }

    /// A plan of a picture of that size.
    [[nodiscard]] static render::FramePlan planOf(glm::ivec2 size);
    /// Prunes for the output "frame" and draws.
    render::FrameReport draw(render::FramePlan&);
    /// One triangle over all of `image`, by a fragment shader of which this is the body of main(); `before` comes
    /// before main(). It writes `color`.
    [[nodiscard]] static render::Pass fill(const std::string& name, const std::string& image, const std::string& body,
                                           const std::string& before = {});
    [[nodiscard]] static render::Pass compute(const std::string& name, const std::string& body,
                                              const std::string& before = {});
    bool expectsErrors_ = false;  ///< Of the driver: a broken shader is part of the test.

private:
    std::unique_ptr<render::gl::Renderer> renderer_;
    std::size_t errorsBefore_ = 0;
};

}  // namespace vitrine::test
