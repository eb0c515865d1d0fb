#pragma once

#include "exhibits/framework/table/condition.h"
#include "exhibits/framework/table/motion.h"
#include "exhibits/framework/table/units.h"
#include "exhibits/framework/table/value.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace vitrine {

enum class Kind : std::uint8_t { real, count, toggle, choice, color, direction, file, text };
enum class Scale : std::uint8_t { linear, logarithmic };

/// Returns the name that `vitrine list --json` prints: "real", "count", ...
[[nodiscard]] std::string_view toString(Kind);
[[nodiscard]] std::string_view toString(Scale);

/// Legal closed interval of a number and, inside it, the comfortable interval that the slider spans. `scale` shapes the
/// slider and spaces the points of an accuracy study.
struct Range {
    double low;
    double high;
    Scale scale;
    double softLow;
    double softHigh;

    // A constructor, because GCC 13 ends with an internal error for an aggregate here: one whose initializers read each
    // other, as an argument of a member's initializer.
    constexpr Range() : Range(0, 1) {}
    constexpr Range(double from, double to, Scale shape = Scale::linear) : Range(from, to, shape, from, to) {}
    constexpr Range(double from, double to, Scale shape, double softFrom, double softTo)
        : low(from), high(to), scale(shape), softLow(softFrom), softHigh(softTo)
    {
    }

    [[nodiscard]] constexpr Range soft(double from, double to) const { return {low, high, scale, from, to}; }
    bool operator==(const Range&) const = default;
};

/// Number with a special meaning, which is shown and typed as a word: "auto" for 0.
struct Word {
    double value = 0;
    std::string_view text;  ///< "auto".

    bool operator==(const Word&) const = default;
};

/// Value that another parameter takes if this parameter is given: a file of views sets the origin of the views.
struct Implication {
    std::string_view parameter;
    double value = 0;

    bool operator==(const Implication&) const = default;
};

/// Traits of a job's parameter: its form on the command line, in requests to the service and in settings documents.
struct GivenAs {
    std::string_view option;   ///< Name on the command line, without dashes; empty: the parameter's name, "frame-rate".
    Unit unit = Unit::none;    ///< Unit of a plain number on the command line; none: SI.
    std::string_view tuple;    ///< Neighbors with the same tuple are one option and one JSON array; empty: none.
    char separator = 0;        ///< Character between the values of a tuple on the command line: "64x48".
    bool mustBeGiven = false;  ///< Refused where neither the command line nor the settings document gives it.
    bool positional = false;   ///< A word of its own on the command line, without an option.
    std::vector<Implication> implies = {};

    bool operator==(const GivenAs&) const = default;
};

/// Description of one parameter of a table.
///
/// Everything that the program knows about a parameter is declared here. The slider and its tooltip, the key in a
/// preset, the command line flag, the field of the uniform block, the line in the manual, the points of the accuracy
/// study and the random values of the tests are all derived from it.
struct ParameterInfo {
    std::string_view name;   ///< Name of its member in a table; also its preset key, its option and its GLSL field.
    std::string_view group;  ///< Heading in the panel; empty before the first `group`.
    std::string_view help;   ///< One or two sentences: what it does, what low and high look like.
    Kind kind = Kind::real;
    Unit unit = Unit::none;  ///< Unit in which it is shown; `range` and `initial` are in SI units.
    Range range;
    Value initial;
    std::vector<std::string_view> choices = {};   ///< Names, for Kind::choice only.
    std::optional<double> qualityReference = {};  ///< Value that counts as exact, if accuracy costs time.
    bool exactByMeaning = false;             ///< The reference is exact by definition; else a test checks that it is.
    std::optional<Condition> actsWhen = {};  ///< Condition under which it can change a picture; none: always.
    std::string_view label = {};             ///< Label; empty: made from `name`.
    std::vector<Word> words = {};            ///< For a real or a count; values may lie outside of `range`.
    std::string_view extensions = {};        ///< For Kind::file: accepted extensions, "glb gltf"; empty: all files.
    bool addsParameters = false;             ///< For Kind::file and text: the file or the text adds parameters.
    std::string_view assetFolder = {};       ///< For Kind::file: folder of the assets in which bare names are found.
    std::string_view array = {};             ///< The array of groups that it belongs to: "coats"; empty: none.
    std::size_t element = 0;                 ///< Index of its group in the array, from 0.
    std::string_view elementParameter = {};  ///< Its name within each of these groups: "length" of "ballLength".
    std::string_view documentOf = {};        ///< For Kind::text: parameter of the file that it replaces or belongs to.
    bool several = false;                    ///< For Kind::file and text: each line is a value of its own.
    bool essential = false;                  ///< One of the six that the panel of an exhibit shows at first.
    GivenAs given = {};

