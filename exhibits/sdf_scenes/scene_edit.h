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

/// A scene's text after a change of its tree, and the path of the node that the change was about.
struct EditedScene {
    std::string text;
    std::string path;
};

/// Changes of the tree in a scene's own file. What is not touched keeps its text. Nodes are named by their paths in the
/// file: "root.children[1]" (JsonText::path). Each change throws Failure with a sentence for people where it makes no
/// sense; what it gives is still to be read, as what it names may be missing.
class SceneEdit {
public:
    /// Throws JsonFailure where the text is no JSON.
    explicit SceneEdit(std::string text);

    /// A new node of this kind with initial numbers, before the child of this number or behind the last one.
    [[nodiscard]] EditedScene added(std::string_view parent, std::size_t before, const NodeKind&) const;
    /// The same node once more, behind it. Where there is room for one node only, both come into a union.
    [[nodiscard]] EditedScene duplicated(std::string_view node) const;
    /// Without it; an operation that would have no child left goes with it. The path is that of what it was part of.
    [[nodiscard]] EditedScene removed(std::string_view node) const;
    /// Inside an operation of this kind. A pair gets a sphere beside it.
    [[nodiscard]] EditedScene wrapped(std::string_view node, const NodeKind& operation) const;
    /// The only child in the place of its operation, which must not move, turn or scale it.
    [[nodiscard]] EditedScene unwrapped(std::string_view operation) const;
    /// Before that child of another parent, or of its own: the number counts the children as they are now.
    [[nodiscard]] EditedScene moved(std::string_view node, std::string_view parent, std::size_t before) const;
    /// "" takes its name away.
    [[nodiscard]] EditedScene renamed(std::string_view node, const std::string& name) const;
    /// "" takes it away: it is made of what its parent is made of.
    [[nodiscard]] EditedScene withMaterial(std::string_view node, const std::string& material) const;
    [[nodiscard]] EditedScene hidden(std::string_view node, bool) const;
    /// Hides everything else.
    [[nodiscard]] EditedScene solo(std::string_view node) const;
    /// Hides nothing any more.
    [[nodiscard]] EditedScene allShown() const;
    /// Another kind, with those of its members that the new kind has, too. A shape stays a shape, and an operation one.
    [[nodiscard]] EditedScene ofKind(std::string_view node, const NodeKind&) const;
    /// With other numbers of a field, SI: one for each number of the field.
    [[nodiscard]] EditedScene withNumbers(std::string_view node, const Field&, const std::vector<double>&) const;
    /// With one other number of a field, SI. The field's others keep their text, where they have one.
    [[nodiscard]] EditedScene withNumber(std::string_view node, const Field&, std::size_t component, double) const;

private:
    /// A node's index; throws where there is none at this path.
    [[nodiscard]] std::uint32_t at(std::string_view node) const;
    [[nodiscard]] const NodeKind& kindOf(std::uint32_t node) const;
    /// The array that holds it among other children, or nothing.
    [[nodiscard]] std::optional<std::uint32_t> listOf(std::uint32_t node) const;
    /// The operation that it is a child of, or nothing.
    [[nodiscard]] std::optional<std::uint32_t> operationOf(std::uint32_t node) const;
    [[nodiscard]] std::vector<std::uint32_t> childrenOf(std::uint32_t node) const;
    [[nodiscard]] std::vector<std::uint32_t> nodes() const;
    [[nodiscard]] std::string freeName(const std::string& like) const;
    /// With these nodes hidden or shown.
    [[nodiscard]] std::string withHidden(const std::vector<std::pair<std::uint32_t, bool>>&) const;

    render::JsonText text_;
};

/// A node of this kind with initial numbers, as JSON; operations hold a sphere, a pair two shapes.
[[nodiscard]] std::string freshNode(const NodeKind&);

}  // namespace vitrine::scenes
