#pragma once

#include "exhibits/sdf_scenes/scene_field.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace vitrine::test {

/// Returns a scene file with this root; `head` are further members, each followed by a comma.
[[nodiscard]] std::string sceneText(const std::string& root, const std::string& head = "");

/// Reads a text without includes.
[[nodiscard]] scenes::ReadScene readText(const std::string& text, const scenes::SceneLimits& limits = {});

/// Return the scene or field of a root, which must be valid.
[[nodiscard]] std::shared_ptr<const scenes::Scene> sceneOf(const std::string& root, const std::string& head = "");
[[nodiscard]] scenes::SceneField fieldOf(const std::string& root, const std::string& head = "");

/// Returns the findings, one in each line.
[[nodiscard]] std::string findingsText(const scenes::ReadScene&);

/// Returns a node of this kind with random legal numbers, as JSON; `further` members have a comma in front.
[[nodiscard]] std::string randomNode(const scenes::NodeKind&, Random&, const std::string& further = "");
/// Returns a tree of all kinds with this nesting depth at most.
[[nodiscard]] std::string randomTree(Random&, int depth);
/// Returns the members "translate", "rotate" and "scale", each with a comma in front.
[[nodiscard]] std::string randomPlace(Random&, bool evenScale);

/// Returns the gradient by central differences.
[[nodiscard]] glm::dvec3 gradientAt(const scenes::SceneField&, const glm::dvec3& p);

}  // namespace vitrine::test
