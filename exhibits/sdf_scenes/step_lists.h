#pragma once

#include "exhibits/sdf_scenes/scene_program.h"
#include "render/plan/frame_plan.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace vitrine::scenes {

/// Vocabulary of step lists: the shader that evaluates them has code for these items only. So scenes of the same
/// vocabulary share a program, whatever their trees are.
struct ListVocabulary {
    /// A way to combine two results: a kind with its choice (a blend's profile), which is part of the shader's text.
    struct Joint {
        const NodeKind* kind;
        int choice;
        bool operator==(const Joint&) const = default;
    };
    std::vector<const NodeKind*> shapes;
    /// Modifiers and repeaters: operations that change the point or the distance.
    std::vector<const NodeKind*> spaces;
    /// Repeaters of shapes that are evaluated in one step with their shape (`isFolded`).
    std::vector<const NodeKind*> folds;
    std::vector<Joint> joints;
    std::uint32_t results = 0;  ///< Largest number of pending results.
    std::uint32_t places = 0;   ///< Largest nesting depth of spaces.

    /// Returns 1 + the index of the repeater in `folds` if the node is one and is folded; else 0.
    [[nodiscard]] std::uint32_t foldOf(const SceneProgram&, const SceneConstants&, std::uint32_t node) const;

    /// With more registers than these, shaders spill them.
    static constexpr std::uint32_t mostResults = 6, mostPlaces = 4;

    [[nodiscard]] static ListVocabulary of(const SceneProgram&, const SceneConstants&);
};

/// Returns whether a node is a repeater that a list evaluates in one step with its child: it needs a single copy
/// anywhere, and the child is a shape without a transformation.
[[nodiscard]] bool isFolded(const SceneProgram&, const SceneConstants&, std::uint32_t node);

/// Returns how many vec4 of a folded repeater's numbers precede the record of its shape.
[[nodiscard]] std::uint32_t foldedRecords(const NodeKind&);

/// Operations of a list. Their numbers follow those of the shapes and precede those of the spaces: `ListVocabulary`
/// numbers both in their order. Each space has three operations: `enter`, `modify` and `again`, in this order.
enum class ListOp : std::uint32_t { open, close, leave, enter };

/// Step as shaders read it, 16 bytes.
struct ListStep {
    /// Bits 0-7: the operation. Bits 8-15: the use of its distance: 0 keeps it for the next step, 1 makes it the first
    /// of its level, a number from 2 on joins it to that level by this kind of joint. Bits 16-19: 0, or 1 + the index
    /// of the repeater that is folded into the shape. Bit 31: more steps follow.
    std::uint32_t operation = 0;
    std::uint32_t record =
        0;  ///< Index of the node's record in vec4: 3 for its transform, then its scale and its numbers.
    std::uint32_t joint = 0;  ///< Index of the record of the node that joins.
    /// shape: index of its material, in vec4; again: the step to continue with, counted from the first one.
    std::uint32_t further = 0;
};
/// Flag of all steps except the last. llvmpipe reads 0 from buffers for pixels outside of a triangle and continues, so
/// 0 must end the loop.
inline constexpr std::uint32_t moreSteps = 1U << 31U;

/// Numbers of a scene in the form that lists need. Each node has the complete transform from the surrounding space, so
/// that operations that change no space need no steps.
class ListRecords {
public:
    /// Program and words must outlive it. Repeaters are folded as far as the vocabulary has folds; null: none are.
    ListRecords(const SceneProgram&, const SceneConstants&, const ListVocabulary*);

    [[nodiscard]] const std::vector<glm::vec4>& records() const { return records_; }
    [[nodiscard]] std::uint32_t ofNode(std::uint32_t node) const { return nodes_[node]; }
    [[nodiscard]] std::uint32_t ofMaterial(std::uint32_t material) const { return materials_[material]; }
    /// Transform from the space around a node to its own: p' = A p + b, and the factor from its distances to those
    /// outside.
    struct Way {
        glm::dmat3 turn{1};
        glm::dvec3 shift{0};
        double scale = 1;
    };
    [[nodiscard]] const Way& way(std::uint32_t node) const { return ways_[node]; }

private:
    void addNode(std::uint32_t node);

    const SceneProgram& program_;
    const SceneConstants& words_;
    const ListVocabulary* vocabulary_;
    std::vector<glm::vec4> records_;
    std::vector<std::uint32_t> nodes_, materials_;
    std::vector<Way> ways_;
};

/// Writes lists of steps, complete or pruned, in the form that shaders evaluate.
class ListWriter {
public:
    ListWriter(const SceneProgram&, const SceneConstants&, const ListVocabulary&, const ListRecords*);

    /// Writes the list of a whole scene or a part of it; not empty.
    [[nodiscard]] std::vector<ListStep> write(std::span<const Step> steps);
    /// Nesting depths of the last list.
    [[nodiscard]] std::uint32_t results() const { return results_; }
    [[nodiscard]] std::uint32_t places() const { return places_; }

private:
    [[nodiscard]] std::uint32_t spaceOf(const NodeKind&) const;
    [[nodiscard]] std::uint32_t jointOf(const ProgramNode&) const;
    void begin(const Step&);
    void end(const Step&);
    void addShape(std::uint32_t node, std::uint32_t fold);
    void join(std::uint32_t how, std::uint32_t parent);
    void add(std::uint32_t operation, std::uint32_t node, std::uint32_t further = 0);

    const SceneProgram& program_;
    const SceneConstants& words_;
    const ListVocabulary& vocabulary_;
    const ListRecords* records_;
    std::vector<std::uint32_t> children_;  // By node: number of children joined in this list.
    std::vector<char> opened_;             // By node: whether it has a level of its own.
    std::vector<std::uint32_t> began_;     // By node: the step after its `enter`.
    std::vector<char> fresh_;              // By level: nothing was joined in it yet.
    std::vector<ListStep> list_;
    std::uint32_t waiting_ = noIndex;  // Step whose result is joined next.
    std::uint32_t depth_ = 0, inside_ = 0, results_ = 0, places_ = 0;
};

}  // namespace vitrine::scenes
