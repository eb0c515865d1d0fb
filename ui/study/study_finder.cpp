#include "ui/study/study_finder.h"

#include "exhibits/framework/table/expression.h"
#include "ui/kit/type_size.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>

namespace vitrine::ui {
namespace {

QLineEdit* numberField(const QString& name, const QString& start, QWidget* parent)
{
    auto* field = new QLineEdit(start, parent);
    field->setAccessibleName(name);
    growWidth(*field, 64);
    field->setAlignment(Qt::AlignRight);
    return field;
}

}  // namespace

StudyFinder::StudyFinder(QWidget* parent)
    : QObject(parent), byError_(new QWidget(parent)), byTime_(new QWidget(parent)),
      error_(numberField(tr("Largest error"), QStringLiteral("0.02"), byError_)),
      milliseconds_(numberField(tr("Longest time in milliseconds"), QStringLiteral("10"), byTime_))
{
    auto* cheapest = new QPushButton(tr("Find the cheapest setting"), byError_);
    cheapest->setAccessibleName(tr("Find the cheapest setting within the error"));
    auto* best = new QPushButton(tr("Find the best setting"), byTime_);
    best->setAccessibleName(tr("Find the best setting within the time"));
    const auto layOut = [](QWidget* part, std::initializer_list<QWidget*> words) {
        auto* line = new QHBoxLayout(part);
        line->setContentsMargins(0, 0, 8, 0);
        line->setSpacing(8);
        for (QWidget* each : words) line->addWidget(each);
    };
    layOut(byError_, {cheapest, new QLabel(tr("with an error of at most"), byError_), error_});
    layOut(byTime_, {best, new QLabel(tr("within"), byTime_), milliseconds_, new QLabel(tr("ms"), byTime_)});
    connect(cheapest, &QPushButton::clicked, this, [this] { ask(study::StudyFind::cheapest); });
    connect(best, &QPushButton::clicked, this, [this] { ask(study::StudyFind::best); });
    connect(error_, &QLineEdit::returnPressed, this, [this] { ask(study::StudyFind::cheapest); });
    connect(milliseconds_, &QLineEdit::returnPressed, this, [this] { ask(study::StudyFind::best); });
}

void StudyFinder::suggestTime(const study::StudyResult& result)
{
    if (milliseconds_->isModified() || !result.present) return;
    const study::StudyPoint& present = result.points[*result.present];
    if (present.time) milliseconds_->setText(QLocale::c().toString(present.time->median / 2, 'g', 3));
}

void StudyFinder::ask(study::StudyFind wanted)
{
    const bool byError = wanted == study::StudyFind::cheapest;
    const QLineEdit* field = byError ? error_ : milliseconds_;
    const std::optional<double> limit = evaluate(field->text().trimmed().toStdString(), Unit::none);
    if (limit && *limit > 0) {
        emit asked(wanted, *limit);
        return;
    }
    emit refused(tr("\"%1\" is not a limit; type a number above 0, such as %2.")
                     .arg(field->text(), byError ? QStringLiteral("0.02") : QStringLiteral("10")));
}

}  // namespace vitrine::ui

#include "moc_study_finder.cpp"