    /// Returns whether its values are numbers with intermediate values: a real or a count.
    [[nodiscard]] bool isNumeric() const { return kind == Kind::real || kind == Kind::count; }
    /// Returns whether its values are strings. Shaders and sweeps do not use such a parameter.
    [[nodiscard]] bool isWritten() const { return kind == Kind::file || kind == Kind::text; }
    /// Returns the word for this value; null if there is none.
    [[nodiscard]] const Word* wordFor(double value) const;
    bool operator==(const ParameterInfo&) const = default;
};

/// Returns the label: the declared one, otherwise made from the name: "Shell count" for "shellCount".
[[nodiscard]] std::string label(const ParameterInfo&);
/// Returns the label under the heading of its group, without a word that the heading contains: "Length" for "Ball
/// length" in "Coat of the ball".
[[nodiscard]] std::string labelInGroup(const ParameterInfo&);

/// Returns the legal value nearest to `value`. Returns nothing if the type is wrong or the number is NaN.
[[nodiscard]] std::optional<Value> nearestLegal(const ParameterInfo&, const Value& value);

/// Returns why a parameter of this description cannot be animated, as a full sentence; empty: it can.
///  - files and texts: every value would have to be read;
///  - parameters of accuracy (`quality`): they determine costs and image sizes, and are set by studies and by the
///    renderer itself.
/// All others can. A count, choice or switch may select a shader or mesh of its own; that is made when it first occurs
/// and reused afterwards.
[[nodiscard]] std::string_view whyUnmoved(const ParameterInfo&);

/// Typed handle of a parameter: its index in the table, and the type of its value.
template <typename T> struct Parameter {
    std::uint16_t row;
};
using Real = Parameter<double>;
using Count = Parameter<int>;
using Toggle = Parameter<bool>;
struct ColorValue {
    glm::dvec3 value;
};
struct DirectionValue {
    glm::dvec3 value;
};
using Color = Parameter<ColorValue>;
using Direction = Parameter<DirectionValue>;
using File = Parameter<std::string>;
using Text = Parameter<std::string>;
template <typename Enum> using Choice = Parameter<Enum>;

class ParameterValues;

/// A parameter table. Derive from it and declare each parameter as one member:
///
///     struct Table final : Parameters {
///         Group shape = group("Shape");
///         Real morph = real("morph", 0.5, none, {0, 1}, "0 is a torus, 1 is a mug.");
///         Count stepLimit = count("stepLimit", 96, {1, 512, logarithmic}, "Steps a ray may take.", quality(512));
///         Choice<NormalMethod> normalMethod = choice("normalMethod", NormalMethod::central,
///             {"forward", "tetrahedron", "central"}, "How the normal is estimated.", quality(NormalMethod::central));
///     };
///
/// A table copies every text that it is given, so it can be made of a file that is read at run time as well:
/// `MadeTable`, `TableFromFiles::dynamicParameters`. Values of a table that a std::shared_ptr owns keep it alive; any
/// other has to outlive its values.
class Parameters : public std::enable_shared_from_this<Parameters> {
public:
    Parameters(const Parameters&) = delete;  // Handles are only meaningful to their own table.
    Parameters& operator=(const Parameters&) = delete;
    Parameters() = default;  // An empty table is a table.
    ~Parameters() = default;

    [[nodiscard]] std::span<const ParameterInfo> rows() const { return rows_; }
    /// Returns whether the other table declares the same parameters with the same properties.
    [[nodiscard]] bool hasParametersOf(const Parameters& other) const { return rows_ == other.rows_; }
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
    [[nodiscard]] ParameterValues initial() const;

    /// Heading of the parameters declared after it.
    struct Group {
        std::string_view title;
    };

protected:
    using enum Unit;  // So that a parameter reads `meter`, not `Unit::meter`.
    using enum Scale;

    /// One group of an array: `name` ("ball") is the prefix of its parameters' names, `heading` is shown above them.
    struct Element {
        std::string_view name;
        std::string_view heading;
    };

