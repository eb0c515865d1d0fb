#include "exhibits/framework/table/expression.h"

#include "exhibits/framework/table/written_expression.h"
#include "render/files/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace vitrine {
namespace {

// More digits than double: a text can then name every stored value, even if the conversion from the shown unit would
// otherwise skip some.
using Number = long double;

enum class Measure : std::uint8_t { none, length, angle, time, pixel, stop, ratio, kelvin, hour };

/// A physical dimension: a measure and its power (per meter is length to the power -1).
struct Dimension {
    Measure measure = Measure::none;
    int power = 0;

    bool operator==(const Dimension&) const = default;
};

struct Quantity {
    Number value = 0;  // In SI if it has a dimension.
    Dimension dimension;
    std::string glsl = {};  // The same as GLSL, for `writtenExpression`; else empty.
};

/// Returns the number as a GLSL float.
std::string floatOf(Number value)
{
    std::string text = render::shortestNumber(static_cast<double>(static_cast<float>(value)));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

struct UnitWord {
    std::string_view word;
    Number inSi;
    Dimension dimension;
};

constexpr Number degree = std::numbers::pi_v<Number> / 180;

constexpr std::array<UnitWord, 23> unitWords = {{
    {"mm", 1e-3L, {Measure::length, 1}},
    {"cm", 1e-2L, {Measure::length, 1}},
    {"m", 1, {Measure::length, 1}},
    {"um", 1e-6L, {Measure::length, 1}},
    {"µm", 1e-6L, {Measure::length, 1}},
    {"μm", 1e-6L, {Measure::length, 1}},  // Micro sign and Greek mu.
    {"in", 0.0254L, {Measure::length, 1}},
    {"deg", degree, {Measure::angle, 1}},
    {"°", degree, {Measure::angle, 1}},
    {"rad", 1, {Measure::angle, 1}},
    {"turn", 360 * degree, {Measure::angle, 1}},
    {"ms", 1e-3L, {Measure::time, 1}},
    {"s", 1, {Measure::time, 1}},
    {"min", 60, {Measure::time, 1}},
    {"Hz", 1, {Measure::time, -1}},
    {"kHz", 1e3L, {Measure::time, -1}},
    {"px", 1, {Measure::pixel, 1}},
    {"EV", 1, {Measure::stop, 1}},
    {"stops", 1, {Measure::stop, 1}},
    {"stop", 1, {Measure::stop, 1}},
    {"%", 1e-2L, {Measure::ratio, 1}},
    {"K", 1, {Measure::kelvin, 1}},
    {"h", 1, {Measure::hour, 1}},  // Hour of the day, not a duration.
}};

const UnitWord* findUnit(std::string_view word)
{
    const auto* found =
        std::find_if(unitWords.begin(), unitWords.end(), [&](const UnitWord& u) { return u.word == word; });
    return found == unitWords.end() ? nullptr : found;
}

std::optional<Number> findConstant(std::string_view word)
{
    if (word == "pi" || word == "π") return std::numbers::pi_v<Number>;
    if (word == "e") return std::numbers::e_v<Number>;
    return std::nullopt;
}

struct FunctionWord {
    std::string_view word;
    std::size_t arguments;
    bool keepsUnit;  ///< The arguments have one unit, which is kept; otherwise they are plain numbers or angles.
    Number (*of)(const Number* x);
};

Number smoothStepOf(const Number* x)
{
    if (!(x[0] < x[1])) return x[2] < x[0] ? 0 : 1;
    const Number u = std::clamp((x[2] - x[0]) / (x[1] - x[0]), Number(0), Number(1));
    return u * u * (3 - 2 * u);
}

constexpr std::array<FunctionWord, 11> functionWords = {{
    {"sin", 1, false, [](const Number* x) { return std::sin(x[0]); }},
    {"cos", 1, false, [](const Number* x) { return std::cos(x[0]); }},
    {"sqrt", 1, false, [](const Number* x) { return std::sqrt(x[0]); }},
    {"smoothstep", 3, false, smoothStepOf},
    {"abs", 1, true, [](const Number* x) { return std::abs(x[0]); }},
    {"floor", 1, true, [](const Number* x) { return std::floor(x[0]); }},
    {"min", 2, true, [](const Number* x) { return std::min(x[0], x[1]); }},
    {"max", 2, true, [](const Number* x) { return std::max(x[0], x[1]); }},
    {"mod", 2, true, [](const Number* x) { return x[0] - x[1] * std::floor(x[0] / x[1]); }},
    {"clamp", 3, true, [](const Number* x) { return std::max(x[1], std::min(x[0], x[2])); }},
    {"mix", 3, true, [](const Number* x) { return x[0] * (1 - x[2]) + x[1] * x[2]; }},
}};

const FunctionWord* findFunction(std::string_view word)
{
    const auto* found =
        std::find_if(functionWords.begin(), functionWords.end(), [&](const FunctionWord& f) { return f.word == word; });
    return found == functionWords.end() ? nullptr : found;
}

bool isNameStart(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Returns the name at the start of the text; empty: none.
std::string_view nameAtStart(std::string_view text)
{
    std::size_t end = 0;
    while (end < text.size() && (isNameStart(text[end]) || (end > 0 && text[end] >= '0' && text[end] <= '9'))) ++end;
    return text.substr(0, end);
}

Dimension dimensionOf(Unit unit)
{
    switch (unit) {
    case Unit::none: return {};
    case Unit::meter:
    case Unit::centimeter:
    case Unit::millimeter:
    case Unit::micrometer: return {Measure::length, 1};
    case Unit::degree: return {Measure::angle, 1};
    case Unit::second: return {Measure::time, 1};
    case Unit::hertz: return {Measure::time, -1};
    case Unit::pixel: return {Measure::pixel, 1};
    case Unit::stop: return {Measure::stop, 1};
    case Unit::percent: return {Measure::ratio, 1};
    case Unit::kelvin: return {Measure::kelvin, 1};
    case Unit::perMeter: return {Measure::length, -1};
    case Unit::hour: return {Measure::hour, 1};
    }
    return {};
}

/// Recursive descent:  sum: product (± product)*   product: power (*|/ power)*   power: ± power | atom (^ power)?
class Parser {
public:
    /// Binding of a unit after a division: "1/50 s" is 1/(50 s), or (1/50) s.
    enum class Suffix : std::uint8_t { divisor, quotient };

    /// `written`: the names' values as GLSL, if that is wanted; else null.
    Parser(std::string_view text, Unit unit, Suffix suffix, const ExpressionNames* names,
           const WrittenNames* written = nullptr)
        : text_(text), unit_(unit), suffix_(suffix), names_(names), written_(written)
    {
    }

    /// Returns the value as GLSL.
    std::optional<std::string> writtenResult()
    {
        std::optional<Quantity> q = sum();
        skipBlanks();
        if (!q || at_ != text_.size()) return std::nullopt;
        const Dimension wanted = dimensionOf(unit_);
        if (q->dimension == Dimension{}) return inSi(*q).glsl;
        const bool fits =
            q->dimension == wanted || (unit_ == Unit::none && q->dimension == Dimension{Measure::ratio, 1});
        return fits ? std::optional(q->glsl) : std::nullopt;
    }

    std::optional<double> result()
    {
        std::optional<Quantity> q = sum();
        skipBlanks();
        if (!q || at_ != text_.size()) return std::nullopt;
        const Dimension wanted = dimensionOf(unit_);
        double x = 0;
        if (q->dimension == Dimension{})
            x = fromShown(q->value);
        else if (q->dimension == wanted || (unit_ == Unit::none && q->dimension == Dimension{Measure::ratio, 1})) {
            x = static_cast<double>(q->value);
        } else
            return std::nullopt;
        if (!std::isfinite(x)) return std::nullopt;
        return x;
    }

private:
    double fromShown(Number value) const
    {
        const double rounded = static_cast<double>(value);
        // The result equals the value that a slider stores, bit for bit.
        if (static_cast<Number>(rounded) == value) return stored(rounded, unit_);
        return static_cast<double>(value / static_cast<Number>(info(unit_).shownPerStored));
    }

    /// Returns a plain number, which is in the shown unit, in SI.
    Quantity inSi(const Quantity& plain) const
    {
        const double factor = 1 / info(unit_).shownPerStored;
        return {fromShown(plain.value), dimensionOf(unit_), factor == 1 ? plain.glsl : scaled(plain.glsl, factor)};
    }
    [[nodiscard]] std::string scaled(const std::string& glsl, Number factor) const
    {
        return written_ ? '(' + glsl + " * " + floatOf(factor) + ')' : std::string();
    }
    [[nodiscard]] std::string joined(const std::string& a, const char* sign, const std::string& b) const
    {
        return written_ ? '(' + a + sign + b + ')' : std::string();
    }

    void skipBlanks()
    {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    }
    bool take(std::string_view token)
    {
        skipBlanks();
        if (!text_.substr(at_).starts_with(token)) return false;
        at_ += token.size();
        return true;
    }
    static bool isWordByte(char c)
    {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        return letter || static_cast<unsigned char>(c) >= 0x80;
    }
    std::string_view peekWord()
    {
        skipBlanks();
        if (at_ < text_.size() && text_[at_] == '%') return text_.substr(at_, 1);
        std::size_t end = at_;
        while (end < text_.size() && isWordByte(text_[end])) ++end;
        return text_.substr(at_, end - at_);
    }

    std::optional<Quantity> sum()
    {
        std::optional<Quantity> left = product();
        while (left) {
            const bool plus = take("+");
            if (!plus && !take("-")) break;
            std::optional<Quantity> right = product();
            if (!right || !sameDimension(*left, *right)) return std::nullopt;
            left->value += plus ? right->value : -right->value;
            left->glsl = joined(left->glsl, plus ? " + " : " - ", right->glsl);
        }
        return left;
    }

    /// Converts a plain number next to a quantity to the shown unit.
    bool sameDimension(Quantity& a, Quantity& b) const
    {
        if (a.dimension == b.dimension) return true;
        Quantity& plain = a.dimension == Dimension{} ? a : b;
        const Quantity& other = &plain == &a ? b : a;
        if (plain.dimension != Dimension{} || other.dimension != dimensionOf(unit_)) return false;
        plain = {fromShown(plain.value), other.dimension, inSi(plain).glsl};
        return true;
    }

    std::optional<Quantity> product()
    {
        std::optional<Quantity> left = power();
        while (left) {
            const bool times = take("*");
            if (!times && !take("/")) break;
            const bool toQuotient = !times && suffix_ == Suffix::quotient;
            keepSuffix_ = toQuotient;
            const std::optional<Quantity> right = power();
            keepSuffix_ = false;
            if (!right) return std::nullopt;
            const std::string glsl = joined(left->glsl, times ? " * " : " / ", right->glsl);
            left = times ? multiplied(*left, *right, 1) : multiplied(*left, {1 / right->value, right->dimension}, -1);
            if (left) left->glsl = glsl;
            if (left && toQuotient) left = withSuffix(*left);
        }
        return left;
    }

    static std::optional<Quantity> multiplied(const Quantity& a, const Quantity& b, int sign)
    {
        const Quantity product{a.value * b.value, a.dimension};
        if (b.dimension == Dimension{}) return product;
        if (a.dimension != Dimension{} && a.dimension.measure != b.dimension.measure) return std::nullopt;
        const int power = a.dimension.power + sign * b.dimension.power;
        return Quantity{product.value, power == 0 ? Dimension{} : Dimension{b.dimension.measure, power}};
    }

    std::optional<Quantity> power()
    {
        if (++depth_ > 64) return std::nullopt;  // Deep nesting would overflow the stack.
        std::optional<Quantity> base;
        if (take("-")) {
            base = power();
            if (base) base->value = -base->value;
            if (base && written_) base->glsl = "(-" + base->glsl + ')';
        } else if (take("+")) {
            base = power();
        } else {
            base = atom();
            if (base && take("^")) {
                const std::optional<Quantity> exponent = power();
                if (!exponent || exponent->dimension != Dimension{} || base->dimension != Dimension{})
                    return std::nullopt;
                base->value = std::pow(base->value, exponent->value);
                if (written_) base->glsl = "expressionPower(" + base->glsl + ", " + exponent->glsl + ')';
            }
        }
        --depth_;
        return base;
    }

    std::optional<Quantity> atom()
    {
        const bool keepSuffix = std::exchange(keepSuffix_, false);
        std::optional<Quantity> q;
        if (names_) {
            skipBlanks();
            const std::string_view name = nameAtStart(text_.substr(at_));
            if (const FunctionWord* function = findFunction(name);
                function && text_.substr(at_ + name.size()).starts_with('(')) {
                at_ += name.size() + 1;
                return call(*function);
            }
            if (const std::optional<NamedValue> named = name.empty() ? std::nullopt : (*names_)(name)) {
                at_ += name.size();
                const Number value = named->value;
                return Quantity{value, dimensionOf(named->unit), written_ ? (*written_)(name)->glsl : std::string()};
            }
        }
        if (take("(")) {
            q = sum();
            if (!q || !take(")")) return std::nullopt;
        } else {
            q = number();
        }
        if (!q) return wordAlone();
        return keepSuffix ? q : withSuffix(*q);
    }

    /// Parses a function call after its opening parenthesis.
    std::optional<Quantity> call(const FunctionWord& function)
    {
        std::array<Quantity, 3> given{};
        for (std::size_t i = 0; i < function.arguments; ++i) {
            if (i > 0 && !take(",")) return std::nullopt;
            const std::optional<Quantity> argument = sum();
            if (!argument) return std::nullopt;
            given[i] = *argument;
            const bool plain = !function.keepsUnit || (function.word == "mix" && i == 2);
            const bool angle = given[i].dimension == Dimension{Measure::angle, 1};
            if (plain && given[i].dimension != Dimension{} && !angle) return std::nullopt;
            if (plain) continue;
            for (std::size_t j = 0; j < i; ++j)
                if (!sameDimension(given[j], given[i])) return std::nullopt;
        }
        if (!take(")")) return std::nullopt;
        const std::array<Number, 3> values{given[0].value, given[1].value, given[2].value};
        std::string glsl;
        if (written_) {
            glsl = std::string(function.word) + '(' + given[0].glsl;
            for (std::size_t i = 1; i < function.arguments; ++i) glsl += ", " + given[i].glsl;
            glsl += ')';
        }
        return Quantity{function.of(values.data()), function.keepsUnit ? given[0].dimension : Dimension{}, glsl};
    }

    std::optional<Quantity> number()
    {
        skipBlanks();
        const std::string_view rest = text_.substr(at_);
        if (rest.empty() || (rest.front() != '.' && (rest.front() < '0' || rest.front() > '9'))) return std::nullopt;
        Number x = 0;
        const std::from_chars_result end = std::from_chars(rest.data(), rest.data() + rest.size(), x);
        if (end.ec != std::errc()) return std::nullopt;
        at_ += static_cast<std::size_t>(end.ptr - rest.data());
        return Quantity{x, {}, written_ ? floatOf(x) : std::string()};
    }

    /// Parses what may follow a number: "2 pi", "30 deg", "2 pi rad".
    std::optional<Quantity> withSuffix(Quantity q)
    {
        std::string_view word = peekWord();
        if (const std::optional<Number> constant = findConstant(word)) {
            at_ += word.size();
            q.value *= *constant;
            q.glsl = scaled(q.glsl, *constant);
            word = peekWord();
        }
        if (word.empty()) return q;
        const UnitWord* unit = findUnit(word);
        if (!unit || q.dimension != Dimension{}) return std::nullopt;
        at_ += word.size();
        return Quantity{q.value * unit->inSi, unit->dimension, unit->inSi == 1 ? q.glsl : scaled(q.glsl, unit->inSi)};
    }

    /// Parses "pi", or a unit that stands for 1 of it, as in "2/m".
    std::optional<Quantity> wordAlone()
    {
        const std::string_view word = peekWord();
        if (const std::optional<Number> constant = findConstant(word)) {
            at_ += word.size();
            return withSuffix({*constant, {}, written_ ? floatOf(*constant) : std::string()});
        }
        const UnitWord* unit = findUnit(word);
        if (!unit) return std::nullopt;
        at_ += word.size();
        return Quantity{unit->inSi, unit->dimension, written_ ? floatOf(unit->inSi) : std::string()};
    }

    std::string_view text_;
    Unit unit_;
    Suffix suffix_;
    const ExpressionNames* names_;
    const WrittenNames* written_;
    bool keepSuffix_ = false;  // The next atom leaves its unit to the quotient.
    std::size_t at_ = 0;
    int depth_ = 0;
};

std::optional<double> evaluateWith(std::string_view text, Unit unit, const ExpressionNames* names)
{
    constexpr std::size_t longest = 4096;
    if (text.size() > longest) return std::nullopt;
    // A plain number is parsed directly as double: through a wider type it would be rounded twice.
    if (const std::optional<double> plain = render::parseNumber(text);
        plain && std::isfinite(*plain) && info(unit).shownPerStored == 1)
        return plain;
    // The reading with the right dimension is used: 1/(20 ms) in hertz, (1/50) s in seconds.
    const std::optional<double> x = Parser(text, unit, Parser::Suffix::divisor, names).result();
    return x ? x : Parser(text, unit, Parser::Suffix::quotient, names).result();
}

}  // namespace

std::optional<std::string> writtenExpression(std::string_view text, Unit unit, const WrittenNames& written)
{
    // Whether a name is known, and its unit, decide how the text is parsed; its value does not, so it is 1 here.
    const ExpressionNames names = [&](std::string_view name) -> std::optional<NamedValue> {
        const std::optional<WrittenValue> known = written(name);
        return known ? std::optional(NamedValue{1, known->unit}) : std::nullopt;
    };
    using Suffix = Parser::Suffix;
    const std::optional<std::string> glsl = Parser(text, unit, Suffix::divisor, &names, &written).writtenResult();
    return glsl ? glsl : Parser(text, unit, Suffix::quotient, &names, &written).writtenResult();
}

std::optional<double> evaluate(std::string_view text, Unit unit)
{
    return evaluateWith(text, unit, nullptr);
}

std::optional<double> evaluate(std::string_view text, Unit unit, const ExpressionNames& names)
{
    return evaluateWith(text, unit, &names);
}

std::vector<std::string> namesIn(std::string_view text)
{
    std::vector<std::string> names;
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view rest = text.substr(at);
        if (Number number = 0; (rest.front() >= '0' && rest.front() <= '9') || rest.front() == '.') {
            const auto end = std::from_chars(rest.data(), rest.data() + rest.size(), number);
            at += std::max<std::size_t>(1, static_cast<std::size_t>(end.ptr - rest.data()));
            continue;
        }
        const std::string_view name = nameAtStart(rest);
        if (!name.empty() && !isExpressionWord(name) && std::find(names.begin(), names.end(), name) == names.end())
            names.emplace_back(name);
        at += std::max<std::size_t>(1, name.size());
    }
    return names;
}

bool isExpressionWord(std::string_view word)
{
    return findUnit(word) || findConstant(word) || findFunction(word);
}

}  // namespace vitrine
