#pragma once

#include "exhibits/sdf_scenes/scene_program.h"
#include "render/plan/frame_plan.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace vitrine::scenes {

/// What lists of steps may be made of: the shader that walks them has code for this and nothing else, so scenes of the
/// same vocabulary share a program, whatever their trees are.
struct ListVocabulary {
    /// A way to combine two results: a kind with its choice (a blend's profile), which is part of the text.
    struct Joint {
        const NodeKind* kind;
        int choice;
        bool operator==(const Joint&) const = default;
    };
    std::vector<const NodeKind*> shapes;
    std::vector<const NodeKind*> spaces;  ///< Modifiers and repeaters: what changes the point or the distance.
    std::vector<Joint> joints;
    std::uint32_t results = 0;  ///< Results that wait for others, at most.
    std::uint32_t places = 0;   ///< Spaces inside one another, at most.

    /// More registers than these, and shaders spill them.
    static constexpr std::uint32_t mostResults = 6, mostPlaces = 4;

    /// Of all trees that are nested no deeper.
    [[nodiscard]] static ListVocabulary everything(std::uint32_t results, std::uint32_t places);
    [[nodiscard]] static ListVocabulary of(const SceneProgram&);
};

/// Operations of a list, behind the shapes and before the spaces: `ListVocabulary` numbers both in their order. Each
/// space has three: `enter`, `modify` and `again`, in turn.
enum class ListOp : std::uint32_t { open, close, leave, enter };

/// As shaders read them, 16 bytes.
struct ListStep {
    std::uint32_t operation = 0;  ///< Bits 0-7: the operation; 8-15: 0 keeps the result waiting, 1 makes it the first
                                  ///< one, from 2 on a joint; bit 31: more steps follow.
    std::uint32_t record = 0;     ///< Of the node, in vec4: place in 3, then 1 and its numbers.
    std::uint32_t joint = 0;      ///< Of the node that joins: its numbers.
    std::uint32_t further = 0;    ///< shape: its material, in vec4; again: the step to go on with, from the first one.
};
/// Of pixels that a triangle leaves out, llvmpipe reads 0 from buffers and goes on: 0 has to end the walk.
inline constexpr std::uint32_t moreSteps = 1U << 31U;

/// The numbers of a scene as lists need them: of every node the whole way from the space around it, so that operations
/// that change no space are no steps of their own.
class ListRecords {
public:
    /// Both must outlive it.
    ListRecords(const SceneProgram&, const SceneWords&);

    [[nodiscard]] const std::vector<glm::vec4>& records() const { return records_; }
    [[nodiscard]] std::uint32_t ofNode(std::uint32_t node) const { return nodes_[node]; }
    [[nodiscard]] std::uint32_t ofMaterial(std::uint32_t material) const { return materials_[material]; }
    /// From the space around a node into its own: p' = A p + b, and what a distance there is times this outside.
    struct Way {
        glm::dmat3 turn{1};
        glm::dvec3 shift{0};
        double scale = 1;
    };
    [[nodiscard]] const Way& way(std::uint32_t node) const { return ways_[node]; }

private:
    void addNode(std::uint32_t node);

    const SceneProgram& program_;
    const SceneWords& words_;
    std::vector<glm::vec4> records_;
    std::vector<std::uint32_t> nodes_, materials_;
    std::vector<Way> ways_;
};

/// Writes lists of steps, all or those that were left of them, as shaders walk them.
class ListWriter {
public:
    ListWriter(const SceneProgram&, const ListVocabulary&, const ListRecords*);

    /// Of a whole scene or a part of it; not empty.
    [[nodiscard]] std::vector<ListStep> write(std::span<const Step> steps);
    /// How deep the last list went.
    [[nodiscard]] std::uint32_t results() const { return results_; }
    [[nodiscard]] std::uint32_t places() const { return places_; }

private:
    [[nodiscard]] std::uint32_t spaceOf(const NodeKind&) const;
    [[nodiscard]] std::uint32_t jointOf(const ProgramNode&) const;
    void begin(const Step&);
    void end(const Step&);
    void join(std::uint32_t how, std::uint32_t parent);
    void add(std::uint32_t operation, std::uint32_t node, std::uint32_t further = 0);

    const SceneProgram& program_;
    const ListVocabulary& vocabulary_;
    const ListRecords* records_;
    std::vector<std::uint32_t> children_;  // By node: how many are joined in this list.
    std::vector<char> opened_;             // By node: whether it has a level of its own.
    std::vector<std::uint32_t> began_;     // By node: the step behind its `enter`.
    std::vector<char> fresh_;              // By level: nothing was joined in it yet.
    std::vector<ListStep> list_;
    std::uint32_t waiting_ = none;  // The step whose result is joined next.
    std::uint32_t depth_ = 0, inside_ = 0, results_ = 0, places_ = 0;
};

}  // namespace vitrine::scenes
