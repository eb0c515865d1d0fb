#include "ui/study/comparison_dialog.h"

#include "exhibits/study/study_text.h"
#include "render/files/number_text.h"
#include "ui/kit/text.h"
#include "ui/study/comparison_chart.h"
#include "ui/study/study_export.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>

namespace vitrine::ui {
namespace {

QString number(double x)
{
    return QString::fromStdString(render::shortNumber(x));
}

}  // namespace

QStringList differenceColumns(const study::StudyComparison& comparison)
{
    const QString first = QString::fromStdString(comparison.curves[0].label);
    return {ComparisonDialog::tr("Compared with"),
            ComparisonDialog::tr("Setting of %1").arg(first),
            comparedCostTitle(comparison.cost),
            ComparisonDialog::tr("Its error"),
            ComparisonDialog::tr("Error of the other study at this cost"),
            ComparisonDialog::tr("Cost of the other study at this error")};
}

QStringList differenceTexts(const study::StudyComparison& comparison, const study::StudyDifference& d)
{
    QString error = ComparisonDialog::tr("nothing so cheap was measured");
    if (d.errorAtCost)
        error =
            *d.errorAtCost > 0 && d.error > 0
                ? ComparisonDialog::tr("%1 (%2 times)").arg(number(*d.errorAtCost), number(*d.errorAtCost / d.error))
                : number(*d.errorAtCost);
    QString cost = ComparisonDialog::tr("nothing so exact was measured");
    if (d.costAtError) {
        const QString times = number(*d.costAtError / d.cost);
        if (d.costRatio && d.costRatio->confidence < 1)
            cost = ComparisonDialog::tr("%1 (%2 times; %3 to %4 with %5 % confidence)")
                       .arg(number(*d.costAtError), times, number(d.costRatio->low), number(d.costRatio->high),
                            number(100 * d.costRatio->confidence));
        else
            cost = ComparisonDialog::tr("%1 (%2 times)").arg(number(*d.costAtError), times);
    }
    if (d.uncertain) cost = ComparisonDialog::tr("%1; the references are no more accurate than that").arg(cost);
    return {QString::fromStdString(comparison.curves[d.study].label),
            QString::fromStdString(d.text),
            number(d.cost),
            number(d.error),
            error,
            cost};
}

ComparisonDialog::ComparisonDialog(std::vector<study::KeptStudy> studies, QWidget* parent)
    : QDialog(parent), studies_(std::move(studies)), labels_(study::labelsOf(studies_)), cost_(new QComboBox(this)),
      why_(new QLabel(this)), chart_(new ComparisonChart(this)), table_(new QTableWidget(this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Studies compared"));
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    why_->setWordWrap(true);
    why_->setTextFormat(Qt::PlainText);
    table_->setAccessibleName(tr("The other studies compared with the first"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->verticalHeader()->hide();
    table_->setTabKeyNavigation(false);
    auto* split = new QSplitter(Qt::Vertical, this);
    split->addWidget(chart_);
    split->addWidget(table_);
    split->setChildrenCollapsible(false);
    split->setSizes({400, 220});
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(12, 12, 12, 12);
    all->setSpacing(8);
    all->addLayout(top());
    all->addWidget(why_);
    all->addWidget(split, 1);
    all->addLayout(bottom());
    resize(960, 680);
    if (cost_->count() > 0) showCost(cost_->itemData(0).toString().toStdString());
}

QLayout* ComparisonDialog::top()
{
    cost_->setAccessibleName(tr("Unit of the costs"));
    for (const std::string& cost : study::sharedCosts(studies_))
        cost_->addItem(comparedCostTitle(cost), QString::fromStdString(cost));
    QStringList sentences{timesDifferText(study::timesDiffer(studies_))};
    if (cost_->count() == 0)
        sentences << tr("They share no count of work that tells their settings apart, so there is nothing to compare "
                        "them by.");
    sentences.removeAll(QString());
    why_->setText(sentences.join(QLatin1Char(' ')));
    why_->setVisible(!sentences.isEmpty());
    connect(cost_, &QComboBox::currentIndexChanged, this,
            [this] { showCost(cost_->currentData().toString().toStdString()); });
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    auto* label = new QLabel(tr("&Cost"), this);
    label->setBuddy(cost_);
    row->addWidget(label);
    row->addWidget(cost_);
    row->addStretch(1);
    return row;
}

QLayout* ComparisonDialog::bottom()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addStretch(1);
    const auto add = [&](const QString& text, const QString& help) {
        auto* button = new QPushButton(text, this);
        button->setToolTip(help);
        button->setAutoDefault(false);
        row->addWidget(button);
        return button;
    };
    connect(add(tr("Copy"), tr("Copies points and differences as a table (CSV).")), &QPushButton::clicked, this,
            [this] { QApplication::clipboard()->setText(QString::fromUtf8(exported(QStringLiteral("csv")))); });
    connect(add(tr("Save…"), tr("Saves the comparison as a table (CSV) or JSON, or the chart as PNG, SVG or PDF.")),
            &QPushButton::clicked, this, [this] {
                const QString why = askAndSaveStudy(this, [this](const QString& suffix) { return exported(suffix); });
                if (!why.isEmpty()) emit failed(why);
            });
    connect(add(tr("Close"), {}), &QPushButton::clicked, this, &QDialog::close);
    return row;
}

void ComparisonDialog::showCost(const std::string& cost)
{
    chart_->setComparison(study::compareStudies(studies_, labels_, cost));
    fillTable();
}

void ComparisonDialog::fillTable()
{
    const study::StudyComparison& comparison = chart_->comparison();
    const QStringList columns = differenceColumns(comparison);
    table_->setColumnCount(static_cast<int>(columns.size()));
    table_->setHorizontalHeaderLabels(columns);
    table_->setRowCount(static_cast<int>(comparison.differences.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const QStringList texts = differenceTexts(comparison, comparison.differences[static_cast<std::size_t>(row)]);
        for (int column = 0; column < texts.size(); ++column)
            table_->setItem(row, column, new QTableWidgetItem(texts[column]));
    }
    table_->resizeColumnsToContents();
    table_->horizontalHeader()->setStretchLastSection(true);
}

QByteArray ComparisonDialog::exported(const QString& suffix)
{
    if (suffix == QLatin1String("csv")) return QByteArray::fromStdString(study::comparisonCsv(chart_->comparison()));
    if (suffix == QLatin1String("json"))
        return QByteArray::fromStdString(render::writeJson(study::comparisonJson(studies_, chart_->comparison())));
    return chartFile(suffix, *chart_);
}

}  // namespace vitrine::ui

#include "moc_comparison_dialog.cpp"
