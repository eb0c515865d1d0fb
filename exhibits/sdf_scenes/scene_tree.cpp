#include "exhibits/sdf_scenes/scene_tree.h"

#include "exhibits/sdf_scenes/scene_edit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::scenes {
namespace {

using render::JsonText;
using JsonType = render::JsonSpan::Type;

std::string stringAt(const JsonText& json, std::uint32_t object, std::string_view key)
{
    const auto value = json.member(object, key);
    return value && json.value(*value).type == JsonType::string ? json.string(*value) : std::string();
}

/// Returns the kind for display: "sphere" or "instance of ball".
std::string kindWords(const JsonText& json, std::uint32_t value)
{
    const std::string kind = stringAt(json, value, "kind");
    const std::string from = stringAt(json, value, "of") + stringAt(json, value, "file");
    return findKind(kind) || from.empty() ? kind : kind + " of " + from;
}

/// A value of the file that is yet to be converted to a node.
struct Waiting {
    std::uint32_t value;
    std::string id;
    std::size_t parent;
    bool movable, shared;
};

void addNodes(const JsonText& json, Waiting first, Tree& tree)
{
    std::vector<Waiting> waiting{std::move(first)};
    while (!waiting.empty()) {
        const Waiting now = std::move(waiting.back());
        waiting.pop_back();
        if (json.value(now.value).type != JsonType::object) continue;
        const NodeKind* kind = findKind(stringAt(json, now.value, "kind"));
        const auto hidden = json.member(now.value, "hidden");
        const bool takes = kind && kind->form == Form::operands;
        const std::size_t index = tree.nodes.size();
        tree.nodes.push_back({now.id, stringAt(json, now.value, "name"), kindWords(json, now.value), now.parent,
                              hidden && json.boolean(*hidden), takes, now.movable, now.shared});
        if (const auto child = json.member(now.value, "child"))
            waiting.push_back({*child, now.id + ".child", index, false, false});
        const auto list = json.member(now.value, "children");
        if (!list || json.value(*list).type != JsonType::array) continue;
        const std::vector<std::uint32_t> children = json.children(*list);
        for (std::size_t i = children.size(); i-- > 0;)
            waiting.push_back({children[i], now.id + ".children[" + std::to_string(i) + "]", index,
                               takes && children.size() > 1, false});
    }
}

/// Words for the search: names and help texts of the fields. A blend width finds "smooth", as in "smooth union".
std::string wordsOf(const NodeKind& kind)
{
    std::string words;
    for (const Field& field : kind.fields) {
        ((words += field.name) += ' ') += field.help;
        words += field.name == "blendWidth" ? " Smooth. " : " ";
    }
    return words;
}

const std::vector<TreeKind>& offeredKinds()
{
    static const std::vector<TreeKind> all = [] {
        std::vector<TreeKind> offered;
        const auto add = [&](std::string_view group, const std::vector<NodeKind>& kinds) {
            for (const NodeKind& kind : kinds)
                offered.push_back({kind.name, kind.help, kind.form != Form::shape, group, wordsOf(kind)});
        };
        add("Solids", solidKinds());
        add("More solids", furtherSolidKinds());
        add("Flat shapes", profileKinds());
        add("Combine", operandKinds());
        add("Reshape", modifierKinds());
        add("Repeat", repeaterKinds());
        return offered;
    }();
    return all;
}

}  // namespace

Tree treeOf(const Scene& scene)
{
    Tree tree;
    tree.kinds = offeredKinds();
    const JsonText& json = *scene.files.front().text;
    if (const auto root = json.member(0, "root")) addNodes(json, {*root, "root", TreeNode::none, false, false}, tree);
    if (const auto named = json.member(0, "nodes"))
        for (const std::uint32_t value : json.children(*named)) {
            const std::size_t index = tree.nodes.size();
            addNodes(json, {value, json.wholePath(value), TreeNode::none, false, true}, tree);
            if (index < tree.nodes.size() && tree.nodes[index].name.empty()) tree.nodes[index].name = json.key(value);
        }
    return tree;
}

std::uint32_t nodeAt(const Scene& scene, std::string_view path)
{
    const auto value = scene.files.front().text->at(path);
    if (!value) return noIndex;
    const auto found = std::find_if(scene.nodes.begin(), scene.nodes.end(), [&](const Node& node) {
        return node.origin.file == 0 && node.origin.value == *value;
    });
    return found == scene.nodes.end() ? noIndex : static_cast<std::uint32_t>(found - scene.nodes.begin());
}

std::string pathOf(const Scene& scene, std::uint32_t node)
{
    // Searches from the root: the first node whose descendants come from elsewhere is the one that includes them.
    std::vector<std::uint32_t> way;
    for (std::uint32_t n = node; n != noIndex; n = scene.nodes[n].parent) way.push_back(n);
    const JsonText& json = *scene.files.front().text;
    for (auto n = way.rbegin(); n != way.rend(); ++n) {
        const Node& at = scene.nodes[*n];
        if (at.origin.file == 0 && (*n == node || !findKind(stringAt(json, at.origin.value, "kind"))))
            return json.wholePath(at.origin.value);
    }
    return {};
}

std::shared_ptr<const Scene> onlyNode(const Scene& scene, std::string_view path)
{
    const auto value = scene.files.front().text->at(path);
    auto only = std::make_shared<Scene>(scene);
    std::vector<char> inside(scene.nodes.size(), 0), kept(scene.nodes.size(), 0);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const bool meant = value && node.origin.file == 0 && node.origin.value == *value;
        const bool under = node.parent != noIndex && inside[node.parent];
        inside[i] = meant || under;
        kept[i] = inside[i];
        if (meant || !under) only->nodes[i].hidden = false;
    }
    for (std::size_t i = scene.nodes.size(); i-- > 0;) {
        Node& node = only->nodes[i];
        if (!kept[i])
            node.hidden = true;
        else if (node.parent != noIndex)
            kept[node.parent] = 1;
        // Shows subtracted shapes themselves, without the shape that they are subtracted from.
        if (kept[i] && !inside[i] && node.kind->name == "subtraction") node.kind = findKind("union");
    }
    return only;
}

double marched(const SceneField& field, const glm::dvec3& origin, const glm::dvec3& direction, double start, double end)
{
    constexpr int mostSteps = 400;
    double t = start;
    for (int i = 0; i < mostSteps && t < end; ++i) {
        const double distance = field.distance(origin + t * direction);
        if (distance <= 5e-4 * t + 1e-6) return t;
        t += distance;
    }
    return std::numeric_limits<double>::infinity();
}

}  // namespace vitrine::scenes
