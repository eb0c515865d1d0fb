#pragma once

#include "exhibits/sdf_scenes/node_kinds.h"
#include "render/files/json_text.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine::scenes {

/// Text of a scene after a change of its tree, and the path of the node that was changed.
struct EditedScene {
    std::string text;
    std::string path;
};

/// Changes of the tree in a scene's own file. Everything else keeps its text. Nodes are given by their paths in the
/// file: "root.children[1]" (JsonText::path). Each change throws Failure with a sentence for people if it makes no
/// sense. The result must still be read, because it may refer to missing things.
class SceneEdit {
public:
    /// Throws JsonFailure if the text is not JSON.
    explicit SceneEdit(std::string text);

    /// Adds a new node of this kind with initial numbers, before the child with index `before` or after the last one.
    [[nodiscard]] EditedScene added(std::string_view parent, std::size_t before, const NodeKind&) const;
    /// Adds a copy of the node after it. If there is room for one node only, both are put into a union.
    [[nodiscard]] EditedScene duplicated(std::string_view node) const;
    /// Removes the node; an operation that has no child left is removed, too. The path is that of its former parent.
    [[nodiscard]] EditedScene removed(std::string_view node) const;
    /// Wraps the node in an operation of this kind. A pair gets a sphere as second child.
    [[nodiscard]] EditedScene wrapped(std::string_view node, const NodeKind& operation) const;
    /// Replaces an operation by its only child. The operation must not translate, rotate or scale it.
    [[nodiscard]] EditedScene unwrapped(std::string_view operation) const;
    /// Moves the node before a child of another parent, or of its own: the index counts the children before the change.
    [[nodiscard]] EditedScene moved(std::string_view node, std::string_view parent, std::size_t before) const;
    /// Sets the name; "" removes it.
    [[nodiscard]] EditedScene renamed(std::string_view node, const std::string& name) const;
    /// Sets the material; "" removes it, so that the parent's material is used.
    [[nodiscard]] EditedScene withMaterial(std::string_view node, const std::string& material) const;
    [[nodiscard]] EditedScene hidden(std::string_view node, bool) const;
    /// Hides all other nodes.
    [[nodiscard]] EditedScene solo(std::string_view node) const;
    /// Shows all nodes.
    [[nodiscard]] EditedScene allShown() const;
    /// Changes the kind; members that the new kind has, too, are kept. Shapes stay shapes, and operations stay
    /// operations.
    [[nodiscard]] EditedScene ofKind(std::string_view node, const NodeKind&) const;
    /// Sets the numbers of a field, SI: one value for each.
    [[nodiscard]] EditedScene withNumbers(std::string_view node, const Field&, const std::vector<double>&) const;
    /// Sets one number of a field, SI. The field's other numbers keep their text, if they have one.
    [[nodiscard]] EditedScene withNumber(std::string_view node, const Field&, std::size_t component, double) const;

private:
    /// Returns a node's index; throws if there is none at this path.
    [[nodiscard]] std::uint32_t at(std::string_view node) const;
    [[nodiscard]] const NodeKind& kindOf(std::uint32_t node) const;
    /// Returns the array that contains it among other children, or nothing.
    [[nodiscard]] std::optional<std::uint32_t> listOf(std::uint32_t node) const;
    /// Returns the operation that it is a child of, or nothing.
    [[nodiscard]] std::optional<std::uint32_t> operationOf(std::uint32_t node) const;
    [[nodiscard]] std::vector<std::uint32_t> childrenOf(std::uint32_t node) const;
    [[nodiscard]] std::vector<std::uint32_t> nodes() const;
    [[nodiscard]] std::string freeName(const std::string& like) const;
    /// Returns the text with these nodes hidden or shown.
    [[nodiscard]] std::string withHidden(const std::vector<std::pair<std::uint32_t, bool>>&) const;

    render::JsonText text_;
};

/// Returns a new node of this kind with initial numbers, as JSON; operations contain a sphere, a pair two shapes.
[[nodiscard]] std::string freshNode(const NodeKind&);

}  // namespace vitrine::scenes
