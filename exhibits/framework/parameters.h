#pragma once

#include "exhibits/framework/units.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace vitrine {

enum class Kind : std::uint8_t { real, count, toggle, choice, color, direction, file };
enum class Scale : std::uint8_t { linear, logarithmic };

/// "real", "count", ... as `vitrine list --json` prints them.
[[nodiscard]] std::string_view toString(Kind);
[[nodiscard]] std::string_view toString(Scale);

/// The legal closed interval of a number and, inside it, the comfortable one that the slider spans.
/// `scale` shapes the slider and spaces the points of an accuracy study.
struct Range {
    double low = 0;
    double high = 1;
    Scale scale = Scale::linear;
    double softLow = low;
    double softHigh = high;

    [[nodiscard]] constexpr Range soft(double from, double to) const { return {low, high, scale, from, to}; }
};

/// A value as code that walks a table sees it: a number for real, count, toggle (0 or 1) and choice
/// (its index); three numbers for color (linear Rec. 709) and direction (unit length); a path for file.
using Value = std::variant<double, glm::dvec3, std::string>;

/// One row of a parameter table.
///
/// Everything the program says about a parameter is said here: the slider and its tooltip, the key in
/// a preset, the command line flag, the field of the uniform block, the line in the manual, the points
/// of the accuracy study and the random values of the tests are all derived from this row.
struct ParameterInfo {
    std::string_view name;   ///< The member it initialises; preset key, flag and GLSL field.
    std::string_view group;  ///< Heading in the panel; empty before the first `group`.
    std::string_view help;   ///< One or two sentences: what it does, what low and high look like.
    Kind kind = Kind::real;
    Unit unit = Unit::none;  ///< How to show it; `range` and `initial` are in SI.
    Range range;
    Value initial;
    std::vector<std::string_view> choices;    ///< Names, for Kind::choice only.
    std::optional<double> qualityReference;   ///< The value that counts as exact, when accuracy costs time.
    std::string_view endings = {};            ///< For Kind::file: what a dialog offers, "glb gltf"; empty: everything.

    /// Whether its values are numbers, with others between them: a real or a count.
    [[nodiscard]] bool isNumeric() const { return kind == Kind::real || kind == Kind::count; }
};

/// "Shell count" for "shellCount".
[[nodiscard]] std::string label(const ParameterInfo&);

/// The legal value nearest to `value`, or nothing when its type or a NaN leaves no nearest one.
[[nodiscard]] std::optional<Value> nearestLegal(const ParameterInfo&, const Value& value);

/// Typed handles: the index of a row, and the type its value reads back as.
template <typename T> struct Parameter {
    std::uint16_t row;
};
using Real = Parameter<double>;
using Count = Parameter<int>;
using Toggle = Parameter<bool>;
struct ColorValue { glm::dvec3 value; };
struct DirectionValue { glm::dvec3 value; };
using Color = Parameter<ColorValue>;
using Direction = Parameter<DirectionValue>;
using File = Parameter<std::string>;
template <typename Enum> using Choice = Parameter<Enum>;

class ParameterValues;

/// A parameter table. Derive from it and declare each parameter as one member:
///
///     struct Table final : Parameters {
///         Group shape = group("Shape");
///         Real morph = real("morph", 0.5, none, {0, 1}, "0 is a torus, 1 is a mug.");
///         Count stepLimit = count("stepLimit", 96, {1, 512, logarithmic}, "Steps a ray may take.", quality(512));
///         Choice<NormalMethod> normalMethod = choice("normalMethod", NormalMethod::central,
///             {"forward", "tetrahedron", "central"}, "How the normal is estimated.", quality(2));
///     };
class Parameters {
public:
    Parameters(const Parameters&) = delete;  // Handles are only meaningful to their own table.
    Parameters& operator=(const Parameters&) = delete;
    Parameters() = default;  // An empty table is a table.
    ~Parameters() = default;

    [[nodiscard]] std::span<const ParameterInfo> rows() const { return rows_; }
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
    [[nodiscard]] ParameterValues initial() const;

protected:
    using enum Unit;  // So that a row reads `metre`, not `Unit::metre`.
    using enum Scale;

    struct Group {};
    struct Quality { std::optional<double> reference; };
    [[nodiscard]] static Quality quality(double reference) { return {reference}; }

    /// Heading of the rows that follow.
    Group group(std::string_view title);

    Real real(std::string_view name, double initial, Unit, Range, std::string_view help, Quality = {});
    Count count(std::string_view name, int initial, Range, std::string_view help, Quality = {});
    Toggle toggle(std::string_view name, bool initial, std::string_view help, Quality = {});
    /// `initial` is linear Rec. 709, each component 0 to 1.
    Color color(std::string_view name, glm::dvec3 initial, std::string_view help);
    /// `initial` is normalized here.
    Direction direction(std::string_view name, glm::dvec3 initial, std::string_view help);
    /// `endings`: of the files it reads, with blanks between: "glb gltf".
    File file(std::string_view name, std::string_view help, std::string_view endings = {});
    template <typename Enum>
    Choice<Enum> choice(std::string_view name, Enum initial, std::initializer_list<std::string_view> names,
                        std::string_view help, Quality reference = {})
    {
        return {appendChoice(name, static_cast<int>(initial), names, help, reference)};
    }

private:
    std::uint16_t append(ParameterInfo);
    std::uint16_t appendChoice(std::string_view name, int initial, std::initializer_list<std::string_view> names,
                               std::string_view help, Quality);

    std::vector<ParameterInfo> rows_;
    std::string_view group_;
};

/// A snapshot of one value per row of one table. Cheap to copy: presets, A/B comparisons, undo and
/// sweeps are all just snapshots, and a frame is a function of one. The table must outlive it.
class ParameterValues {
public:
    explicit ParameterValues(const Parameters&);

    template <typename T> [[nodiscard]] T operator[](Parameter<T> p) const
    {
        if constexpr (std::is_same_v<T, std::string>) return std::get<std::string>(values_[p.row]);
        else if constexpr (std::is_same_v<T, ColorValue> || std::is_same_v<T, DirectionValue>)
            return T{std::get<glm::dvec3>(values_[p.row])};
        else return static_cast<T>(std::get<double>(values_[p.row]));
    }
    template <typename T> void set(Parameter<T> p, const T& value)
    {
        if constexpr (std::is_same_v<T, std::string>) setRow(p.row, value);
        else if constexpr (std::is_same_v<T, ColorValue> || std::is_same_v<T, DirectionValue>) setRow(p.row, value.value);
        else setRow(p.row, static_cast<double>(value));
    }

    [[nodiscard]] const Parameters& table() const { return *table_; }
    [[nodiscard]] std::span<const ParameterInfo> rows() const { return table_->rows(); }

    /// Untyped access, for code that walks the table: panels, presets, flags, studies.
    [[nodiscard]] const Value& row(std::size_t i) const { return values_[i]; }
    /// Stores the nearest legal value; a value without one (wrong type, NaN) leaves the row as it was.
    /// Returns whether the stored value is exactly `value`.
    bool setRow(std::size_t i, const Value& value);
    void resetRow(std::size_t i);
    [[nodiscard]] bool isInitial(std::size_t i) const;

    bool operator==(const ParameterValues& other) const { return values_ == other.values_; }

private:
    const Parameters* table_;
    std::vector<Value> values_;
};

}  // namespace vitrine
