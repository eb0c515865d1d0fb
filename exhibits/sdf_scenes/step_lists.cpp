#include "exhibits/sdf_scenes/step_lists.h"

#include <algorithm>

namespace vitrine::scenes {
namespace {

bool isSpace(const NodeKind& kind)
{
    return kind.form == Form::modifier || kind.form == Form::repeater;
}

/// Returns the choice of a kind that combines; 0 if it has none.
int choiceOf(const SceneProgram& program, const ProgramNode& node)
{
    const Node& of = program.scene().nodes[node.node];
    const std::vector<Field>& fields = of.kind->fields;
    if (fields.empty() || fields.front().type != FieldType::choice) return 0;
    return static_cast<int>(program.scene().numbers[of.numbers].value);
}

std::size_t numbersWithRange(const NodeKind& kind)
{
    return kind.numbers() + (kind.form == Form::repeater ? numbersOfRepeatRange : 0);
}

/// Appends numbers as vec4, with zeros at the end.
void appendPadded(std::vector<glm::vec4>& records, std::vector<double> numbers)
{
    numbers.resize((numbers.size() + 3) / 4 * 4, 0);
    for (std::size_t i = 0; i < numbers.size(); i += 4)
        records.push_back(glm::vec4(glm::dvec4(numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3])));
}

template <typename T> void addOnce(std::vector<T>& all, const T& one)
{
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

template <typename T> std::uint32_t indexOf(const std::vector<T>& all, const T& one)
{
    return static_cast<std::uint32_t>(std::find(all.begin(), all.end(), one) - all.begin());
}

}  // namespace

bool isFolded(const SceneProgram& program, const SceneConstants& words, std::uint32_t index)
{
    const ProgramNode& node = program.nodes()[index];
    const NodeKind& kind = program.kind(node);
    if (kind.form != Form::repeater || node.children != 1 || words.asked[index] != 1) return false;
    if (words.words[node.numbers + kind.numbers() + 6] > 0) return false;  // Its distance has a cap.
    const ProgramNode& child = program.nodes()[node.firstChild];
    return program.kind(child).form == Form::shape && child.translate == noIndex && child.rotate == noIndex &&
           child.scale == noIndex;
}

std::uint32_t foldedRecords(const NodeKind& kind)
{
    return static_cast<std::uint32_t>((numbersWithRange(kind) + 3) / 4);
}

ListVocabulary ListVocabulary::of(const SceneProgram& program, const SceneConstants& words)
{
    ListVocabulary own;
    for (std::uint32_t i = 0; i < program.nodes().size(); ++i) {
        const ProgramNode& node = program.nodes()[i];
        const NodeKind& kind = program.kind(node);
        if (kind.form == Form::shape) addOnce(own.shapes, &kind);
        if (isSpace(kind)) addOnce(isFolded(program, words, i) ? own.folds : own.spaces, &kind);
        if (kind.combine && node.children > 1) addOnce(own.joints, {&kind, choiceOf(program, node)});
    }
    // Sorted as in the table, so that other trees of the same kinds give the same text.
    std::sort(own.shapes.begin(), own.shapes.end());
    std::sort(own.spaces.begin(), own.spaces.end());
    std::sort(own.folds.begin(), own.folds.end());
    std::sort(own.joints.begin(), own.joints.end(),
              [](const Joint& a, const Joint& b) { return a.kind != b.kind ? a.kind < b.kind : a.choice < b.choice; });
    if (program.nodes().empty()) return own;
    ListWriter writer(program, words, own, nullptr);
    (void)writer.write(program.steps());
    own.results = writer.results();
    own.places = writer.places();
    return own;
}

std::uint32_t ListVocabulary::foldOf(const SceneProgram& program, const SceneConstants& words, std::uint32_t node) const
{
    const std::uint32_t k = indexOf(folds, &program.kind(program.nodes()[node]));
    return k < folds.size() && isFolded(program, words, node) ? k + 1 : 0;
}

ListRecords::ListRecords(const SceneProgram& program, const SceneConstants& words, const ListVocabulary* vocabulary)
    : program_(program), words_(words), vocabulary_(vocabulary), nodes_(program.nodes().size()),
      materials_(program.scene().materials.size(), noIndex), ways_(program.nodes().size())
{
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) addNode(i);
    for (std::uint32_t m = 0; m < materials_.size(); ++m) {
        if (program.materialWord(m) == noIndex) continue;
        materials_[m] = static_cast<std::uint32_t>(records_.size());
        const double* w = words.words.data() + program.materialWord(m);
        for (std::size_t i = 0; i < wordsOfMaterial; i += 4)
            records_.push_back(glm::vec4(glm::dvec4(w[i], w[i + 1], w[i + 2], w[i + 3])));
    }
    records_.resize(records_.size() + 4, glm::vec4(0));  // Padding: a step may read numbers that it does not use.
}

