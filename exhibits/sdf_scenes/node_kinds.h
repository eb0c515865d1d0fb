#pragma once

#include "exhibits/framework/table/units.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::scenes {

enum class FieldType : std::uint8_t {
    real,
    count,      ///< A whole number.
    toggle,     ///< true or false; 0 or 1 as a number.
    choice,     ///< One of some words; its index as a number.
    vector,     ///< Three numbers.
    counts,     ///< Three whole numbers.
    direction,  ///< Three numbers of any length except zero; normalized as a value.
    sizes       ///< Three numbers, or one that is used for all three.
};

/// Returns how many numbers a field of this type has.
[[nodiscard]] constexpr std::size_t numbersOf(FieldType type)
{
    return type >= FieldType::vector ? 3 : 1;
}

/// Parameter of a kind of node.
struct Field {
    std::string_view name;
    FieldType type = FieldType::real;
    Unit unit = Unit::none;            ///< Unit in files; values are in SI.
    double low = 0, high = 0;          ///< Legal range of each number, SI.
    double softLow = 0, softHigh = 0;  ///< Range of a slider.
    std::array<double, 3> initial{};   ///< SI.
    std::string_view help{};           ///< One sentence.
    std::vector<std::string_view> choices{};
};

/// Number of children of a node.
enum class Form : std::uint8_t {
    shape,     ///< No child.
    modifier,  ///< One child.
    repeater,  ///< One child, evaluated several times.
    pair,      ///< Two children.
    operands   ///< One child or more.
};

/// Quality of the distance of a node whose children are exact.
enum class Exactness : std::uint8_t {
    exact,         ///< The Euclidean distance.
    exactOutside,  ///< Exact outside; inside at most the distance to the surface.
    bound          ///< At most the distance to the surface.
};

/// A GLSL expression and the same expression as C++. In the text, V(0) is the first number of the node, V3(0) its first
/// three as a vec3; p, d, a, b and i are the arguments of the function below.
template <typename Function> struct Expression {
    std::string_view glsl{};
    Function* cpu = nullptr;

    explicit operator bool() const { return cpu != nullptr; }
};

/// Copies that a repeater must evaluate, determined on the CPU from the bounds of its content.
struct RepeatRange {
    glm::dvec3 high{0};   ///< High corner of the content; for copies around an axis, x is its last angle.
    glm::dvec3 times{1};  ///< Number of copies along each axis.
    /// Upper bound on the distance, needed if the child's SDF is only a bound, because copies may then matter before
    /// they are nearest. The distance to a copy is then also at least that to its box. 0: not needed.
    double cap = 0;
    render::Box box{glm::dvec3(0), glm::dvec3(0)};
};
/// Count of a repeater's derived numbers: the members of `RepeatRange`, then center and half size of the box of all
/// copies.
inline constexpr std::size_t numbersOfRepeatRange = 19;

/// Bits of a field that is symmetric: changing the sign of the coordinate does not change it.
inline constexpr unsigned evenInX = 1, evenInY = 2, evenInZ = 4, evenInAll = 7;

/// Bounds of the content of a node.
struct Bounds {
    render::Box box;    ///< Contains everything at distance 0 or below; infinite for infinite content.
    unsigned even = 0;  ///< Bits of `evenInX` and the others.
    bool flat = false;  ///< The distance does not change along z.
    /// Least x of the centers, if the field is the distance to balls whose centers are at z = 0; else -infinity.
    double ballsFrom = -std::numeric_limits<double>::infinity();
};

/// Description of a kind of node. `v` are the numbers of a node in SI, in the order of the fields; directions are
/// normalized.
struct NodeKind {
    std::string_view name;
    Form form = Form::shape;
    std::string_view help;
    std::vector<Field> fields;
    Exactness exactness = Exactness::exact;  ///< Exactness of a node without a blend whose children are exact.
    bool ofFlatChild = false;                ///< Only a bound if the child is not flat.

