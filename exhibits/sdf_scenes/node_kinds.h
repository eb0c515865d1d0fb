#pragma once

#include "exhibits/framework/units.h"
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
    direction,  ///< Three numbers of any length but zero; unit length as a value.
    sizes       ///< Three numbers, or one that stands for all.
};

/// How many numbers a field of this type has.
[[nodiscard]] constexpr std::size_t numbersOf(FieldType type)
{
    return type >= FieldType::vector ? 3 : 1;
}

/// A parameter of a kind of node.
struct Field {
    std::string_view name;
    FieldType type = FieldType::real;
    Unit unit = Unit::none;            ///< Of what stands in files; values are SI.
    double low = 0, high = 0;          ///< Legal range of each number, SI.
    double softLow = 0, softHigh = 0;  ///< What a slider spans.
    std::array<double, 3> initial{};   ///< SI.
    std::string_view help{};           ///< One sentence.
    std::vector<std::string_view> choices{};
};

/// What a node is made of.
enum class Form : std::uint8_t {
    shape,     ///< No child.
    modifier,  ///< One child.
    repeater,  ///< One child, asked several times.
    pair,      ///< Two children.
    operands   ///< One child or more.
};

/// What the distance is, of a node whose children are exact.
enum class Exactness : std::uint8_t {
    exact,         ///< The Euclidean distance.
    exactOutside,  ///< The same outside; inside never farther than the surface.
    bound          ///< Never farther than the surface.
};

/// The text of a GLSL expression and the same expression as C++. In the text, V(0) is the first number of the node,
/// V3(0) its first three as a vec3; p, d, a, b and i are what the function below takes.
template <typename Function> struct Call {
    std::string_view glsl{};
    Function* cpu = nullptr;

    explicit operator bool() const { return cpu != nullptr; }
};

/// Which copies a repeater asks, found on the CPU from what its content covers.
struct Asked {
    glm::dvec3 high{0};   ///< Where the content ends; for copies around an axis, x is the angle.
    glm::dvec3 times{1};  ///< How many copies, along each axis.
    /// Where the child is only a bound, copies may step in before they are nearest. Then no distance is above this one,
    /// and no copy is nearer than its box; 0 where neither is needed.
    double cap = 0;
    render::Box box{glm::dvec3(0), glm::dvec3(0)};
};
/// How many numbers tell the copy and `capped` of it.
/// Behind these, center and half size of the box of all copies.
inline constexpr std::size_t numbersOfAsked = 19;

/// Bits of a field that does not change when a coordinate changes its sign.
inline constexpr unsigned evenInX = 1, evenInY = 2, evenInZ = 4, evenInAll = 7;

/// What the content of a node covers.
struct Extent {
    render::Box box;    ///< Holds everything at or below distance 0; infinite where there is no end.
    unsigned even = 0;  ///< Of `evenInX` and the others.
    bool flat = false;  ///< The distance does not change along z.
};

/// A row of the table of nodes. `v` are the numbers of a node in SI, in the order of the fields; those of a direction
/// have unit length.
struct NodeKind {
    std::string_view name;
    Form form = Form::shape;
    std::string_view help;
    std::vector<Field> fields;
    Exactness exactness = Exactness::exact;  ///< Of a node without a blend whose children are exact.
    bool ofFlatChild = false;                ///< Only a bound where the child is not flat.

    /// shape: the distance.
    Call<double(const glm::dvec3& p, const double* v)> distance{};
    /// modifier: where the child is asked; none is `p`.
    Call<glm::dvec3(const glm::dvec3& p, const double* v)> place{};
    /// modifier: the distance from that of the child; none is `d`.
    Call<double(double d, const glm::dvec3& p, const double* v)> after{};
    /// repeater: where the child is asked for the copy `i`. Behind its own numbers, n of them, stand those of `Asked`:
    /// V3(n) is `high`, V3(n + 3) `times`, V(n + 6) `cap`, V3(n + 7) and V3(n + 10) the center and half the size of the
    /// box.
    Call<glm::dvec3(const glm::dvec3& p, int i, const double* v)> copy{};
    /// pair, operands: the distance from that so far and that of the next child.
    Call<double(double a, double b, const double* v)> combine{};
    /// The share of b in it.
    Call<double(double a, double b, const double* v)> share{};

    /// operands: the lesser of two is the result, exactly, where they differ by this or more; none: it may not be.
    double (*lesserFrom)(const double* v) = nullptr;

    /// By how much the operation alone may stretch distances at p, 1 or more: what a distance is divided by.
    double (*lipschitz)(const glm::dvec3& p, const double* v) = nullptr;
    /// shape: what it covers.
    Extent (*extent)(const double* v) = nullptr;
    /// Others: what of a child, joined with `siblings` others, is at most this far, where the node is at most `level`
    /// far. None is `level`.
    double (*childLevel)(const double* v, double level, double siblings) = nullptr;
    /// modifier: the same where it grows with the distance from an axis, for points up to `reach` from that; with it,
    /// `reachOf` is the largest distance of a box from the axis. In place of `childLevel`.
    double (*childLevelWithin)(const double* v, double level, double reach) = nullptr;
    double (*reachOf)(const render::Box& child) = nullptr;
    /// modifier, repeater: what is within `level`, from what is of the child.
    Extent (*extentOf)(const Extent& child, const double* v, double level) = nullptr;
    /// operands, pair: the same of two.
    Extent (*extentOfTwo)(const Extent& a, const Extent& b) = nullptr;
    /// repeater: which copies may be nearest. `exactChild`: outside, the child is no mere bound.
    Asked (*asked)(const Extent& child, bool exactChild, const double* v) = nullptr;
    /// Why these numbers make no node, as a sentence without its full stop; empty where they do.
    std::string (*fault)(const double* v) = nullptr;

    /// How many numbers all fields have together.
    [[nodiscard]] std::size_t numbers() const;
    /// The first number of a field, or that of none of this name: `numbers()`.
    [[nodiscard]] std::size_t numberOf(std::string_view field) const;
};

/// All kinds: shapes, then operations.
[[nodiscard]] const std::vector<NodeKind>& nodeKinds();
/// By name; null for an unknown one.
[[nodiscard]] const NodeKind* findKind(std::string_view name);

// The parts that `nodeKinds` puts together.
[[nodiscard]] std::vector<NodeKind> solidKinds();
[[nodiscard]] std::vector<NodeKind> furtherSolidKinds();
[[nodiscard]] std::vector<NodeKind> profileKinds();
[[nodiscard]] std::vector<NodeKind> operandKinds();
[[nodiscard]] std::vector<NodeKind> modifierKinds();
[[nodiscard]] std::vector<NodeKind> repeaterKinds();

/// Grown by `by` on every side.
[[nodiscard]] render::Box grown(const render::Box&, double by);
/// Of this half size around the origin.
[[nodiscard]] render::Box boxAround(const glm::dvec3& halfSize);
/// Every place.
[[nodiscard]] render::Box endlessBox();

}  // namespace vitrine::scenes
