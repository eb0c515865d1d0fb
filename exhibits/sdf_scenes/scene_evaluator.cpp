#include "exhibits/sdf_scenes/scene_evaluator.h"

#include "exhibits/sdf_scenes/list_glsl.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <mutex>

namespace vitrine::scenes {
namespace {

const FurtherMember stageMember{"sdf_scenes/stage_block.glsl", "SceneStage stage"};

/// Number of shapes from which the grid is faster than evaluating all of them. Measured with the shipped scenes: those
/// of 8 to 11 shapes take up to three times as long with the grid, those of 17 are faster.
constexpr std::size_t manyShapes = 16;

/// Largest number of shapes for which a program specialized for the scene, with its numbers folded in, builds in
/// seconds and is faster.
constexpr std::size_t mostFolded = 64;

/// Returns a cache key. The hash of the shader text covers all steps; the numbers are hashed separately.
std::string keyOf(const ShownScene& shown, const SceneConstants& words, const char* way)
{
    return std::string(way) + ' ' + std::to_string(shown.sources->hash()) + ' ' +
           std::to_string(render::hashOfNumbers(words.words));
}

std::size_t shapesOf(const SceneProgram& program)
{
    return static_cast<std::size_t>(std::count_if(program.nodes().begin(), program.nodes().end(),
                                                  [](const ProgramNode& node) { return node.firstChild == noIndex; }));
}

SceneEvaluator everyShape(const ShownScene& shown, const SceneConstants& words, const char* why = "")
{
    SceneEvaluator asked{.sources = shown.sources, .why = why};
    asked.numbersInBlock = !isInBuffer(*shown.program);
    if (!asked.numbersInBlock)
        asked.buffers = {{STORAGE_EXHIBIT_A, std::make_shared<const render::Bytes>(sceneBlock(words))}};
    return asked;
}

/// Grid that was made last, if it still exists: after a change of few numbers, the next one is made from it.
class LastGrid {
public:
    /// Returns the grid if it is of a program with this text; else null.
    [[nodiscard]] std::shared_ptr<const SceneGrid> of(std::uint64_t program)
    {
        const std::lock_guard lock(mutex_);
        return program == program_ ? grid_.lock() : nullptr;
    }
    void set(std::uint64_t program, const std::shared_ptr<const SceneGrid>& grid)
    {
        const std::lock_guard lock(mutex_);
        program_ = program;
        grid_ = grid;
    }

private:
    std::mutex mutex_;
    std::uint64_t program_ = 0;
    std::weak_ptr<const SceneGrid> grid_;
};

}  // namespace

std::vector<render::BufferUse> buffersOf(const SceneGrid& grid)
{
    return {{.binding = UNIT_BUFFER_A, .source = grid.records, .texels = render::Texels::vec4},
            {.binding = UNIT_BUFFER_B, .source = grid.lists, .texels = render::Texels::uvec4},
            {.binding = UNIT_BUFFER_C, .source = grid.grid, .texels = render::Texels::uvec4}};
}

namespace {

/// Returns the evaluator that uses lists of nearby shapes, or null while it is being made.
std::shared_ptr<const SceneEvaluator> byLists(const ShownScene& shown, const SceneConstants& words,
                                              render::AssetStore& assets)
{
    return assets
        .made<SceneEvaluator>(
            "sdf_scenes.near", keyOf(shown, words, "cells"),
            [&] {
                const ListVocabulary vocabulary = ListVocabulary::of(*shown.program, words);
                auto made = std::make_shared<SceneEvaluator>();
                static LastGrid last;
                const std::uint64_t text = shown.sources->hash();
                made->near = sceneGrid(*shown.program, words, vocabulary, cellsAcross(shapesOf(*shown.program)),
                                       cellBudget, last.of(text).get());
                last.set(text, made->near);
                made->sources = generatedSources(listGlsl(vocabulary, made->near->planes, stageMember));
                made->buffers = buffersOf(*made->near);
                const std::uint64_t bytes = made->near->bytes() + made->near->cells.cells.size() * sizeof(SceneCell);
                return render::AssetStore::Made<SceneEvaluator>{std::move(made), bytes};
            })
        .value;
}

/// Returns whether step lists can evaluate the scene: very deeply nested trees need more levels than a shader has
/// registers.
bool hasLists(const ListVocabulary& vocabulary)
{
    return !vocabulary.shapes.empty() && vocabulary.results <= ListVocabulary::mostResults &&
           vocabulary.places <= ListVocabulary::mostPlaces;
}

SceneEvaluator unfolded(const ShownScene& shown, const SceneConstants& words, SceneEvaluation way,
                        render::AssetStore& assets)
{
    if (way == SceneEvaluation::shapes) return everyShape(shown, words);
    const bool automatic = way == SceneEvaluation::automatic;
    if (automatic && shapesOf(*shown.program) < manyShapes && !isInBuffer(*shown.program))
        return everyShape(shown, words, "with so few shapes, evaluating all of them is as fast");
    if (!hasLists(ListVocabulary::of(*shown.program, words)))
        return everyShape(shown, words, "the tree is nested too deep for lists");
    const std::shared_ptr<const SceneEvaluator> made = byLists(shown, words, assets);
    if (!made) return everyShape(shown, words, "the lists of near shapes are still being computed");
    const bool noCells = !made->near->hasCells();
    const char* const noEnd = !noCells ? ""
                              : made->near->crowded
                                  ? "so many shapes blend into each other that every cell would list all of them"
                                  : "the scene is infinite, so no grid of cells can cover it";
    if (noCells && automatic && !isInBuffer(*shown.program)) return everyShape(shown, words, noEnd);
    SceneEvaluator asked = *made;
    asked.why = noEnd;
    return asked;
}

/// Returns whether any of some numbers of a scene depends on the time.
bool moves(const Scene& scene, std::uint32_t first, std::size_t count)
{
    return std::any_of(scene.numbers.begin() + first,
                       scene.numbers.begin() + first + static_cast<std::ptrdiff_t>(count), [&](const Number& number) {
                           return number.expression != noIndex && scene.expressions[number.expression].usesTime;
                       });
}

/// Returns for each number of a program whether it is time-invariant.
std::vector<char> timeInvariantConstants(const SceneProgram& program)
{
    const Scene& scene = program.scene();
    std::vector<char> steady(program.wordCount(), 1);
    bool anyNodeMoves = false;
    const auto mark = [&](std::uint32_t number, std::size_t numbers, std::uint32_t word, std::size_t words) {
        if (word == noIndex || !moves(scene, number, numbers)) return false;
        std::fill_n(steady.begin() + word, words, char{0});
        return true;
    };
    for (std::uint32_t m = 0; m < scene.materials.size(); ++m) {
        std::size_t numbers = 0;
        for (const Field& field : scene.materials[m].kind->fields) numbers += numbersOf(field.type);
        mark(scene.materials[m].numbers, numbers, program.materialWord(m), wordsOfMaterial);
    }
    for (const ProgramNode& node : program.nodes()) {
        const Node& of = scene.nodes[node.node];
        // The three numbers of a direction depend on each other, and a rotation matrix on all its angles.
        anyNodeMoves |= mark(of.numbers, of.kind->numbers(), node.numbers, of.kind->numbers());
        anyNodeMoves |= node.translate != noIndex && mark(of.translate, 3, node.translate, 3);
        anyNodeMoves |= node.rotate != noIndex && mark(of.rotate, 3, node.rotate, 9);
        anyNodeMoves |= node.scale != noIndex && mark(of.scale, 3, node.scale, 4);
    }
    // The copies that a repeater evaluates depend on its content.
    for (const ProgramNode& node : program.nodes())
        if (anyNodeMoves && program.kind(node).form == Form::repeater)
            std::fill_n(steady.begin() + node.numbers + static_cast<std::ptrdiff_t>(program.kind(node).numbers()),
                        numbersOfRepeatRange, char{0});
    return steady;
}

/// Returns why the scene's numbers are not folded into its program; empty if they are.
std::string whyNotFolded(const ShownScene& shown, const SceneEvaluator& asked, SceneEvaluation way, SceneRest rest)
{
    if (way != SceneEvaluation::automatic) return "numbers are compiled in only if the evaluation is automatic";
    if (asked.near) return "the shader text of lists contains no numbers";
    if (shapesOf(*shown.program) > mostFolded)
        return "so many constants would take too long to compile into the shader";
    return rest == SceneRest::nothing ? "its numbers changed a short time ago" : "";
}

}  // namespace

SceneEvaluator sceneEvaluator(const ShownScene& shown, const SceneConstants& words, SceneEvaluation way, SceneRest rest,
                              render::AssetStore& assets)
{
    SceneEvaluator asked = unfolded(shown, words, way, assets);
    asked.whyNotFolded = whyNotFolded(shown, asked, way, rest);
    if (!asked.whyNotFolded.empty()) return asked;
    const std::size_t count = words.words.size();
    const std::vector<char> steady =
        rest == SceneRest::all ? std::vector<char>(count, 1) : timeInvariantConstants(*shown.program);
    SceneConstants kept = words;
    for (std::size_t i = 0; i < count; ++i)
        if (steady[i] == 0) kept.words[i] = 0;
    asked.folded = assets
                       .made<render::ShaderSources>(
                           "sdf_scenes.resting", keyOf(shown, kept, rest == SceneRest::all ? "all" : "steady"),
                           [&] {
                               auto sources =
                                   generatedSources(restingSceneGlsl(*shown.program, kept, steady, stageMember));
                               return render::AssetStore::Made<render::ShaderSources>{std::move(sources), 16 * count};
                           })
                       .value;
    if (!asked.folded) asked.whyNotFolded = "the shader with constant numbers is still being generated";
    return asked;
}

}  // namespace vitrine::scenes
