#pragma once

#include "exhibits/framework/scene/document.h"
#include "exhibits/framework/scene/prepare.h"
#include "exhibits/framework/table/parameters.h"
#include "render/files/asset_store.h"
#include "render/scene/ray.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// A node of an exhibit's tree. `id` is valid until the tree changes.
struct TreeNode {
    static constexpr std::size_t none = ~std::size_t{0};

    std::string id;
    std::string name;  ///< Name given by the author; empty: none.
    std::string kind;
    std::size_t parent = none;  ///< Index in `Tree::nodes`.
    bool hidden = false;
    bool takesChildren = false;  ///< Nodes can be added to it and moved into it.
    bool movable = true;         ///< True if its parent stays valid without it.
    bool shared = false;  ///< True for a definition listed beside the tree, which is instanced in several places.

    bool operator==(const TreeNode&) const = default;
};

/// A kind of node.
struct TreeKind {
    std::string_view name;
    std::string_view help;        ///< One sentence.
    bool operation = false;       ///< It holds other nodes.
    std::string_view group = {};  ///< Heading under which it is offered; kinds of one group are adjacent.
    std::string words = {};       ///< Further words for the search.
};

/// Editable tree of an exhibit: each node precedes its children; children are in order.
struct Tree {
    std::vector<TreeNode> nodes;
    std::vector<TreeKind> kinds;

    /// Returns the index of a node; `TreeNode::none` if there is none.
    [[nodiscard]] std::size_t find(std::string_view id) const;
    /// Returns the name of a node ("ball"), or its kind if it has no name.
    [[nodiscard]] static std::string_view title(const TreeNode& node)
    {
        return node.name.empty() ? std::string_view(node.kind) : std::string_view(node.name);
    }
};

/// An edit of a tree. The comment of each kind of edit names the members that it uses.
struct TreeEdit {
    enum class What : std::uint8_t {
        add,        ///< Adds a node of the kind `word` to `node`, in front of its child number `before`.
        duplicate,  ///< Inserts a copy after `node`.
        remove,
        wrap,    ///< Puts `node` into a new operation of the kind `word`.
        unwrap,  ///< Replaces `node` by its only child.
        move,    ///< Moves `node` into `parent`, in front of its child number `before` (counted before the move).
        rename,  ///< Renames `node` to `word`.
        hide,
        show,
        solo,     ///< Hides everything except `node`.
        showAll,  ///< Shows all nodes.
        kind      ///< Changes the kind of `node` to `word`.
    };
    What what = What::add;
    std::string node = {};
    std::string word = {};
    std::string parent = {};
    std::size_t before = ~std::size_t{0};
};

/// Result of an edit: the new values and the edited node.
struct EditedTree {
    ParameterValues values;
    std::string node;
};

/// Parameters of a node.
struct TreeParameters {
    ParameterValues values;
    std::string note = {};  ///< Sentence about them; empty: none.
};

/// Transformation of a node relative to its parent: scale first, then rotation about z, y and x, then translation.
struct TreePlace {
    glm::dmat4 exhibitFromParent{1};  ///< Transformation from the parent to exhibit space.
    glm::dvec3 translate{0};          ///< Meters in the parent's space.
    glm::dvec3 rotate{0};             ///< Euler angles in radians.
    glm::dvec3 scale{1};
    /// Sentence that explains why no handles can be shown; empty if they can. In warped space `exhibitFromParent` is
    /// the local linearization at the node's center.
    std::string without = {};

    [[nodiscard]] glm::dmat3 rotation() const;
};

/// Visible shape of a node in exhibit space. Thread-safe.
struct TreeShape {
    render::Box box;                                ///< Bounding box; infinite if the shape is unbounded.
    std::function<bool(const render::Ray&)> isHit;  ///< Returns whether the ray hits the shape, even if it is occluded.
};

/// Interface of exhibits with a tree that visitors can edit. Edits change the exhibit's document. `values` are the
/// shown values, with the table that was read for them.
class HasTree : public HasDocument {
public:
    [[nodiscard]] virtual Tree tree(const ParameterValues&) const = 0;
    /// Returns the numbers of a node as parameters of a separate table; their order is the same while only numbers
    /// change. Returns nullopt if there is no such node.
    [[nodiscard]] virtual std::optional<TreeParameters> parametersOf(const ParameterValues&,
                                                                     std::string_view node) const = 0;

    // Each of the next functions throws Failure with a sentence for the user if the edit is invalid, and then changes
    // nothing. The result has the table of the new document, made through the store like
    // `TableFromFiles::dynamicParameters`.

    [[nodiscard]] virtual EditedTree edited(const ParameterValues&, const TreeEdit&, render::AssetStore&) const = 0;
    /// Returns the values with a new value in a parameter of the node.
    [[nodiscard]] virtual ParameterValues withParameter(const ParameterValues&, std::string_view node, std::size_t row,
                                                        const Value&, render::AssetStore&) const = 0;
    /// Returns the values with the changes between two transformations applied to the node.
    [[nodiscard]] virtual ParameterValues withPlace(const ParameterValues&, std::string_view node,
                                                    const TreePlace& from, const TreePlace& to,
                                                    render::AssetStore&) const = 0;

    /// Returns the node that a ray (exhibit space) hits; empty if none.
    [[nodiscard]] virtual std::string pick(const ExhibitState&, const render::Ray&) const = 0;
    /// Returns the transformation of a node; nullopt if there is no such node.
    [[nodiscard]] virtual std::optional<TreePlace> placeOf(const ExhibitState&, std::string_view node) const = 0;
    /// Makes the visible shape of a node. May be slow; thread-safe. Returns null if there is no such node.
    [[nodiscard]] virtual std::shared_ptr<const TreeShape> shapeOf(const ExhibitState&,
                                                                   std::string_view node) const = 0;
};

}  // namespace vitrine