    /// Converts degrees to radians, for initial values and ranges of angles. For most angles it is the inverse, to the
    /// last bit, of the conversion with which `Unit::degree` displays them.
    [[nodiscard]] static constexpr double degrees(double angle) { return angle / (180 / std::numbers::pi); }

    // Traits of a parameter, which follow its help in any order:
    struct Quality {
        std::optional<double> reference;
        bool byMeaning;
    };
    /// Declares that accuracy costs time, and that `reference` is the most exact value; a study checks how exact it is.
    [[nodiscard]] static Quality quality(double reference) { return {reference, false}; }
    /// The same, but nothing is approximated at `reference`: a closed form, or an approximation that is switched off.
    [[nodiscard]] static Quality exactAt(double reference) { return {reference, true}; }
    template <typename Enum>
    requires std::is_enum_v<Enum>
    [[nodiscard]] static Quality quality(Enum reference) { return quality(static_cast<double>(reference)); }
    template <typename Enum>
    requires std::is_enum_v<Enum>
    [[nodiscard]] static Quality exactAt(Enum reference) { return exactAt(static_cast<double>(reference)); }
    /// Extensions of the files that a file parameter accepts, separated by blanks: "glb gltf".
    struct Extensions {
        std::string_view text;
    };
    [[nodiscard]] static Extensions extensions(std::string_view text) { return {text}; }
    struct AssetFolder {
        std::string_view folder, first;
    };
    /// For a file parameter: a name without a folder refers to a file in this folder of the assets, if there is one of
    /// that name (`filePath`). `first` is the initial value; empty: no file.
    [[nodiscard]] static AssetFolder inAssetFolder(std::string_view folder, std::string_view first = {})
    {
        return {folder, first};
    }
    struct AddsParameters {};
    /// For a file parameter: its file adds parameters to the table (`TableFromFiles::dynamicParameters`).
    [[nodiscard]] static AddsParameters addsParameters() { return {}; }
    struct Essential {
        bool is;
    };
    /// Marks one of the six parameters that make an exhibit what it is: the panel opens with them, and the others are
    /// folded by group. `is`: false for a parameter of an array whose other groups have the mark.
    [[nodiscard]] static Essential essential(bool is = true) { return {is}; }
    struct Label {
        std::string_view text;
    };
    [[nodiscard]] static Label labeled(std::string_view text) { return {text}; }
    /// Shows and accepts this word for `value`, which may be outside of the parameter's range, even infinite. A
    /// parameter may have several words.
    [[nodiscard]] static Word reads(double value, std::string_view word) { return {value, word}; }
    struct Option {
        std::string_view name;
        Unit unit;
    };
    /// Name on the command line, without dashes, and the unit of a plain number there.
    [[nodiscard]] static Option option(std::string_view name, Unit unit = none) { return {name, unit}; }
    /// Unit of a plain number on the command line.
    [[nodiscard]] static Option typedIn(Unit unit) { return {{}, unit}; }
    struct Tuple {
        std::string_view name;
        char separator;
    };
    /// Makes neighbors one option of the command line, "--size 64x48", and one array of a settings document.
    [[nodiscard]] static Tuple tuple(std::string_view name, char separator) { return {name, separator}; }
    struct Several {};
    /// Makes a file or text parameter a list with one value per line. A path with a line break is refused.
    [[nodiscard]] static Several several() { return {}; }
    struct MustBeGiven {};
    [[nodiscard]] static MustBeGiven mustBeGiven() { return {}; }
    struct Positional {};
    /// Makes the parameter an argument without an option name on the command line, in the order of the table.
    [[nodiscard]] static Positional positional() { return {}; }
    struct OfFile {
        std::string_view file;
    };
    /// Marks a text that names something in the file. Choosing another file resets it (`ParameterValues::chooseFile`).
    [[nodiscard]] OfFile ofFile(File file) const { return {nameOf(file)}; }
    /// Sets another parameter to a value if this parameter is given and the other one is not.
    template <typename T> [[nodiscard]] Implication implies(Parameter<T> parameter, T value) const
    {
        return {nameOf(parameter), static_cast<double>(value)};
    }
    /// Condition under which the parameter acts: `when(...) && when(...)`, `when(...) || when(...)`.
    [[nodiscard]] Condition when(Toggle parameter, bool on = true) const
    {
        return {Condition::Test::among, nameOf(parameter), {on ? 1.0 : 0.0}};
    }
    template <typename Enum>
    requires std::is_enum_v<Enum>
    [[nodiscard]] Condition when(Choice<Enum> parameter, Enum value) const { return when(parameter, {value}); }
    template <typename Enum>
    requires std::is_enum_v<Enum>
    [[nodiscard]] Condition when(Choice<Enum> parameter, std::initializer_list<Enum> values) const
    {
        Condition condition{Condition::Test::among, nameOf(parameter)};
        for (const Enum value : values) condition.values.push_back(static_cast<double>(value));
        return condition;
    }
    template <typename Enum>
    requires std::is_enum_v<Enum>
    [[nodiscard]] Condition whenNot(Choice<Enum> parameter, Enum value) const
    {
        return {Condition::Test::differs, nameOf(parameter), {static_cast<double>(value)}};
    }
    [[nodiscard]] Condition when(Real parameter, double value) const
    {
        return {Condition::Test::among, nameOf(parameter), {value}};
    }
    [[nodiscard]] Condition whenNot(Real parameter, double value) const
    {
        return {Condition::Test::differs, nameOf(parameter), {value}};
    }
    [[nodiscard]] Condition whenAbove(Real parameter, double value) const
    {
        return {Condition::Test::above, nameOf(parameter), {value}};
    }
    [[nodiscard]] Condition whenAbove(Count parameter, double value) const
    {
        return {Condition::Test::above, nameOf(parameter), {value}};
    }
    [[nodiscard]] Condition whenGiven(File parameter) const { return {Condition::Test::given, nameOf(parameter)}; }
    // Condition on a parameter that is declared later, by its name and its value as a number:
    [[nodiscard]] static Condition whenLater(std::string_view row, double value)
    {
        return {Condition::Test::among, row, {value}};
    }
    [[nodiscard]] static Condition whenLaterAbove(std::string_view row, double value)
    {
        return {Condition::Test::above, row, {value}};
    }

