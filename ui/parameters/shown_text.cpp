#include "ui/parameters/shown_text.h"

#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/table/value_text.h"
#include "render/failure.h"

#include "ui/kit/language.h"
#include "ui/kit/numbers.h"
#include "ui/kit/text.h"
#include "ui/parameters/screen_color.h"

#include <QColor>
#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vitrine::ui {
namespace {

QString tr(const char* words)
{
    return QCoreApplication::translate("ShownText", words);
}

/// Formats a number with at most `digits` significant digits, without trailing zeros. Very large and small ones get an
/// exponent.
QString shortNumber(double x, int digits)
{
    if (x == 0) return QStringLiteral("0");
    char buffer[64];
    const double size = std::abs(x);
    const bool plain = size >= 1e-4 && size < 1e7;
    const int decimals =
        plain ? std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(size))), 0, 8) : digits - 1;
    const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, format, decimals);
    QString shown = QString::fromLatin1(buffer, end.ptr - buffer);
    if (plain && shown.contains(QLatin1Char('.'))) {
        while (shown.endsWith(QLatin1Char('0'))) shown.chop(1);
        if (shown.endsWith(QLatin1Char('.'))) shown.chop(1);
    }
    return withDecimalSign(shown);
}

QString number(double stored, Unit unit)
{
    return shortNumber(shown(stored, unit), 4);
}

QString withUnit(const QString& number, Unit unit)
{
    const QString symbol = text(info(unit).symbol);
    if (symbol.isEmpty()) return number;
    return unit == Unit::degree || unit == Unit::percent ? number + symbol : number + QChar(0x2009) + symbol;
}

/// Formats hours as "16:06", to the nearest minute.
QString clockText(double hours)
{
    const long long minutes = std::llround(hours * 60);
    return QStringLiteral("%1:%2").arg(minutes / 60).arg(minutes % 60, 2, 10, QLatin1Char('0'));
}

/// Returns the separator of three numbers: a semicolon if the language has a decimal comma.
QString listSeparator()
{
    return numberLocale().decimalPoint() == QLatin1String(",") ? QStringLiteral("; ") : QStringLiteral(", ");
}

/// Converts a typed number, or three of them, to the notation of files.
QString asInFiles(const ParameterInfo& parameter, const QString& typed)
{
    if (parameter.isNumeric()) return withPoint(typed);
    if ((parameter.kind != Kind::color && parameter.kind != Kind::direction) || !typed.contains(QLatin1Char(';')))
        return typed;
    QStringList parts;
    for (const QString& part : typed.split(QLatin1Char(';'))) parts << withPoint(part.trimmed());
    return parts.join(QLatin1Char(','));
}

/// Parses a typed value. Accepts the number notation of the language and names of colors.
std::optional<Value> meantBy(const ParameterInfo& parameter, const QString& typed)
{
    if (std::optional<Value> value = parseValue(parameter, asInFiles(parameter, typed).toStdString())) return value;
    if (parameter.kind != Kind::color || typed.startsWith(QLatin1Char('#')) || !QColor::isValidColorName(typed))
        return std::nullopt;
    return linear(QColor(typed));
}

/// Returns which values a parameter accepts, for the message on an invalid one.
QString whatItTakes(const ParameterInfo& parameter)
{
    switch (parameter.kind) {
    case Kind::real:
    case Kind::count: return tr("Type a number; range: %1.").arg(legalRangeText(parameter));
    case Kind::toggle: return tr("Type on or off.");
    case Kind::choice: {
        QStringList names;
        for (const std::string_view name : parameter.choices) names << translatedText(name);
        return tr("Choose one of: %1.").arg(names.join(QStringLiteral(", ")));
    }
    case Kind::color: return tr("#f80, #ff8800, orange and 1, 0.25, 0 (linear red, green, blue) are.");
    case Kind::direction: return tr("Type three numbers: x, y, z.");
    case Kind::file:
    case Kind::text: return {};
    }
    return {};
}

QString three(const glm::dvec3& v)
{
    return QStringList{shortNumber(v.x, 3), shortNumber(v.y, 3), shortNumber(v.z, 3)}.join(listSeparator());
}

}  // namespace

QString emptyText(const ParameterInfo& parameter)
{
    if (parameter.kind != Kind::file) return tr("none");
    if (parameter.given.mustBeGiven) return tr("as shown");
    return parameter.assetFolder.empty() ? tr("none") : tr("the exhibit's own");
}

