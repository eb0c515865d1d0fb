#include "ui/study/point_caption.h"

#include "exhibits/study/study_text.h"
#include "ui/kit/language.h"

#include <QCoreApplication>
#include <QLocale>

namespace vitrine::ui {

QString threeDigits(double x)
{
    return QLocale::c().toString(x, 'g', 3);
}

QString pointCaption(const QString& setting, const PointNumbers& numbers)
{
    QString text = QCoreApplication::translate("StudyView", "%1: error %2").arg(setting, threeDigits(numbers.error));
    if (const auto& time = numbers.time)
        text += QCoreApplication::translate("StudyView", ", %1 ms (%2 to %3)")
                    .arg(threeDigits(time->median), threeDigits(time->low), threeDigits(time->high));
    if (numbers.work)
        text += QCoreApplication::translate("StudyView", ", %1 %2")
                    .arg(QLocale::c().toString(*numbers.work), translatedText(study::costTitle(numbers.workName)));
    if (numbers.modelError)
        text += QCoreApplication::translate("StudyView", "; against everything exact %1")
                    .arg(threeDigits(*numbers.modelError));
    return text;
}

}  // namespace vitrine::ui
