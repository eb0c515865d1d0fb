#include "exhibits/sdf_scenes/scene_edit.h"

#include "exhibits/sdf_scenes/record_kinds.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/text/joined.h"

#include <algorithm>
#include <set>

namespace vitrine::scenes {
namespace {

using JsonType = render::JsonSpan::Type;
using render::JsonText;

constexpr std::string_view namedNodes = "nodes";

std::string quoted(const std::string& text)
{
    return render::Json(text).dump();
}

bool takesOne(const NodeKind& kind)
{
    return kind.form == Form::modifier || kind.form == Form::repeater;
}

[[noreturn]] void refuse(const std::string& sentence)
{
    throw Failure(ErrorKind::check, sentence);
}

/// Returns an operation of this kind with these children, as JSON.
std::string operationText(const NodeKind& kind, const std::vector<std::string>& children)
{
    const std::string text = "{\"kind\": " + quoted(std::string(kind.name)) + ", ";
    if (takesOne(kind)) return text + "\"child\": " + children.front() + "}";
    return text + "\"children\": [" + vitrine::joined(children) + "]}";
}

/// Returns a number of a field as written in files, in its unit.
std::string numberText(const Field& field, double x)
{
    if (field.type == FieldType::toggle) return x != 0 ? "true" : "false";
    if (field.type == FieldType::choice) return quoted(std::string(field.choices.at(static_cast<std::size_t>(x))));
    return render::shortestNumber(shown(x, field.unit));
}

std::string threeText(const std::vector<std::string>& numbers)
{
    return "[" + numbers[0] + ", " + numbers[1] + ", " + numbers[2] + "]";
}

std::string numbersText(const Field& field, const std::vector<double>& numbers)
{
    std::vector<std::string> all;
    for (const double x : numbers) all.push_back(numberText(field, x));
    return all.size() == 1 ? all[0] : threeText(all);
}

/// Returns whether a value is legal for a field, if it is constant.
bool fits(const JsonText& text, std::uint32_t value, const Field& field)
{
    const JsonType type = text.value(value).type;
    if (field.type == FieldType::toggle) return type == JsonType::boolean;
    if (field.type == FieldType::choice)
        return type == JsonType::string &&
               std::find(field.choices.begin(), field.choices.end(), text.string(value)) != field.choices.end();
    const auto legal = [&](std::uint32_t number) {
        if (text.value(number).type == JsonType::string) return true;
        const double x = text.value(number).type == JsonType::number ? stored(text.number(number), field.unit) : -1e300;
        return x >= field.low && x <= field.high;
    };
    if (type != JsonType::array)
        return type != JsonType::object && (numbersOf(field.type) == 1 || field.type == FieldType::sizes) &&
               legal(value);
    const std::vector<std::uint32_t> numbers = text.children(value);
    return numbers.size() == numbersOf(field.type) && std::all_of(numbers.begin(), numbers.end(), legal);
}

/// A path split into a list and the index in it: "root.children[2].child" in "root.children" gives 2 and the rest
/// ".child".
struct InList {
    std::size_t number = 0;
    std::string rest;
};

std::optional<InList> inList(const std::string& path, const std::string& list)
{
    if (path.compare(0, list.size() + 1, list + "[") != 0) return std::nullopt;
    const std::size_t end = path.find(']', list.size());
    return InList{static_cast<std::size_t>(std::stoul(path.substr(list.size() + 1, end - list.size() - 1))),
                  path.substr(end + 1)};
}

std::string inListText(const std::string& list, std::size_t number, const std::string& rest = {})
{
    return list + "[" + std::to_string(number) + "]" + rest;
}

}  // namespace

std::string freshNode(const NodeKind& kind)
{
    if (kind.form == Form::shape) return "{\"kind\": " + quoted(std::string(kind.name)) + "}";
    const std::string sphere = freshNode(*findKind("sphere"));
    if (kind.form == Form::pair) return operationText(kind, {sphere, freshNode(*findKind("box"))});
    return operationText(kind, {sphere});
}

SceneEdit::SceneEdit(std::string text) : text_(std::move(text), "scene") {}

std::uint32_t SceneEdit::at(std::string_view node) const
{
    const auto found = text_.at(node);
    if (!found || text_.value(*found).type != JsonType::object || !text_.member(*found, "kind"))
        refuse("There is no node " + std::string(node) + " any more; choose another one.");
    return *found;
}

const NodeKind& SceneEdit::kindOf(std::uint32_t node) const
{
    const auto word = text_.member(node, "kind");
    const NodeKind* kind = word ? findKind(text_.string(*word)) : nullptr;
    if (!kind) refuse("An instance or an included node has no kind of its own; change it where it is defined.");
    return *kind;
}

std::optional<std::uint32_t> SceneEdit::operationOf(std::uint32_t node) const
{
    const std::uint32_t parent = text_.value(node).parent;
    const std::uint32_t holder = text_.value(parent).type == JsonType::array ? text_.value(parent).parent : parent;
    const auto kind = text_.member(holder, "kind");
    return kind && text_.value(*kind).type == JsonType::string ? std::optional(holder) : std::nullopt;
}

std::optional<std::uint32_t> SceneEdit::listOf(std::uint32_t node) const
{
    const std::uint32_t parent = text_.value(node).parent;
    if (parent == render::JsonSpan::none || text_.value(parent).type != JsonType::array) return std::nullopt;
    return parent;
}

std::vector<std::uint32_t> SceneEdit::childrenOf(std::uint32_t node) const
{
    if (const auto child = text_.member(node, "child")) return {*child};
    if (const auto list = text_.member(node, "children")) return text_.children(*list);
    return {};
}

std::vector<std::uint32_t> SceneEdit::nodes() const
{
    std::vector<std::uint32_t> found;
    if (const auto root = text_.member(0, "root")) found.push_back(*root);
    if (const auto named = text_.member(0, namedNodes))
        for (const std::uint32_t node : text_.children(*named)) found.push_back(node);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const std::uint32_t child : childrenOf(found[i])) found.push_back(child);
    return found;
}

