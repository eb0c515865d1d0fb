#include "exhibits/sdf_scenes/asked_scene.h"

#include "exhibits/sdf_scenes/list_glsl.h"
#include "exhibits/sdf_scenes/steady_words.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>

namespace vitrine::scenes {
namespace {

const FurtherMember stageMember{"sdf_scenes/stage_block.glsl", "SceneStage stage"};

/// Number of shapes from which the grid is faster than evaluating all of them. Measured with the shipped scenes: those
/// of 9 to 12 shapes are up to five times slower with the grid, those of 17 a third faster.
constexpr std::size_t manyShapes = 16;

/// Largest number of shapes for which a program specialized for the scene, with its numbers folded in, builds in
/// seconds and is faster.
constexpr std::size_t mostFolded = 64;

/// Returns a cache key. The hash of the shader text covers all steps; the numbers are hashed separately.
std::string keyOf(const ShownScene& shown, const SceneWords& words, const char* way)
{
    return std::string(way) + ' ' + std::to_string(shown.sources->hash()) + ' ' +
           std::to_string(render::hashOfNumbers(words.words));
}

std::size_t shapesOf(const SceneProgram& program)
{
    return static_cast<std::size_t>(std::count_if(program.nodes().begin(), program.nodes().end(),
                                                  [](const ProgramNode& node) { return node.firstChild == none; }));
}

AskedScene everyShape(const ShownScene& shown, const SceneWords& words, const char* why = "")
{
    AskedScene asked{.sources = shown.sources, .why = why};
    asked.numbersInBlock = !isInBuffer(*shown.program);
    if (!asked.numbersInBlock)
        asked.buffers = {{STORAGE_EXHIBIT_A, std::make_shared<const render::Bytes>(sceneBlock(words))}};
    return asked;
}

/// Returns null while it is being made.
std::shared_ptr<const AskedScene> byLists(const ShownScene& shown, const SceneWords& words, SceneEvaluation way,
                                          render::AssetStore& assets)
{
    const bool cells = way == SceneEvaluation::near;
    const bool anyTree = way == SceneEvaluation::interpreter;
    const char* name = cells ? "cells" : anyTree ? "any tree" : "lists";
    return assets
        .made<AskedScene>(
            "sdf_scenes.near", keyOf(shown, words, name),
            [&] {
                const ListVocabulary own = ListVocabulary::of(*shown.program);
                const ListVocabulary vocabulary =
                    anyTree ? ListVocabulary::everything(ListVocabulary::mostResults, ListVocabulary::mostPlaces) : own;
                auto made = std::make_shared<AskedScene>();
                made->near =
                    nearScene(*shown.program, words, vocabulary, cells ? cellsAcross(shapesOf(*shown.program)) : 0);
                made->sources = generatedSources(listGlsl(vocabulary, made->near->planes, stageMember));
                made->buffers = {{STORAGE_EXHIBIT_A, made->near->records},
                                 {STORAGE_EXHIBIT_B, made->near->lists},
                                 {STORAGE_EXHIBIT_C, made->near->grid}};
                const std::uint64_t bytes = made->near->bytes() + made->near->cells.cells.size() * sizeof(SceneCell);
                return render::AssetStore::Made<AskedScene>{std::move(made), bytes};
            })
        .value;
}

}  // namespace

bool hasLists(const ListVocabulary& vocabulary)
{
    return !vocabulary.shapes.empty() && vocabulary.results <= ListVocabulary::mostResults &&
           vocabulary.places <= ListVocabulary::mostPlaces;
}

namespace {

AskedScene unfolded(const ShownScene& shown, const SceneWords& words, SceneEvaluation way, render::AssetStore& assets)
{
    if (way == SceneEvaluation::shapes) return everyShape(shown, words);
    if (way == SceneEvaluation::folded) {
        const auto folded = assets.made<render::ShaderSources>("sdf_scenes.folded", keyOf(shown, words, "folded"), [&] {
            auto sources = generatedSources(foldedSceneGlsl(*shown.program, words, stageMember));
            return render::AssetStore::Made<render::ShaderSources>{std::move(sources), 16 * words.words.size()};
        });
        return folded.value ? AskedScene{.sources = folded.value} : everyShape(shown, words);
    }
    const bool automatic = way == SceneEvaluation::automatic;
    if (automatic && shapesOf(*shown.program) < manyShapes && !isInBuffer(*shown.program))
        return everyShape(shown, words, "asking every shape of so few is as fast");
    if (!hasLists(ListVocabulary::of(*shown.program)))
        return everyShape(shown, words, "the tree is nested too deep for lists");
    const SceneEvaluation lists = automatic ? SceneEvaluation::near : way;
    const std::shared_ptr<const AskedScene> made = byLists(shown, words, lists, assets);
    if (!made) return everyShape(shown, words, "what is near is still being found");
    const bool noCells = lists == SceneEvaluation::near && made->near->cells.cells.empty();
    const char* const noEnd = !noCells ? ""
                              : made->near->crowded
                                  ? "so many shapes blend into each other that cells would hold them all"
                                  : "the scene has no end, so no cells hold it";
    if (noCells && automatic && !isInBuffer(*shown.program)) return everyShape(shown, words, noEnd);
    AskedScene asked = *made;
    asked.why = noEnd;
    return asked;
}

/// Returns why the scene's numbers are not folded into its program; empty if they are.
std::string whyNotFolded(const ShownScene& shown, const AskedScene& asked, SceneEvaluation way, SceneRest rest)
{
    if (way != SceneEvaluation::automatic) return "numbers are folded by themselves where the evaluation is automatic";
    if (asked.near) return "lists have no numbers in their text";
    if (shapesOf(*shown.program) > mostFolded) return "so many numbers take too long to be built into a program";
    return rest == SceneRest::nothing ? "its numbers have not rested for a while" : "";
}

}  // namespace

AskedScene askedScene(const ShownScene& shown, const SceneWords& words, SceneEvaluation way, SceneRest rest,
                      render::AssetStore& assets)
{
    AskedScene asked = unfolded(shown, words, way, assets);
    asked.whyNotFolded = whyNotFolded(shown, asked, way, rest);
    if (!asked.whyNotFolded.empty()) return asked;
    const std::size_t count = words.words.size();
    const std::vector<char> steady = rest == SceneRest::all ? std::vector<char>(count, 1) : steadyWords(*shown.program);
    SceneWords kept = words;
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
    if (!asked.folded) asked.whyNotFolded = "the text with its numbers is still being written";
    return asked;
}

}  // namespace vitrine::scenes
