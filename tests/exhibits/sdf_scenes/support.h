#pragma once

#include "exhibits/sdf_scenes/scene_field.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <memory>
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

/// A node of this kind with random numbers that are legal, as JSON; `further` members have a comma before each.
[[nodiscard]] std::string randomNode(const scenes::NodeKind&, Random&, const std::string& further = "");
/// A tree of all kinds, nested at most this deep.
[[nodiscard]] std::string randomTree(Random&, int depth);
/// Members "translate", "rotate" and "scale", each with a comma before it.
[[nodiscard]] std::string randomPlace(Random&, bool evenScale);

/// By central differences.
[[nodiscard]] glm::dvec3 gradientAt(const scenes::SceneField&, const glm::dvec3& p);

}  // namespace vitrine::test