std::string SceneEdit::freeName(const std::string& like) const
{
    std::set<std::string> taken;
    for (const std::uint32_t node : nodes())
        if (const auto name = text_.member(node, "name")) taken.insert(text_.string(*name));
    for (int number = 2;; ++number)
        if (const std::string name = like + " " + std::to_string(number); taken.count(name) == 0) return name;
}

EditedScene SceneEdit::added(std::string_view parent, std::size_t before, const NodeKind& kind) const
{
    const std::uint32_t to = at(parent);
    if (kindOf(to).form != Form::operands)
        refuse("A " + std::string(kindOf(to).name) + " takes no further child; wrap it in a union first.");
    const auto list = text_.member(to, "children");
    if (!list || text_.value(*list).type != JsonType::array) refuse("This node has no \"children\"; mend the file.");
    const std::size_t index = std::min(before, text_.children(*list).size());
    return {text_.withElement(*list, index, freshNode(kind)), inListText(text_.wholePath(*list), index)};
}

EditedScene SceneEdit::duplicated(std::string_view node) const
{
    const std::uint32_t from = at(node);
    std::string copy(text_.written(from));
    if (const auto name = text_.member(from, "name")) {
        const JsonText alone(copy, "copy");
        copy = alone.withMember(0, "name", quoted(freeName(text_.string(*name))));
    }
    const auto list = listOf(from);
    const auto operation = operationOf(from);
    if (!list || !operation || kindOf(*operation).form != Form::operands) {
        const std::string both = operationText(*findKind("union"), {std::string(text_.written(from)), copy});
        return {text_.withValue(from, both), std::string(node) + ".children[1]"};
    }
    const auto in = inList(text_.wholePath(from), text_.wholePath(*list));
    return {text_.withElement(*list, in->number + 1, copy), inListText(text_.wholePath(*list), in->number + 1)};
}

EditedScene SceneEdit::removed(std::string_view node) const
{
    std::uint32_t gone = at(node);
    while (true) {
        const auto operation = operationOf(gone);
        if (!operation) {
            if (text_.wholePath(gone) == "root")
                refuse("The root cannot be deleted, because every scene has one; change its kind instead.");
            return {text_.without(gone), "root"};
        }
        const std::vector<std::uint32_t> children = childrenOf(*operation);
        if (children.size() > 2 || (children.size() == 2 && kindOf(*operation).form == Form::operands))
            return {text_.without(gone), text_.wholePath(*operation)};
        if (children.size() == 2) {
            const std::uint32_t left = children[0] == gone ? children[1] : children[0];
            return {text_.withValue(*operation, text_.written(left)), text_.wholePath(*operation)};
        }
        gone = *operation;
    }
}