    /// Declares the heading of the parameters that follow.
    Group group(std::string_view title);

    /// Declares groups with the same parameters, one for each element. Within `make(i)`, the name "length" becomes
    /// "ballLength". Returns what `make` returns, in the order of the elements.
    template <typename Make> auto groups(std::string_view array, std::span<const Element> elements, const Make& make)
    {
        std::vector<decltype(make(std::size_t{0}))> made;
        for (std::size_t i = 0; i < elements.size(); ++i) {
            beginElement(array, i, elements[i]);
            made.push_back(make(i));
        }
        endArray();
        return made;
    }

    template <typename... Traits>
    Real real(std::string_view name, double initial, Unit unit, Range range, std::string_view help,
              const Traits&... traits)
    {
        return {append({name, group_, help, Kind::real, unit, range, initial}, traits...)};
    }
    template <typename... Traits>
    Count count(std::string_view name, int initial, Range range, std::string_view help, const Traits&... traits)
    {
        return {append({name, group_, help, Kind::count, Unit::none, range, static_cast<double>(initial)}, traits...)};
    }
    template <typename... Traits>
    Toggle toggle(std::string_view name, bool initial, std::string_view help, const Traits&... traits)
    {
        return {append({name, group_, help, Kind::toggle, Unit::none, {0, 1}, initial ? 1.0 : 0.0}, traits...)};
    }
    /// `initial` is linear Rec. 709, each component 0 to 1.
    template <typename... Traits>
    Color color(std::string_view name, glm::dvec3 initial, std::string_view help, const Traits&... traits)
    {
        return {append({name, group_, help, Kind::color, Unit::none, {0, 1}, initial}, traits...)};
    }
    /// `initial` is normalized here.
    template <typename... Traits>
    Direction direction(std::string_view name, glm::dvec3 initial, std::string_view help, const Traits&... traits)
    {
        return {append({name, group_, help, Kind::direction, Unit::none, {-1, 1}, glm::normalize(initial)}, traits...)};
    }
    template <typename... Traits> File file(std::string_view name, std::string_view help, const Traits&... traits)
    {
        return {append({name, group_, help, Kind::file, Unit::none, {0, 0}, std::string()}, traits...)};
    }
    /// Declares a typed text: a name, or with `several` a list of names.
    template <typename... Traits> Text text(std::string_view name, std::string_view help, const Traits&... traits)
    {
        return {append({name, group_, help, Kind::text, Unit::none, {0, 0}, std::string()}, traits...)};
    }
    /// Declares a text with the unsaved, edited content of the file that `of` names; empty: there are no unsaved edits.
    /// It adds parameters as the file does. Choosing another file clears it (`ParameterValues::chooseFile`).
    File document(std::string_view name, File of, std::string_view help)
    {
        ParameterInfo parameter{name, group_, help, Kind::text, Unit::none, {0, 0}, std::string()};
        parameter.addsParameters = true;
        parameter.documentOf = nameOf(of);
        return {append(std::move(parameter))};
    }
    template <typename Enum, typename... Traits>
    Choice<Enum> choice(std::string_view name, Enum initial, std::initializer_list<std::string_view> names,
                        std::string_view help, const Traits&... traits)
    {
        const double last = static_cast<double>(names.size()) - 1;
        return {append({name, group_, help, Kind::choice, Unit::none, {0, last}, static_cast<double>(initial), names},
                       traits...)};
    }
    /// The same for choices that are only known at run time. `initial` is an index; there must be at least one name.
    template <typename... Traits>
    Choice<int> choice(std::string_view name, int initial, std::span<const std::string> names, std::string_view help,
                       const Traits&... traits)
    {
        const double last = static_cast<double>(names.size()) - 1;
        return {append({name,
                        group_,
                        help,
                        Kind::choice,
                        Unit::none,
                        {0, last},
                        static_cast<double>(initial),
                        {names.begin(), names.end()}},
                       traits...)};
    }

private:
    static void say(ParameterInfo& parameter, const Quality& quality)
    {
        parameter.qualityReference = quality.reference;
        parameter.exactByMeaning = quality.byMeaning;
    }
    static void say(ParameterInfo& parameter, const Extensions& extensions) { parameter.extensions = extensions.text; }
    static void say(ParameterInfo& parameter, const AddsParameters&) { parameter.addsParameters = true; }
    static void say(ParameterInfo& parameter, const AssetFolder& in)
    {
        parameter.assetFolder = in.folder;
        parameter.initial = std::string(in.first);
    }
    static void say(ParameterInfo& parameter, const Essential& essential) { parameter.essential = essential.is; }
    static void say(ParameterInfo& parameter, const Label& label) { parameter.label = label.text; }
    static void say(ParameterInfo& parameter, const Word& word) { parameter.words.push_back(word); }
    static void say(ParameterInfo& parameter, const Option& option)
    {
        parameter.given.option = option.name;
        parameter.given.unit = option.unit;
    }
    static void say(ParameterInfo& parameter, const Tuple& tuple)
    {
        parameter.given.tuple = tuple.name;
        parameter.given.separator = tuple.separator;
    }
    static void say(ParameterInfo& parameter, const OfFile& of) { parameter.documentOf = of.file; }
    static void say(ParameterInfo& parameter, const Several&) { parameter.several = true; }
    static void say(ParameterInfo& parameter, const MustBeGiven&) { parameter.given.mustBeGiven = true; }
    static void say(ParameterInfo& parameter, const Positional&) { parameter.given.positional = true; }
    static void say(ParameterInfo& parameter, const Implication& implied)
    {
        parameter.given.implies.push_back(implied);
    }
    static void say(ParameterInfo& parameter, const std::optional<Condition>& condition)
    {
        parameter.actsWhen = condition;
    }
    template <typename... Traits> std::uint16_t append(ParameterInfo parameter, const Traits&... traits)
    {
        (say(parameter, traits), ...);
        return appendParameter(std::move(parameter));
    }
    std::uint16_t appendParameter(ParameterInfo);
    template <typename T> [[nodiscard]] std::string_view nameOf(Parameter<T> parameter) const
    {
        return rows_[parameter.row].name;
    }
    void beginElement(std::string_view array, std::size_t index, const Element&);
    void endArray();
    /// Returns the table's own copy of a text.
    [[nodiscard]] std::string_view owned(std::string_view);
    void own(Condition&);

