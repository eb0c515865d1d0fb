#include "exhibits/sdf_scenes/asked_scene.h"

#include "exhibits/sdf_scenes/list_glsl.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>

namespace vitrine::scenes {
namespace {

const FurtherMember stageMember{"sdf_scenes/stage_block.glsl", "SceneStage stage"};

/// From so many shapes on, asking those that are near is faster than asking all: bench_scene_speed. Of the shipped
/// scenes, those of 9 to 12 shapes are up to five times slower by lists, those of 17 a third faster.
constexpr std::size_t manyShapes = 16;

/// The shader's text has all steps in it, and the numbers are hashed once.
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

/// Null while it is pending.
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

AskedScene askedScene(const ShownScene& shown, const SceneWords& words, SceneEvaluation way, render::AssetStore& assets)
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
    const char* const noEnd = noCells ? "the scene has no end, so no cells hold it" : "";
    if (noCells && automatic && !isInBuffer(*shown.program)) return everyShape(shown, words, noEnd);
    AskedScene asked = *made;
    asked.why = noEnd;
    return asked;
}

}  // namespace vitrine::scenes
