#include "ui/kit/roomy_ticker.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace vitrine::ui {
namespace {

constexpr int mostTicks = 9;    // Most ticks; more do not help to read a curve.
constexpr int enoughTicks = 2;  // Fewest ticks that show a scale.

/// Returns the multiples of a step within the range.
QVector<double> multiples(double step, const QCPRange& range)
{
    QVector<double> ticks;
    const double first = std::ceil(range.lower / step - 1e-9);
    for (double k = first; k * step <= range.upper * (1 + 1e-12) + 1e-300 && ticks.size() < 64; ++k)
        ticks.append(k * step);
    return ticks;
}

/// Returns ticks with these mantissas in every n-th decade of the range.
QVector<double> inDecades(std::initializer_list<double> mantissas, int every, const QCPRange& range)
{
    QVector<double> ticks;
    const int last = static_cast<int>(std::floor(std::log10(range.upper)));
    int decade = static_cast<int>(std::floor(std::log10(range.lower)));
    decade -= ((decade % every) + every) % every;
    for (; decade <= last && ticks.size() < 1000; decade += every)
        for (const double mantissa : mantissas)
            if (const double tick = mantissa * std::pow(10.0, decade); tick >= range.lower && tick <= range.upper)
                ticks.append(tick);
    return ticks;
}

/// Returns possible choices of ticks, those with the most ticks first.
QVector<QVector<double>> choices(const QCPRange& range, bool logarithmic)
{
    QVector<QVector<double>> all;
    if (logarithmic && range.upper > 8 * range.lower) {
        all << inDecades({1, 2, 5}, 1, range) << inDecades({1, 3}, 1, range);
        for (const int every : {1, 2, 3, 5, 10, 20, 50}) all << inDecades({1}, every, range);
    }
    const double span = range.upper - range.lower;
    double decade = std::pow(10.0, std::floor(std::log10(span / 10)));
    for (int i = 0; i < 3; ++i, decade *= 10)
        for (const double mantissa : {1.0, 2.0, 5.0})
            if (mantissa * decade >= span / 12) all << multiples(mantissa * decade, range);
    return all;
}

QString raised(int exponent)
{
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = exponent < 0 ? QStringLiteral("⁻") : QString();
    for (const QChar digit : QString::number(std::abs(exponent))) text += digits[digit.digitValue()];
    return text;
}

}  // namespace

QString axisNumber(double value)
{
    const double size = std::abs(value);
    if (size == 0) return QStringLiteral("0");
    if (size >= 1e-4 && size < 1e6) {
        QString text = QString::number(value, 'g', 10);
        const qsizetype point = text.indexOf(QLatin1Char('.'));
        // From five digits on, a narrow no-break space separates the thousands.
        if (size >= 1e4) text.insert((point < 0 ? text.size() : point) - 3, QChar(0x202F));
        return text;
    }
    const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-9));
    const QString mantissa = QString::number(value / std::pow(10.0, exponent), 'g', 6);
    const QString power = QStringLiteral("10") + raised(exponent);
    return mantissa == QLatin1String("1") ? power : mantissa + QStringLiteral("·") + power;
}

double RoomyTicker::length() const
{
    const QRect inner = axis_.axisRect()->rect();
    const bool lies = axis_.orientation() == Qt::Horizontal;
    const double known = lies ? inner.width() : inner.height();
    // Before the first layout this is about what the margins leave.
    const QRect all = axis_.parentPlot()->viewport();
    return known > 8 ? known : 0.6 * (lies ? all.width() : all.height());
}

double RoomyTicker::place(double tick, const QCPRange& range) const
{
    const bool logarithmic = axis_.scaleType() == QCPAxis::stLogarithmic;
    const double share = logarithmic ? std::log(tick / range.lower) / std::log(range.upper / range.lower)
                                     : (tick - range.lower) / (range.upper - range.lower);
    return share * length();
}

double RoomyTicker::extent(double tick) const
{
    const QFontMetricsF metrics(axis_.tickLabelFont());
    return axis_.orientation() == Qt::Horizontal ? metrics.horizontalAdvance(axisNumber(tick)) : metrics.height();
}

QVector<double> RoomyTicker::within(const QVector<double>& ticks, const QCPRange& range) const
{
    QVector<double> kept;
    for (const double tick : ticks) {
        const double half = extent(tick) / 2;
        const double at = place(tick, range);
        if (at - half >= 0 && at + half <= length()) kept.append(tick);
    }
    return kept;
}

bool RoomyTicker::collide(const QVector<double>& ticks, const QCPRange& range) const
{
    const QFontMetricsF metrics(axis_.tickLabelFont());
    const double gap = axis_.orientation() == Qt::Horizontal ? metrics.averageCharWidth() * 2 : metrics.height() / 4;
    for (qsizetype i = 1; i < ticks.size(); ++i) {
        const double apart = place(ticks[i], range) - place(ticks[i - 1], range);
        if (apart < (extent(ticks[i]) + extent(ticks[i - 1])) / 2 + gap) return true;
    }
    return false;
}

// The parameters are those of QCPAxisTicker. NOLINTNEXTLINE(readability-function-size)
void RoomyTicker::generate(const QCPRange& range, const QLocale&, QChar, int, QVector<double>& ticks,
                           QVector<double>* subTicks, QVector<QString>* tickLabels)
{
    ticks.clear();
    const bool logarithmic = axis_.scaleType() == QCPAxis::stLogarithmic;
    if (range.upper > range.lower && (!logarithmic || range.lower > 0)) {
        for (const QVector<double>& choice : choices(range, logarithmic)) {
            const QVector<double> shown = within(choice, range);
            if (shown.size() > mostTicks || shown.size() <= ticks.size() || collide(shown, range)) continue;
            ticks = shown;
            if (ticks.size() >= enoughTicks) break;
        }
    }
    if (subTicks != nullptr) subTicks->clear();
    if (tickLabels == nullptr) return;
    tickLabels->clear();
    for (const double tick : ticks) tickLabels->append(axisNumber(tick));
}

}  // namespace vitrine::ui