    std::set<std::string, std::less<>> texts_;  ///< Nodes keep their place.
    std::vector<ParameterInfo> rows_;
    std::string_view group_;
    std::string_view array_;
    std::size_t element_ = 0;
    std::string_view elementName_;
};

/// Table whose parameters are only known at run time, such as those of a scene file.
class MadeTable final : public Parameters {
public:
    using Parameters::addsParameters;
    using Parameters::choice;
    using Parameters::color;
    using Parameters::count;
    using Parameters::direction;
    using Parameters::Element;
    using Parameters::file;
    using Parameters::group;
    using Parameters::groups;
    using Parameters::quality;
    using Parameters::real;
    using Parameters::toggle;
};

/// Returns whether a parameter may have this name: a letter, then letters and digits, at most 64 in all. Such a name is
/// valid as a key, a flag and a field in GLSL. Words that GLSL reserves are not excluded; the caller must avoid them.
[[nodiscard]] bool isParameterName(std::string_view);

/// Snapshot of one value for each parameter of a table. Cheap to copy: presets, A/B comparisons, undo and sweeps
/// consist of snapshots, and a frame is a function of one.
class ParameterValues {
public:
    /// Makes the initial values of a table, which a std::shared_ptr owns or which must outlive the values.
    explicit ParameterValues(const Parameters&);
    /// Makes the initial values of a table, which must not be null. The values keep it alive.
    explicit ParameterValues(std::shared_ptr<const Parameters>);

