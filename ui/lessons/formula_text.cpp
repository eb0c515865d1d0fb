#include "ui/lessons/formula_text.h"

#include <QList>
#include <QXmlStreamReader>

namespace vitrine::ui {
namespace {

/// Part of a formula as rich text.
struct Piece {
    /// Binding strength of the outermost operator: decides whether a fraction in one line needs parentheses.
    enum class Bond { atom, product, sum, infix, prefix, opening, closing };
    QString text;
    Bond bond = Bond::atom;
};

using Bond = Piece::Bond;

Piece operatorPiece(const QString& sign)
{
    if (sign == QChar(0x2062)) return {QStringLiteral(" "), Bond::prefix};  // Invisible times.
    if (sign == QLatin1String(",") || sign == QLatin1String(";")) return {sign + QLatin1Char(' '), Bond::prefix};
    if (QStringLiteral("([⌊").contains(sign)) return {sign, Bond::opening};
    if (QStringLiteral(")]⌋").contains(sign)) return {sign, Bond::closing};
    return {sign.toHtmlEscaped(), QStringLiteral("=+−±<>≤≥≈×·/").contains(sign) ? Bond::infix : Bond::atom};
}

Piece inOneRow(const QList<Piece>& pieces)
{
    if (pieces.size() == 1) return pieces.front();
    Piece all{{}, Bond::product};
    bool operand = false;  // Whether something stands before the sign that it could connect.
    for (const Piece& piece : pieces) {
        if (piece.bond != Bond::infix) {
            all.text += piece.text;
        } else if (operand) {
            all.text += QLatin1Char(' ') + piece.text + QLatin1Char(' ');
            all.bond = Bond::sum;
        } else {
            all.text += piece.text;
        }
        if (piece.text.startsWith(QChar(0x2211)) || piece.text.startsWith(QChar(0x222B)))  // Sum and integral.
            all.text += QLatin1Char(' ');
        operand = piece.bond != Bond::infix && piece.bond != Bond::prefix && piece.bond != Bond::opening;
    }
    if (!pieces.isEmpty() && pieces.front().bond == Bond::opening && pieces.back().bond == Bond::closing)
        all.bond = Bond::atom;
    return all;
}

QString enclosed(const Piece& piece, bool needed)
{
    return needed ? QLatin1Char('(') + piece.text + QLatin1Char(')') : piece.text;
}

Piece fraction(const Piece& above, const Piece& below)
{
    const bool isShort = above.bond == Bond::atom && below.bond == Bond::atom;
    return {enclosed(above, above.bond == Bond::sum) + (isShort ? QStringLiteral("/") : QStringLiteral(" / ")) +
                enclosed(below, below.bond != Bond::atom),
            Bond::product};
}

QString superscript(QString text)
{
    text.remove(QLatin1Char(' '));
    const bool isPrime = text == QChar(0x2032) || text == QChar(0x2033);
    return isPrime ? text : QStringLiteral("<sup>") + text + QStringLiteral("</sup>");
}

QString subscript(QString text)
{
    text.remove(QLatin1Char(' '));
    return QStringLiteral("<sub>") + text + QStringLiteral("</sub>");
}

Piece letter(const QXmlStreamAttributes& attributes, const QString& name)
{
    const QStringView variant = attributes.value(QLatin1String("mathvariant"));
    if (variant == QLatin1String("bold")) return {QStringLiteral("<b>") + name + QStringLiteral("</b>")};
    if (variant == QLatin1String("normal") || name.size() > 1) return {name.toHtmlEscaped()};
    return {QStringLiteral("<i>") + name + QStringLiteral("</i>")};
}

/// Reads the element whose start tag was just read, with its content.
Piece elementText(QXmlStreamReader& xml)  // NOLINT(misc-no-recursion): As deep as the formulas of the pages.
{
    const QString name = xml.name().toString();
    const QXmlStreamAttributes attributes = xml.attributes();
    if (name == QLatin1String("mi")) return letter(attributes, xml.readElementText());
    if (name == QLatin1String("mo")) return operatorPiece(xml.readElementText());
    if (name == QLatin1String("mn") || name == QLatin1String("mtext")) return {xml.readElementText().toHtmlEscaped()};
    QList<Piece> parts;
    while (xml.readNextStartElement()) parts << elementText(xml);
    const auto part = [&parts](qsizetype i) { return parts.value(i); };
    if (name == QLatin1String("mspace")) {
        const bool isWide = attributes.value(QLatin1String("width")) == QLatin1String("2em");
        return {isWide ? QString(3, QChar(0xA0)) : QStringLiteral(" "), Bond::prefix};
    }
    if (name == QLatin1String("mfrac")) return fraction(part(0), part(1));
    if (name == QLatin1String("msqrt")) {
        const Piece root = inOneRow(parts);
        return {QChar(0x221A) + enclosed(root, root.bond != Bond::atom)};
    }
    if (name == QLatin1String("msub") || name == QLatin1String("munder"))
        return {part(0).text + subscript(part(1).text)};
    if (name == QLatin1String("msup") || name == QLatin1String("mover"))
        return {part(0).text + superscript(part(1).text)};
    if (name == QLatin1String("msubsup") || name == QLatin1String("munderover"))
        return {part(0).text + subscript(part(1).text) + superscript(part(2).text)};
    return inOneRow(parts);
}

}  // namespace

QString withFormulasAsText(const QString& page)
{
    static const QString end = QStringLiteral("</math>");
    QString result;
    qsizetype from = 0;
    for (qsizetype at = page.indexOf(QLatin1String("<math")); at >= 0;
         at = page.indexOf(QLatin1String("<math"), from)) {
        const qsizetype close = page.indexOf(end, at);
        if (close < 0) break;
        const QString formula = page.mid(at, close + end.size() - at);
        QXmlStreamReader xml(formula);
        xml.readNextStartElement();
        const QString text = elementText(xml).text;
        result += page.mid(from, at - from) + (xml.hasError() ? formula : text);
        from = close + end.size();
    }
    return result + page.mid(from);
}

}  // namespace vitrine::ui