QString shownText(const ParameterInfo& parameter, const Value& value)
{
    if (const auto* x = std::get_if<double>(&value))
        if (const Word* word = parameter.wordFor(*x)) return translatedText(word->text);
    switch (parameter.kind) {
    case Kind::real:
        if (parameter.unit == Unit::hour) return clockText(std::get<double>(value));
        return withUnit(number(std::get<double>(value), parameter.unit), parameter.unit);
    case Kind::count: return withUnit(QString::number(std::llround(std::get<double>(value))), parameter.unit);
    case Kind::toggle: return std::get<double>(value) != 0 ? tr("on") : tr("off");
    case Kind::choice: return translatedText(parameter.choices[static_cast<std::size_t>(std::get<double>(value))]);
    case Kind::color:
    case Kind::direction: return three(std::get<glm::dvec3>(value));
    case Kind::file: {
        const std::string& path = std::get<std::string>(value);
        return path.empty() ? emptyText(parameter) : text(path);
    }
    case Kind::text: {
        const std::string& written = std::get<std::string>(value);
        if (written.empty()) return emptyText(parameter);
        return parameter.addsParameters ? tr("a text") : text(written);
    }
    }
    return {};
}

QString legalRangeText(const ParameterInfo& parameter)
{
    if (!parameter.isNumeric()) return {};
    return tr("%1 to %2")
        .arg(number(parameter.range.low, parameter.unit),
             withUnit(number(parameter.range.high, parameter.unit), parameter.unit));
}

QString tooltipText(const ParameterInfo& parameter)
{
    QStringList lines{translatedText(label(parameter)), QString(), translatedText(parameter.help), QString()};
    if (parameter.isNumeric()) {
        lines << tr("Range: %1").arg(legalRangeText(parameter));
        if (parameter.range.softLow != parameter.range.low || parameter.range.softHigh != parameter.range.high)
            lines.last() += tr("; slider from %1 to %2")
                                .arg(number(parameter.range.softLow, parameter.unit),
                                     withUnit(number(parameter.range.softHigh, parameter.unit), parameter.unit));
    }
    for (const Word& word : parameter.words) {
        const bool beyond = word.value < parameter.range.low || word.value > parameter.range.high;
        lines << (beyond ? tr("You can also type “%1”.").arg(translatedText(word.text))
                         : tr("%1 is shown as “%2”; you can also type that.")
                               .arg(editedText(parameter, word.value), translatedText(word.text)));
    }
    lines << tr("Initial value: %1").arg(shownText(parameter, parameter.initial));
    lines << tr("In presets: %1").arg(text(parameter.name));
    if (parameter.isNumeric())
        lines << QString()
              << tr("Drag the label or the number; click to type, 2*pi or 30deg too.\nShift is ten times "
                    "finer, Ctrl ten times coarser.");
    return lines.join(QLatin1Char('\n'));
}

QString exactText(const ParameterInfo& parameter, const Value& value)
{
    return QString::fromStdString(formatValue(parameter, value));
}

QString editedText(const ParameterInfo& parameter, const Value& value)
{
    return parameter.isNumeric() ? withDecimalSign(exactText(parameter, value)) : exactText(parameter, value);
}

std::optional<Value> typedValue(const ParameterInfo& parameter, const QString& typed, QString* problem)
{
    const std::optional<Value> meant = meantBy(parameter, typed.trimmed());
    const std::optional<Value> legal = meant ? nearestLegal(parameter, *meant) : std::nullopt;
    if (!legal) {
        if (problem)
            *problem = tr("\"%1\" is not a value of “%2”. %3")
                           .arg(typed.left(80), translatedText(label(parameter)), whatItTakes(parameter))
                           .trimmed();
        return std::nullopt;
    }
    const bool brought = parameter.isNumeric() && std::get<double>(*legal) != std::get<double>(*meant);
    if (problem && brought)
        *problem =
            tr("Range: %1. The value was set to %2.").arg(legalRangeText(parameter), shownText(parameter, *legal));
    return legal;
}

QString allAsJson(const ParameterValues& values, const QString& exhibit)
{
    return QString::fromStdString(
        presetText({exhibit.toStdString(), "Copied values", values, {}, render::Json::object(), {}}));
}

std::optional<ParameterValues> allFromJson(const Parameters& table, const QString& exhibit, const QString& json,
                                           QString* problem)
{
    try {
        const Preset read = parsePreset(json.toStdString(), "the clipboard", exhibit.toStdString(), table);
        QStringList notes;
        for (const std::string& note : read.notes) notes << translatedText(note);
        if (problem) *problem = notes.join(QLatin1Char('\n'));
        return read.values;
    } catch (const Failure& failure) {
        if (problem) *problem = translatedText(failure.message());
        return std::nullopt;
    }
}

}  // namespace vitrine::ui
