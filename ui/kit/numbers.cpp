#include "ui/kit/numbers.h"

#include "ui/kit/language.h"

namespace vitrine::ui {

QLocale numberLocale()
{
    if (languageCode() == QLatin1String("en")) return QLocale::c();
    QLocale locale(languageCode());
    locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::OmitLeadingZeroInExponent);
    return locale;
}

QString withDecimalSign(const QString& number)
{
    QString shown = number;
    return shown.replace(QLatin1Char('.'), numberLocale().decimalPoint());
}

QString withPoint(const QString& typed)
{
    const QString comma = QStringLiteral(",");
    if (numberLocale().decimalPoint() != comma && QLocale().decimalPoint() != comma) return typed;
    if (typed.contains(QLatin1Char('.'))) return typed;
    QString meant = typed;
    return meant.replace(QLatin1Char(','), QLatin1Char('.'));
}

}  // namespace vitrine::ui
