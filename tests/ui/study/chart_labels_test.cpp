// Positions of texts in charts, read from their SVG: none overlaps another or extends beyond the edge. No GL.

#include "tests/ui/ui_main.h"

#include "ui/kit/roomy_ticker.h"
#include "ui/study/study_chart.h"

#include <QFontMetricsF>
#include <QLabel>
#include <QScreen>
#include <QSplitter>
#include <QTransform>
#include <QVBoxLayout>
#include <QXmlStreamReader>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace vitrine::ui;

namespace {

/// Painted text with the rectangle of its ink.
struct PaintedText {
    QString words;
    QRectF place;
};

QTransform matrixOf(const QString& attribute)
{
    const qsizetype start = attribute.indexOf(QLatin1String("matrix("));
    if (start < 0) return {};
    const QStringList numbers = attribute.mid(start + 7).section(QLatin1Char(')'), 0, 0).split(QLatin1Char(','));
    if (numbers.size() != 6) return {};
    return {numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble(),
            numbers[3].toDouble(), numbers[4].toDouble(), numbers[5].toDouble()};
}

std::vector<PaintedText> textsIn(const QByteArray& svg)
{
    std::vector<PaintedText> texts;
    std::vector<QTransform> groups{QTransform()};
    QXmlStreamReader reader(svg);
    while (!reader.atEnd()) {
        reader.readNext();
        if (reader.isStartElement() && reader.name() == QLatin1String("g"))
            groups.push_back(matrixOf(reader.attributes().value("transform").toString()) * groups.back());
        if (reader.isEndElement() && reader.name() == QLatin1String("g")) groups.pop_back();
        if (!reader.isStartElement() || reader.name() != QLatin1String("text")) continue;
        const QXmlStreamAttributes all = reader.attributes();
        QFont font(all.value("font-family").toString().section(QLatin1Char(','), 0, 0).remove(QLatin1Char('\'')));
        font.setPixelSize(std::max(1, qRound(all.value("font-size").toDouble())));
        const QPointF at(all.value("x").toDouble(), all.value("y").toDouble());
        const QString words = reader.readElementText(QXmlStreamReader::IncludeChildElements);
        if (words.trimmed().isEmpty()) continue;
        const QRectF ink = QFontMetricsF(font).tightBoundingRect(words.trimmed());
        texts.push_back({words.trimmed(), groups.back().mapRect(ink.translated(at))});
    }
    return texts;
}

/// Range of costs and errors.
struct Ranges {
    const char* name;
    std::vector<double> costs, errors;
    bool modelErrors = false;
};

const std::vector<Ranges>& manyRanges()
{
    static const std::vector<Ranges> all{
        {"the report's", {60000, 61000, 62500, 64000, 65000}, {0.2, 0.1, 0.06, 0.03, 0}},
        {"the report's, both lines", {60000, 61000, 62500, 64000, 65000}, {0.2, 0.1, 0.06, 0.03, 0}, true},
        {"milliseconds", {3.1, 3.4, 4.9, 8.2, 15.7}, {0.081, 0.04, 0.019, 0.011, 0.0062}, true},
        {"one point", {17}, {0.0786}},
        {"one exact point", {17}, {0}},
        {"ten decades", {1e-4, 1e-2, 1, 1e3, 1e6}, {1, 1e-2, 1e-4, 1e-6, 1e-9}, true},
        {"large and alike", {1'000'000'000, 1'000'001'000, 1'000'002'000}, {0.5, 0.4999, 0.4998}},
        {"tiny", {1e-9, 2e-9, 3e-9}, {1e-12, 2e-12, 0}},
        {"equal costs", {5, 5, 5, 5}, {0.1, 0.2, 0.3, 0.4}},
        {"all exact", {1, 2, 3}, {0, 0, 0}, true},
        {"just a decade", {0.9, 3, 9.1}, {0.9, 0.3, 0.09}},
    };
    return all;
}

ChartedStudy studyOf(const Ranges& ranges)
{
    ChartedStudy study;
    study.costTitle = QStringLiteral("milliseconds of a picture, by a clock that is not trusted");
    study.errorTitle = QStringLiteral("RMS error of linear light");
    for (std::size_t i = 0; i < ranges.costs.size(); ++i) {
        ChartPoint p;
        p.cost = p.costLow = p.costHigh = ranges.costs[i];
        p.error = p.errorLow = p.errorHigh = ranges.errors[i];
        p.onFront = true;
        p.present = i == 1;
        p.knee = i == 2;
        if (ranges.modelErrors) p.modelError = ranges.errors[i] + 0.3 * ranges.errors[0] + 1e-3;
        p.text = QString::number(1 << (4 + i));
        study.points.push_back(p);
    }
    return study;
}

class ChartLabelsTest : public QObject {
    Q_OBJECT

private slots:
    void longNoTextLiesOverAnotherOrEndsBeyondTheEdge_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<double>("type");
        for (const QSize size : {QSize(320, 190), QSize(420, 240), QSize(560, 220), QSize(960, 540), QSize(1600, 900)})
            for (const double type : {1.0, 1.5, 2.0})
                QTest::addRow("%d x %d, type %.1f", size.width(), size.height(), type) << size << type;
    }
    void longNoTextLiesOverAnotherOrEndsBeyondTheEdge()
    {
        QFETCH(QSize, size);
        QFETCH(double, type);
        for (const Ranges& ranges : manyRanges()) {
            StudyChart chart;
            QFont font = chart.font();
            font.setPointSizeF(type * font.pointSizeF());
            chart.setFont(font);
            chart.showStudy(studyOf(ranges));
            const std::vector<PaintedText> texts = textsIn(chart.svg(size));
            QVERIFY2(texts.size() >= 3, ranges.name);  // At least two titles and a label.
            for (std::size_t i = 0; i < texts.size(); ++i) {
                QVERIFY2(QRectF(QPointF(0, 0), size).adjusted(-1, -1, 1, 1).contains(texts[i].place),
                         qPrintable(QStringLiteral("%1: “%2” ends beyond the edge")
                                        .arg(QLatin1String(ranges.name), texts[i].words)));
                for (std::size_t j = 0; j < i; ++j)
                    QVERIFY2(!texts[i].place.adjusted(1, 1, -1, -1).intersects(texts[j].place),
                             qPrintable(QStringLiteral("%1: “%2” over “%3”")
                                            .arg(QLatin1String(ranges.name), texts[i].words, texts[j].words)));
            }
        }
    }

    void anEmptyChartSaysWhyWithinItsEdges()
    {
        for (const QSize size : {QSize(320, 190), QSize(960, 540)}) {
            for (const double type : {1.0, 2.0}) {
                StudyChart chart;
                QFont font = chart.font();
                font.setPointSizeF(type * font.pointSizeF());
                chart.setFont(font);
                ChartedStudy study = studyOf(manyRanges().front());
                for (ChartPoint& p : study.points) p.cost = 0;
                study.emptyText =
                    QStringLiteral("3 of 9 settings are drawn.\nTheir work is compared when all of them are.");
                chart.showStudy(study);
                QStringList words;
                for (const PaintedText& text : textsIn(chart.svg(size))) {
                    QVERIFY2(QRectF(QPointF(0, 0), size).contains(text.place), qPrintable(text.words));
                    words << text.words;
                }
                QCOMPARE(words.join(QLatin1Char(' ')), study.emptyText.replace(QLatin1Char('\n'), QLatin1Char(' ')));
            }
        }
    }

    void aChartOfUsualSizeHasAScaleAndItsTitlesWhole()
    {
        for (const Ranges& ranges : manyRanges()) {
            StudyChart chart;
            const ChartedStudy study = studyOf(ranges);
            chart.showStudy(study);
            QStringList words;
            for (const PaintedText& text : textsIn(chart.svg(exportedChart))) words << text.words;
            QVERIFY2(words.contains(study.costTitle) && words.contains(study.errorTitle), ranges.name);
            for (QCPAxis* axis : {chart.xAxis, chart.yAxis}) {
                int shown = 0;
                for (const QString& label : axis->tickVectorLabels()) shown += words.contains(label) ? 1 : 0;
                QVERIFY2(shown >= 2, ranges.name);
            }
        }
    }

    void anotherTitleTakesThePlaceOfTheOld()
    {
        StudyChart chart;
        ChartedStudy study = studyOf(manyRanges().front());
        chart.showStudy(study);
        study.costTitle = QStringLiteral("samples in all views");
        chart.showStudy(study);
        QStringList words;
        for (const PaintedText& text : textsIn(chart.svg(exportedChart))) words << text.words;
        QCOMPARE(words.count(QStringLiteral("samples in all views")), 1);
        for (const QString& each : words) QVERIFY2(!each.contains("milliseconds"), qPrintable(each));
        // Also on the screen: the same as in a chart that never had the other content.
        StudyChart fresh;
        fresh.showStudy(study);
        for (StudyChart* each : {&chart, &fresh}) {
            each->setFocusPolicy(Qt::NoFocus);  // Its focus frame would be the only difference.
            each->resize(500, 240);
            each->show();
            QVERIFY(QTest::qWaitForWindowExposed(each));
        }
        QTest::qWait(50);
        QCOMPARE(chart.grab().toImage(), fresh.grab().toImage());
    }

    void nothingOfATitleStaysWhereTheChartWasLarger()
    {
        // Like in the panel of studies: the chart in a splitter above a text, which appears later and takes some of its
        // height.
        QWidget window;
        auto* split = new QSplitter(Qt::Horizontal, &window);
        auto* chart = new StudyChart;
        split->addWidget(chart);
        auto* words = new QLabel(&window);
        auto* column = new QVBoxLayout(&window);
        column->setSpacing(24);
        column->addWidget(split, 1);
        column->addWidget(words);
        window.resize(500, 300);
        chart->setFocusPolicy(Qt::NoFocus);
        chart->showStudy(studyOf(manyRanges().front()));
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QTest::qWait(50);
        const int before = chart->height();
        words->setText(QStringLiteral("One line\nand another\nand one more."));
        QTest::qWait(100);
        QVERIFY(chart->height() < before);
        const QImage onScreen = window.screen()->grabWindow(window.winId()).toImage();
        QVERIFY(!onScreen.isNull());
        QCOMPARE(onScreen.convertToFormat(QImage::Format_RGB32),
                 window.grab().toImage().convertToFormat(QImage::Format_RGB32));
    }

    void theSecondLineIsInTheLegendAndOnlyWhereItSaysMore()
    {
        const auto words = [](const ChartedStudy& study) {
            StudyChart chart;
            chart.showStudy(study);
            QStringList all;
            for (const PaintedText& text : textsIn(chart.svg(exportedChart))) all << text.words;
            return all;
        };
        ChartedStudy study = studyOf(manyRanges()[1]);
        QVERIFY(words(study).contains(QStringLiteral("against everything exact")));
        QVERIFY(words(study).contains(QStringLiteral("against this parameter exact")));
        QVERIFY(words(study).contains(QStringLiteral("exact in this parameter")));
        study.parameters = 2;
        QVERIFY(words(study).contains(QStringLiteral("exact in these parameters")));
        for (ChartPoint& p : study.points) p.modelError = p.error;  // Nothing else was inexact.
        QVERIFY(!words(study).contains(QStringLiteral("against everything exact")));
        for (ChartPoint& p : study.points) p.modelError.reset();
        QVERIFY(!words(study).contains(QStringLiteral("against everything exact")));
        QVERIFY(words(study).contains(QStringLiteral("exact")));
    }

    void intervalsOfTimesStandAtTheirPoints()
    {
        // Costs that do not grow with the index of the setting, each with its own interval.
        ChartedStudy study = studyOf(manyRanges()[2]);
        const std::vector<double> costs{181, 84, 138, 330, 761};
        for (std::size_t i = 0; i < costs.size(); ++i) {
            study.points[i].cost = costs[i];
            study.points[i].costLow = costs[i] * (0.9 - 0.1 * static_cast<double>(i));
            study.points[i].costHigh = costs[i] * (1.1 + 0.1 * static_cast<double>(i));
        }
        StudyChart chart;
        chart.showStudy(study);
        int found = 0;
        for (int i = 0; i < chart.plottableCount(); ++i) {
            const auto* bars = qobject_cast<QCPErrorBars*>(chart.plottable(i));
            if (bars == nullptr || bars->errorType() != QCPErrorBars::etKeyError) continue;
            QCOMPARE(bars->dataCount(), static_cast<int>(costs.size()));
            for (int k = 0; k < bars->dataCount(); ++k) {
                const double cost = bars->dataMainKey(k);
                const auto point = std::find_if(study.points.begin(), study.points.end(),
                                                [&](const ChartPoint& p) { return p.cost == cost; });
                QVERIFY(point != study.points.end());
                QCOMPARE(bars->data()->at(k).errorMinus, point->cost - point->costLow);
                QCOMPARE(bars->data()->at(k).errorPlus, point->costHigh - point->cost);
                ++found;
            }
        }
        QCOMPARE(found, static_cast<int>(costs.size()));
    }

    void numbersOfAxesAreShortAndSayWhatTheyAre()
    {
        QCOMPARE(axisNumber(0), QStringLiteral("0"));
        QCOMPARE(axisNumber(0.02), QStringLiteral("0.02"));
        QCOMPARE(axisNumber(3 * 0.1), QStringLiteral("0.3"));
        QCOMPARE(axisNumber(5000), QStringLiteral("5000"));
        QCOMPARE(axisNumber(60000), QStringLiteral("60\u202F000"));
        QCOMPARE(axisNumber(2e6), QStringLiteral("2·10⁶"));
        QCOMPARE(axisNumber(1e-5), QStringLiteral("10⁻⁵"));
        QCOMPARE(axisNumber(1.0005e9), QStringLiteral("1.0005·10⁹"));
    }
};

}  // namespace

VITRINE_UI_TEST(ChartLabelsTest)
#include "chart_labels_test.moc"
