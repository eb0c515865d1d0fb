#pragma once

#include "tests/kit/ball/ball.h"
#include "tests/support/gallery.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace vitrine::test {

/// Shaders of an exhibit that is made in a test: its texts take the place of files.
inline std::shared_ptr<const render::ShaderSources> ballShaders()
{
    std::ifstream file(std::filesystem::path(VITRINE_SOURCE_DIR) / "tests/kit/ball/ball.glsl");
    return std::make_shared<render::ShaderSources>(
        std::map<std::string, std::string>{{"ball/ball.glsl", {std::istreambuf_iterator<char>(file), {}}}});
}

inline std::unique_ptr<Museum> museumOf(std::unique_ptr<Exhibit> exhibit)
{
    std::vector<std::unique_ptr<Exhibit>> list;
    list.push_back(std::move(exhibit));
    return std::make_unique<Museum>(std::move(list));
}

/// A museum in which the ball is alone, at the first place, where the sun reaches it.
inline const Museum& ballMuseum()
{
    static const auto opened = museumOf(std::make_unique<Ball>(1, ballShaders()));
    return *opened;
}
inline const BallTable& ballTable()
{
    static const BallTable table;
    return table;
}

/// A picture of that museum's exhibit: by default alone, linear, with depth and normals, from 2 m before it.
struct BallShot : Shot {
    explicit BallShot(const Museum& of = ballMuseum(), const char* name = "ball") : Shot(name, of)
    {
        size(96, 72);
        request.frame.camera = {{0, 0, 2}, {0, 0, 0}, 0.6};
    }
};

/// Meters from a line to a point.
inline double distanceOf(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& point)
{
    return glm::length(glm::cross(point - origin, glm::normalize(direction)));
}

}  // namespace vitrine::test
