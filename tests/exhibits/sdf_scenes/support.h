#pragma once

#include "exhibits/sdf_scenes/scene_field.h"
#include "exhibits/sdf_scenes/scene_reader.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>

namespace vitrine::test {

/// A scene file around a root; `head` are further members, each with a comma behind it.
[[nodiscard]] std::string sceneText(const std::string& root, const std::string& head = "");

/// What the reader makes of a text without includes.
[[nodiscard]] scenes::ReadScene readText(const std::string& text, const scenes::SceneLimits& limits = {});

/// A scene that must be read.
[[nodiscard]] std::shared_ptr<const scenes::Scene> sceneOf(const std::string& root, const std::string& head = "");
[[nodiscard]] scenes::SceneField fieldOf(const std::string& root, const std::string& head = "");

/// The findings, a line each.
[[nodiscard]] std::string findingsText(const scenes::ReadScene&);

/// The same numbers on every machine.
class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    [[nodiscard]] double between(double low, double high)
    {
        return low + (high - low) * static_cast<double>(engine_() - std::mt19937::min()) / 4294967296.0;
    }
    [[nodiscard]] int below(int count) { return static_cast<int>(between(0, count)); }
    [[nodiscard]] glm::dvec3 point(double reach)
    {
        const double x = between(-reach, reach);
        const double y = between(-reach, reach);
        return {x, y, between(-reach, reach)};
    }
    [[nodiscard]] glm::dvec3 direction()
    {
        while (true) {
            const glm::dvec3 p = point(1);
            const double length = glm::length(p);
            if (length > 0.1 && length < 1) return p / length;
        }
    }

private:
    std::mt19937 engine_;
};

/// A node of this kind with random numbers that are legal, as JSON; `further` members have a comma before each.
[[nodiscard]] std::string randomNode(const scenes::NodeKind&, Random&, const std::string& further = "");
/// A tree of all kinds, nested at most this deep.
[[nodiscard]] std::string randomTree(Random&, int depth);
/// Members "translate", "rotate" and "scale", each with a comma before it.
[[nodiscard]] std::string randomPlace(Random&, bool evenScale);

/// By central differences.
[[nodiscard]] glm::dvec3 gradientAt(const scenes::SceneField&, const glm::dvec3& p);

}  // namespace vitrine::test