void ListRecords::addNode(std::uint32_t index)
{
    const ProgramNode& node = program_.nodes()[index];
    const NodeKind& kind = program_.kind(node);
    const double* w = words_.words.data();
    Way way;
    const bool folded = node.parent != noIndex && vocabulary_ && vocabulary_->foldOf(program_, words_, node.parent) > 0;
    if (node.parent != noIndex && (folded || !isSpace(program_.kind(program_.nodes()[node.parent]))))
        way = ways_[node.parent];
    if (node.translate != noIndex)
        way.shift -= glm::dvec3(w[node.translate], w[node.translate + 1], w[node.translate + 2]);
    if (node.rotate != noIndex) {
        const double* r = w + node.rotate;
        const glm::dmat3 axes = glm::transpose(glm::dmat3(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]));
        way.turn = axes * way.turn;
        way.shift = axes * way.shift;
    }
    if (node.scale != noIndex) {
        const glm::dvec3 factor(w[node.scale], w[node.scale + 1], w[node.scale + 2]);
        const glm::dmat3 scale(factor.x, 0, 0, 0, factor.y, 0, 0, 0, factor.z);
        way.turn = scale * way.turn;
        way.shift = scale * way.shift;
        way.scale *= w[node.scale + 3];
    }
    ways_[index] = way;
    if (folded) {
        const ProgramNode& fold = program_.nodes()[node.parent];
        const double* of = w + fold.numbers;
        appendPadded(records_, {of, of + numbersWithRange(program_.kind(fold))});
    }
    nodes_[index] = static_cast<std::uint32_t>(records_.size());
    for (int row = 0; row < 3; ++row)
        records_.push_back(glm::vec4(glm::dvec4(way.turn[0][row], way.turn[1][row], way.turn[2][row], way.shift[row])));
    std::vector<double> numbers{way.scale};
    numbers.insert(numbers.end(), w + node.numbers, w + node.numbers + numbersWithRange(kind));
    // Operations that change no space are evaluated in the surrounding space, so their lengths are scaled.
    if (kind.combine) {
        std::size_t at = 1;
        for (const Field& field : kind.fields) {
            if (field.unit == Unit::meter) numbers[at] *= way.scale;
            at += numbersOf(field.type);
        }
    }
    appendPadded(records_, std::move(numbers));
}

ListWriter::ListWriter(const SceneProgram& program, const SceneConstants& words, const ListVocabulary& vocabulary,
                       const ListRecords* records)
    : program_(program), words_(words), vocabulary_(vocabulary), records_(records), children_(program.nodes().size()),
      opened_(program.nodes().size()), began_(program.nodes().size())
{
}

std::uint32_t ListWriter::spaceOf(const NodeKind& kind) const
{
    return static_cast<std::uint32_t>(vocabulary_.shapes.size()) + static_cast<std::uint32_t>(ListOp::enter) +
           3 * indexOf(vocabulary_.spaces, &kind);
}

std::uint32_t ListWriter::jointOf(const ProgramNode& node) const
{
    return 2 + indexOf(vocabulary_.joints, {&program_.kind(node), choiceOf(program_, node)});
}

void ListWriter::addShape(std::uint32_t index, std::uint32_t fold)
{
    const ProgramNode& node = program_.nodes()[index];
    add(indexOf(vocabulary_.shapes, &program_.kind(node)) | fold << 16U, index,
        records_ ? records_->ofMaterial(node.material) : 0);
    waiting_ = static_cast<std::uint32_t>(list_.size() - 1);
}

