#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/framework/prepare.h"
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

/// A node of an exhibit's tree. `id` names it until the tree changes.
struct TreeNode {
    static constexpr std::size_t none = ~std::size_t{0};

    std::string id;
    std::string name;  ///< Given by the author; empty: none.
    std::string kind;
    std::size_t parent = none;  ///< In `Tree::nodes`.
    bool hidden = false;
    bool takesChildren = false;  ///< Others can be added to it, and moved into it.
    bool movable = true;         ///< Its operation does without it.
    bool shared = false;         ///< A definition that stands in several places, beside the tree.

    bool operator==(const TreeNode&) const = default;
};

/// A kind that a node may be of.
struct TreeKind {
    std::string_view name;
    std::string_view help;        ///< One sentence.
    bool operation = false;       ///< It holds other nodes.
    std::string_view group = {};  ///< Heading under which it is offered; kinds of one group are adjacent.
    std::string words = {};       ///< Further words for the search.
};

/// What an exhibit is made of, as it can be edited: each node before its children, these in order.
struct Tree {
    std::vector<TreeNode> nodes;
    std::vector<TreeKind> kinds;

    /// Its index; `TreeNode::none` where there is none.
    [[nodiscard]] std::size_t find(std::string_view id) const;
    /// "ball", or the kind of one without a name.
    [[nodiscard]] static std::string_view title(const TreeNode& node)
    {
        return node.name.empty() ? std::string_view(node.kind) : std::string_view(node.name);
    }
};

/// One change of a tree. Which members count stands beside each.
struct TreeEdit {
    enum class What : std::uint8_t {
        add,        ///< To `node`, `before` its child of that number: a node of the kind `word`.
        duplicate,  ///< Once more behind it.
        remove,
        wrap,    ///< In an operation of the kind `word`.
        unwrap,  ///< Its only child takes its place.
        move,    ///< `before` that child of `parent`, counted as they are now.
        rename,  ///< To `word`.
        hide,
        show,
        solo,     ///< Hides everything else.
        showAll,  ///< Hides nothing.
        kind      ///< Makes it one of the kind `word`.
    };
    What what = What::add;
    std::string node = {};
    std::string word = {};
    std::string parent = {};
    std::size_t before = ~std::size_t{0};
};

/// What a change made, and the node that it was about.
struct EditedTree {
    ParameterValues values;
    std::string node;
};

/// The numbers of a node.
struct TreeRows {
    ParameterValues values;
    std::string note = {};  ///< A sentence about them; empty: none.
};

/// Where a node stands in its parent: scaled first, then turned about z, y and x, then moved.
struct TreePlace {
    glm::dmat4 exhibitFromParent{1};  ///< The exhibit's own space.
    glm::dvec3 translate{0};          ///< Meters of the parent.
    glm::dvec3 rotate{0};             ///< Radians.
    glm::dvec3 scale{1};
    /// Why no handles can stand there, as a sentence for people; empty: they can, and `exhibitFromParent` is what is
    /// around the node's middle as far as space is bent there.
    std::string without = {};

    [[nodiscard]] glm::dmat3 rotation() const;
};

/// What is seen of a node, in the exhibit's own space. Any thread may ask it.
struct TreeShape {
    render::Box box;                                ///< Holds it; infinite where it has no end.
    std::function<bool(const render::Ray&)> isHit;  ///< Whether the ray meets it, whatever stands before it.
};

/// Where the tree of an exhibit comes from and goes to. Rows of its table.
struct TreeDocument {
    std::size_t file = 0, document = 0;
    std::string path = {};  ///< Of the file.
    bool writable = false;  ///< The file is the visitor's, not the program's own.
};

/// Is made of a tree that visitors may edit. Changes are made of the exhibit's document (`Parameters::document`), so
/// that undo, presets and sessions hold them. `values` are those on show, under the table that was read for them.
class HasTree {
public:
    virtual ~HasTree() = default;

    [[nodiscard]] virtual Tree tree(const ParameterValues&) const = 0;
    /// Its numbers as the rows of a table of their own, in the same order while only numbers change. Empty where there
    /// is no such node.
    [[nodiscard]] virtual std::optional<TreeRows> rowsOf(const ParameterValues&, std::string_view node) const = 0;

    // Each throws Failure with a sentence for people where the change makes no sense, and changes nothing then. What
    // they give has the table for the new document, made through the store as `TableFromFiles::tableFor` would.

    [[nodiscard]] virtual EditedTree edited(const ParameterValues&, const TreeEdit&, render::AssetStore&) const = 0;
    /// With another value in that row of the node's.
    [[nodiscard]] virtual ParameterValues withRow(const ParameterValues&, std::string_view node, std::size_t row,
                                                  const Value&, render::AssetStore&) const = 0;
    /// With what differs of two places of a node.
    [[nodiscard]] virtual ParameterValues withPlace(const ParameterValues&, std::string_view node,
                                                    const TreePlace& from, const TreePlace& to,
                                                    render::AssetStore&) const = 0;

    /// The node that a ray of the exhibit's own space shows; empty: none.
    [[nodiscard]] virtual std::string pick(const ExhibitState&, const render::Ray&) const = 0;
    /// Nothing where there is no such node.
    [[nodiscard]] virtual std::optional<TreePlace> placeOf(const ExhibitState&, std::string_view node) const = 0;
    /// Makes what it takes to see the node's shape, which may take a while: any thread may call it. Null where there is
    /// no such node.
    [[nodiscard]] virtual std::shared_ptr<const TreeShape> shapeOf(const ExhibitState&,
                                                                   std::string_view node) const = 0;

    [[nodiscard]] virtual TreeDocument document(const ParameterValues&) const = 0;
    /// What stands in the file, or takes its place.
    [[nodiscard]] virtual std::string documentText(const ParameterValues&) const = 0;
    /// Whether a file with this text is one for its row.
    [[nodiscard]] virtual bool isDocument(const std::string& text) const = 0;
};

}  // namespace vitrine