    template <typename T> [[nodiscard]] T operator[](Parameter<T> p) const
    {
        if constexpr (std::is_same_v<T, std::string>)
            return std::get<std::string>(values_[p.row]);
        else if constexpr (std::is_same_v<T, ColorValue> || std::is_same_v<T, DirectionValue>)
            return T{std::get<glm::dvec3>(values_[p.row])};
        else
            return static_cast<T>(std::get<double>(values_[p.row]));
    }
    template <typename T> void set(Parameter<T> p, const T& value)
    {
        if constexpr (std::is_same_v<T, std::string>)
            setParameter(p.row, value);
        else if constexpr (std::is_same_v<T, ColorValue> || std::is_same_v<T, DirectionValue>)
            setParameter(p.row, value.value);
        else
            setParameter(p.row, static_cast<double>(value));
    }

    [[nodiscard]] const Parameters& table() const { return *table_; }
    [[nodiscard]] const std::shared_ptr<const Parameters>& sharedTable() const { return table_; }
    [[nodiscard]] std::span<const ParameterInfo> rows() const { return table_->rows(); }

    /// Untyped access by index, for code that visits all parameters: panels, presets, flags, studies.
    [[nodiscard]] const Value& row(std::size_t i) const { return values_[i]; }
    /// Stores the nearest legal value. If there is none (wrong type, NaN), the old value stays. Returns whether the
    /// stored value is exactly `value`.
    bool setParameter(std::size_t i, const Value& value);
    void resetParameter(std::size_t i);
    /// Like `setParameter`, for a file parameter. Choosing another file clears the documents and texts that belong to
    /// the old file.
    bool chooseFile(std::size_t i, const Value& value);
    [[nodiscard]] bool isInitial(std::size_t i) const;

    /// Values of parameters that the table does not have, as JSON by name, because the file that adds them has not been
    /// read yet or is unreadable. Presets and sessions write them again.
    using PendingParameters = std::map<std::string, std::string>;
    [[nodiscard]] const PendingParameters& pending() const { return pending_; }
    void setPending(PendingParameters pending) { pending_ = std::move(pending); }
    /// Returns the files and documents that add parameters to the table, in the order of their parameters.
    [[nodiscard]] std::vector<std::string> tableFiles() const;

    /// Returns the animations by parameter name. Only parameters that can be animated (`whyUnmoved`) have one, and both
    /// ends are legal values.
    [[nodiscard]] const Motions& motions() const { return motions_; }
    /// Returns the animation of parameter `i`; null if it is not animated.
    [[nodiscard]] const Motion* motion(std::size_t i) const;
    /// Animates parameter `i`; nullopt ends its animation. Both ends become the nearest legal values. Returns false and
    /// changes nothing if the parameter cannot be animated or an end has the wrong type.
    bool setMotion(std::size_t i, std::optional<Motion> motion);
    /// Returns animations of parameters that the table does not have, like `pending` for values.
    [[nodiscard]] const PendingParameters& pendingMotions() const { return pendingMotions_; }
    void setPendingMotions(PendingParameters pending) { pendingMotions_ = std::move(pending); }

    /// Compares the values. Those of different tables are equal if the parameters have the same names and values.
    bool operator==(const ParameterValues& other) const;

private:
    std::shared_ptr<const Parameters> table_;  ///< Owns nothing where the table outlives the values.
    std::vector<Value> values_;
    PendingParameters pending_, pendingMotions_;
    Motions motions_;
};

}  // namespace vitrine