EditedScene SceneEdit::wrapped(std::string_view node, const NodeKind& operation) const
{
    const std::uint32_t inside = at(node);
    if (operation.form == Form::shape)
        refuse("A " + std::string(operation.name) + " holds no other node; choose an operation.");
    std::vector<std::string> children{std::string(text_.written(inside))};
    if (operation.form == Form::pair) children.push_back(freshNode(*findKind("sphere")));
    return {text_.withValue(inside, operationText(operation, children)), std::string(node)};
}

EditedScene SceneEdit::unwrapped(std::string_view operation) const
{
    const std::uint32_t outside = at(operation);
    const std::vector<std::uint32_t> children = childrenOf(outside);
    if (children.size() != 1) refuse("Only an operation of one child can be taken away from around it.");
    for (const Field& field : placeFields())
        if (text_.member(outside, field.name))
            refuse("It has \"" + std::string(field.name) + "\", which its child would lose; remove that member first.");
    return {text_.withValue(outside, text_.written(children[0])), std::string(operation)};
}

EditedScene SceneEdit::moved(std::string_view node, std::string_view parent, std::size_t before) const
{
    const std::uint32_t from = at(node);
    const std::uint32_t to = at(parent);
    const auto fromList = listOf(from);
    const auto operation = operationOf(from);
    const auto toList = text_.member(to, "children");
    if (kindOf(to).form != Form::operands || !toList)
        refuse("A " + std::string(kindOf(to).name) + " takes no further child; wrap it in a union first.");
    if (!fromList || !operation || kindOf(*operation).form != Form::operands || childrenOf(*operation).size() < 2)
        refuse("The operation around it would have too few children; delete or unwrap the operation.");
    const std::string path = text_.wholePath(from);
    const std::string target = text_.wholePath(*toList);
    if (target.compare(0, path.size(), path) == 0 && (target.size() == path.size() || target[path.size()] == '.'))
        refuse("A node cannot be moved into itself.");
    std::size_t index = std::min(before, text_.children(*toList).size());
    const JsonText longer(text_.withElement(*toList, index, text_.written(from)), "scene");
    // The insertion moves later elements of that list; the removal moves them back.
    std::string old = path;
    if (const auto in = inList(path, target); in && in->number >= index)
        old = inListText(target, in->number + 1, in->rest);
    std::string now = inListText(target, index);
    const std::string oldList = old.substr(0, old.rfind('['));
    const std::size_t oldNumber = inList(old, oldList)->number;
    if (const auto in = inList(now, oldList); in && in->number > oldNumber)
        now = inListText(oldList, in->number - 1, in->rest);
    return {longer.without(longer.at(old).value()), now};
}

EditedScene SceneEdit::renamed(std::string_view node, const std::string& name) const
{
    const std::uint32_t named = at(node);
    const auto old = text_.member(named, "name");
    if (name.empty()) return {old ? text_.without(*old) : text_.text(), std::string(node)};
    return {text_.withMember(named, "name", quoted(name)), std::string(node)};
}

EditedScene SceneEdit::withMaterial(std::string_view node, const std::string& material) const
{
    const std::uint32_t made = at(node);
    const auto old = text_.member(made, "material");
    if (material.empty()) return {old ? text_.without(*old) : text_.text(), std::string(node)};
    return {text_.withMember(made, "material", quoted(material)), std::string(node)};
}

EditedScene SceneEdit::hidden(std::string_view node, bool hide) const
{
    const std::uint32_t shown = at(node);
    const auto old = text_.member(shown, "hidden");
    if (hide) return {text_.withMember(shown, "hidden", "true"), std::string(node)};
    return {old ? text_.without(*old) : text_.text(), std::string(node)};
}

std::string SceneEdit::withHidden(const std::vector<std::pair<std::uint32_t, bool>>& changes) const
{
    // Each change replaces one range of the text. Changes are applied from the last range to the first, so that none
    // moves the range of another.
    struct Place {
        std::size_t begin, length;
        std::string with;
    };
    std::vector<Place> places;
    const std::string& old = text_.text();
    for (const auto& [node, hide] : changes) {
        const auto member = text_.member(node, "hidden");
        if (!hide && !member) continue;
        const std::string text = hide ? text_.withMember(node, "hidden", "true") : text_.without(*member);
        const auto [one, other] = std::mismatch(old.begin(), old.end(), text.begin(), text.end());
        const auto begin = static_cast<std::size_t>(one - old.begin());
        const std::size_t longest = std::min(old.size(), text.size()) - begin;
        std::size_t same = 0;
        while (same < longest && old[old.size() - 1 - same] == text[text.size() - 1 - same]) ++same;
        places.push_back({begin, old.size() - same - begin, text.substr(begin, text.size() - same - begin)});
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.begin > b.begin; });
    std::string text = old;
    for (const Place& place : places) text.replace(place.begin, place.length, place.with);
    return text;
}