void ListWriter::add(std::uint32_t operation, std::uint32_t node, std::uint32_t further)
{
    list_.push_back({operation, records_ ? records_->ofNode(node) : 0, 0, further});
}

/// Joins the pending result to the open level.
void ListWriter::join(std::uint32_t how, std::uint32_t parent)
{
    if (waiting_ == noIndex) return;
    list_[waiting_].operation |= how << 8U;
    list_[waiting_].joint = records_ ? records_->ofNode(parent) : 0;
    waiting_ = noIndex;
    fresh_.back() = 0;
}

void ListWriter::begin(const Step& step)
{
    const ProgramNode& node = program_.nodes()[step.node];
    const NodeKind& kind = program_.kind(node);
    if (kind.form == Form::shape) return;
    const auto shapes = static_cast<std::uint32_t>(vocabulary_.shapes.size());
    opened_[step.node] = isSpace(kind) || (fresh_.back() == 0 && children_[step.node] > 1);
    if (opened_[step.node] == 0) return;
    if (isSpace(kind)) {
        add(spaceOf(kind), step.node);
        places_ = std::max(places_, ++inside_);
    } else {
        add(shapes + static_cast<std::uint32_t>(ListOp::open), step.node);
    }
    began_[step.node] = static_cast<std::uint32_t>(list_.size());
    results_ = std::max(results_, ++depth_);
    fresh_.push_back(1);
}

void ListWriter::end(const Step& step)
{
    const NodeKind& kind = program_.kind(program_.nodes()[step.node]);
    if (kind.form == Form::shape || opened_[step.node] == 0) return;
    const auto shapes = static_cast<std::uint32_t>(vocabulary_.shapes.size());
    add(shapes + static_cast<std::uint32_t>(isSpace(kind) ? ListOp::leave : ListOp::close), step.node);
    waiting_ = static_cast<std::uint32_t>(list_.size() - 1);
    --depth_;
    inside_ -= isSpace(kind) ? 1 : 0;
    fresh_.pop_back();
}

std::vector<ListStep> ListWriter::write(std::span<const Step> steps)
{
    list_.clear();
    fresh_.assign(1, 1);
    waiting_ = noIndex;
    depth_ = inside_ = results_ = places_ = 0;
    for (const Step& step : steps) {
        if (step.type == Step::Type::enter) children_[step.node] = 0;
        if (step.type == Step::Type::first || step.type == Step::Type::combine) ++children_[step.node];
    }
    std::uint32_t folded = noIndex;  // Repeater whose steps are skipped.
    for (const Step& step : steps) {
        const ProgramNode& node = program_.nodes()[step.node];
        if (folded != noIndex) {
            if (step.type == Step::Type::leave && step.node == folded) folded = noIndex;
            continue;
        }
        switch (step.type) {
        case Step::Type::enter:
            if (const std::uint32_t fold = vocabulary_.foldOf(program_, words_, step.node)) {
                addShape(node.firstChild, fold);
                folded = step.node;
            } else {
                begin(step);
            }
            break;
        case Step::Type::shape: addShape(step.node, 0); break;
        case Step::Type::first:
            // Opens a level of its own, or else continues the surrounding operation.
            if (fresh_.back() != 0 && (opened_[step.node] != 0 || children_[step.node] > 1)) join(1, step.node);
            break;
        case Step::Type::combine: join(jointOf(node), step.node); break;
        case Step::Type::modify:
            join(1, step.node);
            if (program_.kind(node).after) add(spaceOf(program_.kind(node)) + 1, step.node);
            break;
        case Step::Type::again:
            join(1, step.node);
            add(spaceOf(program_.kind(node)) + 2, step.node, began_[step.node]);
            break;
        case Step::Type::leave: end(step); break;
        }
    }
    join(1, 0);
    for (std::size_t i = 0; i + 1 < list_.size(); ++i) list_[i].operation |= moreSteps;
    return list_;
}

}  // namespace vitrine::scenes