    /// shape: distance.
    Expression<double(const glm::dvec3& p, const double* v)> distance{};
    /// modifier: point at which the child is evaluated; none: `p`.
    Expression<glm::dvec3(const glm::dvec3& p, const double* v)> place{};
    /// modifier: distance from that of the child; none: `d`.
    Expression<double(double d, const glm::dvec3& p, const double* v)> after{};
    /// repeater: point at which the child is evaluated for copy `i`. The node's own n numbers are followed by those of
    /// `RepeatRange`: V3(n) is `high`, V3(n + 3) `times`, V(n + 6) `cap`, V3(n + 7) and V3(n + 10) center and half size
    /// of the box.
    Expression<glm::dvec3(const glm::dvec3& p, int i, const double* v)> copy{};
    /// pair, operands: distance from the result so far and that of the next child.
    Expression<double(double a, double b, const double* v)> combine{};
    /// Weight of b in the result.
    Expression<double(double a, double b, const double* v)> share{};

    /// operands: difference of two operands from which on the result is exactly the lesser one; none: not guaranteed.
    double (*lesserFrom)(const double* v) = nullptr;

    /// Upper bound on the stretch of distances at p by the operation alone, at least 1: the distance is divided by it.
    double (*lipschitz)(const glm::dvec3& p, const double* v) = nullptr;
    /// shape: its bounds.
    Bounds (*extent)(const double* v) = nullptr;
    /// Other forms: the largest distance of a child, joined with `siblings` others, that matters where the node's
    /// distance is at most `level`. None: `level`.
    double (*childLevel)(const double* v, double level, double siblings) = nullptr;
    /// modifier: the same if it grows with the distance from an axis, for points up to `reach` from the axis. It comes
    /// with `reachOf`, the largest distance of a box from the axis, and replaces `childLevel`.
    double (*childLevelWithin)(const double* v, double level, double reach) = nullptr;
    double (*reachOf)(const render::Box& child) = nullptr;
    /// modifier, repeater: bounds of the points within `level`, from those of the child.
    Bounds (*extentOf)(const Bounds& child, const double* v, double level) = nullptr;
    /// operands, pair: the same for two children.
    Bounds (*extentOfTwo)(const Bounds& a, const Bounds& b) = nullptr;
    /// repeater: the copies that may be nearest. `exactChild`: outside, the child's distance is exact.
    RepeatRange (*asked)(const Bounds& child, bool exactChild, const double* v) = nullptr;
    /// Returns why these numbers are invalid, as a sentence without its full stop; empty if they are valid.
    std::string (*fault)(const double* v) = nullptr;

    /// Returns the count of numbers of all fields.
    [[nodiscard]] std::size_t numbers() const;
    /// Returns the index of a field's first number; `numbers()` if there is no field of this name.
    [[nodiscard]] std::size_t numberOf(std::string_view field) const;
};

/// Returns all kinds: shapes, then operations.
[[nodiscard]] const std::vector<NodeKind>& nodeKinds();
/// Finds a kind by name; null for an unknown one.
[[nodiscard]] const NodeKind* findKind(std::string_view name);

// Parts of the list of `nodeKinds`.
[[nodiscard]] std::vector<NodeKind> solidKinds();
[[nodiscard]] std::vector<NodeKind> furtherSolidKinds();
[[nodiscard]] std::vector<NodeKind> profileKinds();
[[nodiscard]] std::vector<NodeKind> operandKinds();
[[nodiscard]] std::vector<NodeKind> modifierKinds();
[[nodiscard]] std::vector<NodeKind> repeaterKinds();

/// Returns the box extended by `by` on every side.
[[nodiscard]] render::Box grown(const render::Box&, double by);
/// Returns a box centered at the origin with these half extents.
[[nodiscard]] render::Box boxAround(const glm::dvec3& halfSize);
/// Returns the infinite box.
[[nodiscard]] render::Box endlessBox();

}  // namespace vitrine::scenes