EditedScene SceneEdit::solo(std::string_view node) const
{
    std::uint32_t way = at(node);
    std::vector<std::pair<std::uint32_t, bool>> changes{{way, false}};
    while (const auto operation = operationOf(way)) {
        for (const std::uint32_t child : childrenOf(*operation))
            if (child != way) changes.emplace_back(child, true);
        way = *operation;
        changes.emplace_back(way, false);
    }
    return {withHidden(changes), std::string(node)};
}

EditedScene SceneEdit::allShown() const
{
    std::vector<std::pair<std::uint32_t, bool>> changes;
    for (const std::uint32_t node : nodes()) changes.emplace_back(node, false);
    return {withHidden(changes), "root"};
}

EditedScene SceneEdit::ofKind(std::string_view node, const NodeKind& kind) const
{
    const std::uint32_t changed = at(node);
    const NodeKind& old = kindOf(changed);
    const std::vector<std::uint32_t> children = childrenOf(changed);
    if (old.form == Form::shape && kind.form != Form::shape)
        refuse("A shape cannot become an operation; wrap it in a " + std::string(kind.name) + " instead.");
    if (old.form != Form::shape && kind.form == Form::shape)
        refuse("A shape holds no other node; delete the operation, or take it away from around its child.");
    if (kind.form == Form::pair && children.size() != 2)
        refuse("A " + std::string(kind.name) + " takes two children; this one has " + std::to_string(children.size()) +
               ".");
    if (takesOne(kind) && children.size() != 1)
        refuse("A " + std::string(kind.name) + " takes one child; wrap the children in a union first.");
    std::string text = text_.withValue(*text_.member(changed, "kind"), quoted(std::string(kind.name)));
    for (const Field& field : old.fields) {
        const auto value = text_.member(changed, field.name);
        const std::size_t number = kind.numberOf(field.name);
        if (!value) continue;
        const auto same = std::find_if(kind.fields.begin(), kind.fields.end(),
                                       [&](const Field& other) { return other.name == field.name; });
        if (number < kind.numbers() && same != kind.fields.end() && same->type == field.type &&
            same->unit == field.unit && fits(text_, *value, *same))
            continue;
        const JsonText now(text, "scene");
        text = now.without(now.member(*now.at(node), field.name).value());
    }
    if (takesOne(kind) != takesOne(old) && !children.empty()) {
        const JsonText now(text, "scene");
        const char* from = takesOne(old) ? "child" : "children";
        const std::uint32_t member = now.member(*now.at(node), from).value();
        const std::string one(text_.written(children[0]));
        const JsonText renamed(now.withKey(member, takesOne(kind) ? "child" : "children"), "scene");
        text = renamed.withValue(renamed.member(*renamed.at(node), takesOne(kind) ? "child" : "children").value(),
                                 takesOne(kind) ? one : "[" + one + "]");
    }
    return {text, std::string(node)};
}

EditedScene SceneEdit::withNumbers(std::string_view node, const Field& field, const std::vector<double>& numbers) const
{
    if (numbers.size() != numbersOf(field.type))
        refuse("\"" + std::string(field.name) + "\" has " + std::to_string(numbersOf(field.type)) + " numbers.");
    return {text_.withMember(at(node), field.name, numbersText(field, numbers)), std::string(node)};
}

EditedScene SceneEdit::withNumber(std::string_view node, const Field& field, std::size_t component, double x) const
{
    const std::uint32_t changed = at(node);
    const auto old = text_.member(changed, field.name);
    const std::string number = numberText(field, x);
    if (numbersOf(field.type) == 1) return {text_.withMember(changed, field.name, number), std::string(node)};
    const bool isList = old && text_.value(*old).type == JsonType::array;
    if (isList) return {text_.withValue(text_.children(*old).at(component), number), std::string(node)};
    // The field has one number for all, or none yet.
    std::vector<std::string> all;
    for (const double initial : field.initial)
        all.push_back(old ? std::string(text_.written(*old)) : numberText(field, initial));
    all.at(component) = number;
    return {text_.withMember(changed, field.name, threeText(all)), std::string(node)};
}

}  // namespace vitrine::scenes
