#pragma once

#include "render/gl/context.h"
#include "render/gl/renderer.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace vitrine::test {

/// Context and renderer without a museum, for small plans and their pixels.
class RendererTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    [[nodiscard]] static render::gl::HeadlessContext& context();
    render::gl::Renderer& renderer() { return *renderer_; }

    /// Returns a plan of a picture of this size.
    [[nodiscard]] static render::FramePlan planOf(glm::ivec2 size);
    /// Prunes the plan for the output "frame" and draws it.
    render::FrameReport draw(render::FramePlan&);
    /// Returns a pass that draws one triangle over all of `image`. `body` is the body of main() in the fragment shader,
    /// which writes `color`; `before` precedes main().
    [[nodiscard]] static render::Pass fill(const std::string& name, const std::string& image, const std::string& body,
                                           const std::string& before = {});
    [[nodiscard]] static render::Pass compute(const std::string& name, const std::string& body,
                                              const std::string& before = {});
    bool expectsErrors_ = false;  ///< The driver may report errors, because the test uses a broken shader.

private:
    std::unique_ptr<render::gl::Renderer> renderer_;
    std::size_t errorsBefore_ = 0;
};

}  // namespace vitrine::test
