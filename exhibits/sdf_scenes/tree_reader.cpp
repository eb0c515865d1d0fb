#include "exhibits/sdf_scenes/tree_reader.h"

#include <algorithm>

namespace vitrine::scenes {
namespace {

using JsonType = render::JsonSpan::Type;

constexpr const char* instanceWord = "instance";
constexpr const char* includeWord = "include";

std::vector<std::string> kindWords()
{
    std::vector<std::string> words;
    for (const NodeKind& kind : nodeKinds()) words.emplace_back(kind.name);
    words.emplace_back(instanceWord);
    words.emplace_back(includeWord);
    return words;
}

/// Returns the keys that a node of a kind may have besides its numbers.
std::vector<std::string_view> keysBeside(const std::string& word, const NodeKind* kind)
{
    std::vector<std::string_view> keys{"kind", "name", "about", "material", "hidden", "translate", "rotate", "scale"};
    if (word == instanceWord)
        keys.emplace_back("of");
    else if (word == includeWord)
        keys.emplace_back("file");
    else if (kind->form == Form::modifier || kind->form == Form::repeater)
        keys.emplace_back("child");
    else if (kind->form != Form::shape)
        keys.emplace_back("children");
    return keys;
}

std::string withArticle(const std::string& word)
{
    return (std::string_view("aeio").find(word.front()) == std::string_view::npos ? "a " : "an ") + word;
}

}  // namespace

void TreeReader::read()
{
    const std::uint32_t root = names_.front().root;
    if (root == noIndex) return;
    work_.push_back({0, root, noIndex, 0, noIndex});
    while (!work_.empty() && !findings_.full()) {
        const Work next = work_.back();
        work_.pop_back();
        if (scene_.nodes.size() >= limits_.nodes) {
            findings_.add(*scene_.files[next.file].text, next.value,
                          "the scene has more than " + std::to_string(limits_.nodes) +
                              " nodes, counting what instances and includes bring; leave some out");
            return;
        }
        readNode(next);
    }
}

const NodeKind* TreeReader::kindOf(const Work& work, std::string& word)
{
    const render::JsonText& json = *scene_.files[work.file].text;
    if (json.value(work.value).type != JsonType::object) {
        findings_.add(json, work.value, "a node must be an object: { \"kind\": \"sphere\" }");
        return nullptr;
    }
    const std::optional<std::uint32_t> value = json.member(work.value, "kind");
    if (!value) {
        findings_.add(json, work.value, "this node has no \"kind\"; say what it is: \"kind\": \"sphere\"");
        return nullptr;
    }
    word = fields_.readString(work.file, *value);
    if (word == instanceWord || word == includeWord) return findKind("union");
    const NodeKind* kind = findKind(word);
    if (!kind && json.value(*value).type == JsonType::string)
        findings_.add(json, *value, unknownWord(word, "kind of node", kindWords()));
    return kind;
}

std::uint32_t TreeReader::addNode(const Work& work, Node node)
{
    const auto index = static_cast<std::uint32_t>(scene_.nodes.size());
    scene_.nodes.push_back(std::move(node));
    lastChild_.push_back(noIndex);
    if (work.parent != noIndex) {
        std::uint32_t& last = lastChild_[work.parent];
        (last == noIndex ? scene_.nodes[work.parent].firstChild : scene_.nodes[last].next) = index;
        last = index;
    }
    return index;
}

void TreeReader::readNode(const Work& work)
{
    std::string word;
    const NodeKind* kind = kindOf(work, word);
    if (!kind) return;
    const render::JsonText& json = *scene_.files[work.file].text;
    const bool expanded = word == instanceWord || word == includeWord;
    const std::size_t before = findings_.count();
    Node node;
    node.kind = kind;
    node.origin = {work.file, work.value};
    node.parent = work.parent;
    node.material = materialOf(work);
    if (expanded) {
        static_cast<void>(fields_.readObject(work.file, work.value, {}, keysBeside(word, kind), withArticle(word)));
        node.numbers = fields_.initialFields(kind->fields);
    } else {
        node.numbers =
            fields_.readObject(work.file, work.value, kind->fields, keysBeside(word, kind), withArticle(word));
    }
    readPlace(work, node);
    if (const auto name = json.member(work.value, "name")) node.name = fields_.readString(work.file, *name);
    if (const auto about = json.member(work.value, "about")) static_cast<void>(fields_.readString(work.file, *about));
    if (const auto hidden = json.member(work.value, "hidden")) {
        node.hidden = json.boolean(*hidden);
        if (json.value(*hidden).type != JsonType::boolean) findings_.add(json, *hidden, "this must be true or false");
    }
    const std::uint32_t material = node.material;
    checkNumbers(work, node, before);
    const std::uint32_t index = addNode(work, std::move(node));
    if (expanded)
        expand(work, index, material, word == instanceWord);
    else
        readChildren(work, index, material);
}

void TreeReader::readPlace(const Work& work, Node& node)
{
    const std::vector<Field>& fields = placeFields();
    std::uint32_t* const at[] = {&node.translate, &node.rotate, &node.scale};
    for (std::size_t i = 0; i < fields.size(); ++i)
        if (const auto value = scene_.files[work.file].text->member(work.value, fields[i].name))
            *at[i] = fields_.readField(work.file, *value, fields[i]);
}

std::uint32_t TreeReader::materialOf(const Work& work)
{
    const render::JsonText& json = *scene_.files[work.file].text;
    const std::optional<std::uint32_t> value = json.member(work.value, "material");
    if (!value) return work.material;
    const std::string name = fields_.readString(work.file, *value);
    const std::map<std::string, std::uint32_t>& known = names_[work.file].materials;
    if (const auto found = known.find(name); found != known.end()) return found->second;
    std::vector<std::string> words;
    for (const auto& [word, index] : known) words.push_back(word);
    if (json.value(*value).type == JsonType::string) findings_.add(json, *value, unknownWord(name, "material", words));
    return work.material;
}

void TreeReader::checkNumbers(const Work& work, const Node& node, std::size_t findingsBefore)
{
    if (!node.kind->fault || findings_.count() != findingsBefore) return;
    std::vector<double> v(node.kind->numbers());
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = scene_.numbers[node.numbers + i].value;
    normalizeDirections(node.kind->fields, v.data());
    const std::string fault = node.kind->fault(v.data());
    if (!fault.empty()) findings_.add(*scene_.files[work.file].text, work.value, fault);
}

void TreeReader::readChildren(const Work& work, std::uint32_t node, std::uint32_t material)
{
    const render::JsonText& json = *scene_.files[work.file].text;
    const Form form = scene_.nodes[node].kind->form;
    const std::string word(scene_.nodes[node].kind->name);
    if (form == Form::shape) return;
    if (form == Form::modifier || form == Form::repeater) {
        if (const auto child = json.member(work.value, "child"))
            work_.push_back({work.file, *child, node, material, work.chain});
        else
            findings_.add(json, work.value, withArticle(word) + " needs a \"child\": the node that it changes");
        return;
    }
    const auto list = json.member(work.value, "children");
    const bool isList = list && json.value(*list).type == JsonType::array;
    const std::vector<std::uint32_t> children = isList ? json.children(*list) : std::vector<std::uint32_t>();
    const std::uint32_t about = list ? *list : work.value;
    if (children.empty() || (form == Form::pair && children.size() != 2)) {
        findings_.add(json, about,
                      withArticle(word) + (form == Form::pair ? " needs two" : " needs") +
                          " \"children\": an array of the nodes that it combines");
        return;
    }
    for (std::size_t i = children.size(); i-- > 0;)
        work_.push_back({work.file, children[i], node, material, work.chain});
}

void TreeReader::expand(const Work& work, std::uint32_t node, std::uint32_t material, bool instance)
{
    const render::JsonText& json = *scene_.files[work.file].text;
    const char* key = instance ? "of" : "file";
    const std::optional<std::uint32_t> value = json.member(work.value, key);
    if (!value) {
        findings_.add(json, work.value, std::string("this node has no \"") + key + "\"; name what takes its place");
        return;
    }
    const std::string name = fields_.readString(work.file, *value);
    if (json.value(*value).type != JsonType::string) return;
    std::uint32_t file = work.file;
    std::uint32_t target = noIndex;
    if (instance) {
        const std::map<std::string, std::uint32_t>& known = names_[work.file].definitions;
        if (const auto found = known.find(name); found != known.end()) {
            target = found->second;
        } else {
            std::vector<std::string> words;
            for (const auto& [word, index] : known) words.push_back(word);
            findings_.add(json, *value, unknownWord(name, "node under \"nodes\"", words));
        }
    } else if (const std::optional<std::uint32_t> included = include_(work.file, *value, name)) {
        file = *included;
        target = names_[file].root;
        material = 0;
    }
    if (target == noIndex) return;
    for (std::uint32_t c = work.chain; c != noIndex; c = chains_[c].outer)
        if (chains_[c].file == file && chains_[c].value == target) {
            findings_.add(json, *value, "\"" + name + "\" contains itself by way of this; take one of the two out");
            return;
        }
    const std::uint32_t depth = work.chain == noIndex ? 1 : chains_[work.chain].depth + 1;
    if (depth > limits_.expansions) {
        findings_.add(json, *value,
                      "instances and includes are more than " + std::to_string(limits_.expansions) +
                          " deep in one another; write some of them out");
        return;
    }
    chains_.push_back({file, target, work.chain, depth});
    work_.push_back({file, target, node, material, static_cast<std::uint32_t>(chains_.size() - 1)});
}

}  // namespace vitrine::scenes
