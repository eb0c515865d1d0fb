#include "exhibits/sdf_scenes/steady_words.h"

#include <algorithm>

namespace vitrine::scenes {
namespace {

/// Returns whether any of some numbers of a scene depends on the time.
bool moves(const Scene& scene, std::uint32_t first, std::size_t count)
{
    return std::any_of(scene.numbers.begin() + first,
                       scene.numbers.begin() + first + static_cast<std::ptrdiff_t>(count), [&](const Number& number) {
                           return number.expression != none && scene.expressions[number.expression].usesTime;
                       });
}

}  // namespace

std::vector<char> steadyWords(const SceneProgram& program)
{
    const Scene& scene = program.scene();
    std::vector<char> steady(program.wordCount(), 1);
    bool anyNodeMoves = false;
    const auto mark = [&](std::uint32_t number, std::size_t numbers, std::uint32_t word, std::size_t words) {
        if (word == none || !moves(scene, number, numbers)) return false;
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
        anyNodeMoves |= node.translate != none && mark(of.translate, 3, node.translate, 3);
        anyNodeMoves |= node.rotate != none && mark(of.rotate, 3, node.rotate, 9);
        anyNodeMoves |= node.scale != none && mark(of.scale, 3, node.scale, 4);
    }
    // The copies that a repeater evaluates depend on its content.
    for (const ProgramNode& node : program.nodes())
        if (anyNodeMoves && program.kind(node).form == Form::repeater)
            std::fill_n(steady.begin() + node.numbers + static_cast<std::ptrdiff_t>(program.kind(node).numbers()),
                        numbersOfAsked, char{0});
    return steady;
}

}  // namespace vitrine::scenes
