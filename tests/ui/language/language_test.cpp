// German translation: complete, with equal placeholders and mnemonics, and selected by the locale or the visitor.

#include "tests/ui/ui_main.h"

#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/time/animation.h"
#include "ui/kit/language.h"
#include "ui/kit/numbers.h"
#include "ui/parameters/shown_text.h"
#include "ui/viewport/draw_schedule.h"

#include "exhibits/exhibits.h"
#include "exhibits/framework/table/value_text.h"
#include "exhibits/museum/museum.h"
#include "render/text/translation.h"
#include "tests/ui/patience.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <set>

using namespace vitrine;

namespace {

/// Returns the exhibits whose German texts are tested.
std::vector<std::unique_ptr<Exhibit>> completeExhibits()
{
    auto exhibits = allExhibits();
    std::erase_if(exhibits, [](const auto& exhibit) { return !exhibit->isComplete(); });
    return exhibits;
}

struct CatalogEntry {
    QString source, comment;
    QStringList translations;  ///< Two for texts with numbers.
    bool finished = true;
};

QList<CatalogEntry> messagesOfTheFile()
{
    QFile file(QStringLiteral(VITRINE_SOURCE_DIR "/assets/translations/vitrine_de.ts"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QXmlStreamReader xml(&file);
    QList<CatalogEntry> all;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("message")) all << CatalogEntry{};
        if (xml.name() == QLatin1String("source")) all.last().source = xml.readElementText();
        if (xml.name() == QLatin1String("comment")) all.last().comment = xml.readElementText();
        if (xml.name() == QLatin1String("translation")) {
            all.last().finished = xml.attributes().value(QLatin1String("type")).isEmpty();
            QString text;
            while (xml.readNext() != QXmlStreamReader::EndElement && !xml.atEnd()) {
                // One for each plural form.
                if (xml.isStartElement()) all.last().translations << xml.readElementText();
                if (xml.isCharacters()) text += xml.text();
            }
            if (!text.trimmed().isEmpty()) all.last().translations << text;
        }
    }
    return xml.hasError() ? QList<CatalogEntry>{} : all;
}

/// Returns the placeholders "%1", "%n", "{1}" as often as they occur; "{=1}" counts as "{1}".
QStringList placesOf(QString text)
{
    text.replace(QStringLiteral("{="), QStringLiteral("{"));
    QStringList found;
    static const QRegularExpression place(QStringLiteral("%(\\d|n\\b|L\\d)|\\{\\d\\}"));
    for (auto match = place.globalMatch(text); match.hasNext();) found << match.next().captured();
    found.sort();
    return found;
}

qsizetype mnemonicsOf(QString text)
{
    static const QRegularExpression mark(QStringLiteral("&(?=\\w)"));
    return text.remove(QStringLiteral("&&")).count(mark);
}

/// Returns all texts of a table for people.
std::set<std::string> textsOf(const Parameters& table)
{
    std::set<std::string> texts;
    for (const ParameterInfo& parameter : table.rows()) {
        texts.insert(
            {label(parameter), labelInGroup(parameter), std::string(parameter.group), std::string(parameter.help)});
        for (const std::string_view choice : parameter.choices) texts.emplace(choice);
        for (const Word& word : parameter.words) texts.emplace(word.text);
    }
    texts.erase("");
    return texts;
}

/// Returns whether a text contains a short English word that German does not have.
bool englishIn(const QString& text)
{
    static const QRegularExpression small(
        QStringLiteral(
            "\\b(the|of|is|are|give|with|from|and|for|this|that|it|its|between|which|by|no|or|when|not|has)\\b"),
        QRegularExpression::CaseInsensitiveOption);
    return text.contains(small);
}

std::set<std::string> knownTexts()
{
    std::set<std::string> known;
    for (const CatalogEntry& message : messagesOfTheFile()) known.insert(message.source.toStdString());
    return known;
}

}  // namespace

class LanguageTest final : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { ui::setLanguage(QStringLiteral("en")); }

    void everyMessageIsFinishedWithTheSamePlacesAndMnemonics()
    {
        const QList<CatalogEntry> all = messagesOfTheFile();
        QVERIFY(all.size() > 2000);
        for (const CatalogEntry& message : all) {
            QVERIFY2(message.finished, qPrintable(message.source));
            QVERIFY2(!message.translations.isEmpty(), qPrintable(message.source));
            for (const QString& translation : message.translations) {
                QVERIFY2(!translation.isEmpty(), qPrintable(message.source));
                QVERIFY2(placesOf(translation) == placesOf(message.source), qPrintable(translation));
                QVERIFY2(mnemonicsOf(translation) == mnemonicsOf(message.source), qPrintable(translation));
            }
        }
    }

    void everyTextOfTheTablesHasAGermanOne()
    {
        const std::set<std::string> known = knownTexts();
        const Museum museum{completeExhibits()};
        for (const SceneObject* subject : museum.subjects()) {
            std::set<std::string> texts = textsOf(subject->parameters());
            texts.emplace(subject->title());
            texts.emplace(subject->summary());
            for (const std::string& text : texts) QVERIFY2(known.count(text) == 1, text.c_str());
        }
        for (const auto& [index, exhibit] : museum.exhibits()) {
            const std::string advice = "Try: " + std::string(exhibit.tryThis());
            QVERIFY2(exhibit.tryThis().empty() || known.count(advice) == 1, advice.c_str());
            if (const auto* button = capability<HasButton>(exhibit)) {
                const std::string line = "E – " + std::string(button->buttonText());
                QVERIFY2(known.count(line) == 1, line.c_str());
            }
        }
    }

    void reasonsOfTheFrameReportAreGerman()
    {
        ui::setLanguage(QStringLiteral("de"));
        const Museum museum{completeExhibits()};
        const SceneState initial = museum.initialSceneState();
        std::set<std::string> english;
        for (std::size_t i = 0; i < museum.subjects().size(); ++i) {
            FrameRequest request;
            request.raster.size = {64, 48};
            request.camera = museum.bestView(i, initial.values[i]);
            const Prepared prepared = museum.prepare(initial, request);
            const render::FramePlan plan = museum.plan(prepared, request);
            for (const render::Pass& pass : plan.passes())
                if (translated(pass.reason) == pass.reason) english.insert(pass.name + ": " + pass.reason);
            for (const render::CulledPass& pass : plan.skipped())
                if (translated(pass.reason) == pass.reason) english.insert(pass.name + ": " + pass.reason);
        }
        QString all;
        for (const std::string& reason : english) all += QString::fromStdString(reason) + QLatin1Char('\n');
        QVERIFY2(english.empty(), qPrintable(all));
    }

    void aSentenceWithPlacesIsTranslatedAsAWhole()
    {
        ui::setLanguage(QStringLiteral("de"));
        static const QRegularExpression place(QStringLiteral("\\{=?(\\d)\\}"));
        const auto filled = [](QString text) { return text.replace(place, QStringLiteral("x\\1")); };
        int sentences = 0;
        for (const CatalogEntry& message : messagesOfTheFile()) {
            if (!message.source.contains(place) || message.translations.size() != 1) continue;
            ++sentences;
            QCOMPARE(ui::translatedText(filled(message.source).toStdString()), filled(message.translations.front()));
        }
        QVERIFY(sentences > 300);
    }

    void aTextWithAnUnknownPartStaysEnglish()
    {
        ui::setLanguage(QStringLiteral("de"));
        for (const char* text :
             {"moving: 50% of full resolution", "\"0,3\" is not a value for it; give a number from 0 to 1.",
              "study nope: sdf_morph has no such parameter; give one of bounces, hitTolerance."}) {
            const QString shown = ui::translatedText(text);
            QVERIFY2(shown == QString::fromUtf8(text) || !englishIn(shown), qPrintable(shown));
        }
    }

    void whatTheWindowPutsTogetherIsGermanAsAWhole()
    {
        ui::setLanguage(QStringLiteral("de"));
        const Museum museum{completeExhibits()};
        QStringList halves;
        const auto check = [&halves](const QString& text) {
            if (englishIn(text)) halves << text;
        };
        for (const SceneObject* subject : museum.subjects()) {
            const ParameterValues values = subject->parameters().initial();
            for (std::size_t i = 0; i < values.rows().size(); ++i) {
                const ParameterInfo& row = values.rows()[i];
                check(ui::tooltipText(row));
                check(QString::fromStdString(actsWhen(values, i)));
                if (row.isWritten()) continue;
                for (const char* typed : {"banana", "1 2", "", "1e99", "-1e99"}) {
                    QString problem;
                    static_cast<void>(ui::typedValue(row, QString::fromUtf8(typed), &problem));
                    check(problem);
                }
                check(ui::translatedText(whyUnmoved(row)));
                if (!whyUnmoved(row).empty()) continue;
                Motion motion;
                motion.from = motion.to = row.initial;
                for (const MotionKind kind :
                     {MotionKind::sine, MotionKind::ease, MotionKind::noise, MotionKind::distance}) {
                    motion.kind = kind;
                    check(ui::translatedText(describe(row, motion)));
                }
            }
        }
        ui::DrawSchedule schedule;
        for (double now = 0; now < 10; now += 0.1) {
            check(schedule.reason());
            if (const auto order = schedule.next(now)) {
                schedule.begun(*order);
                schedule.drawn(*order, 0.01);
            }
        }
        QVERIFY(schedule.still());
        schedule.setLimits(1, 1);
        check(schedule.reason());
        QVERIFY2(halves.isEmpty(), qPrintable(halves.join(QLatin1Char('\n'))));
    }

    void theLightThemeIsBrightAndNoLamp()
    {
        ui::setLanguage(QStringLiteral("de"));
        QCOMPARE(QObject::tr("Light", "theme"), QStringLiteral("Hell"));
        QCOMPARE(QObject::tr("Light"), QStringLiteral("Licht"));
    }

    void numbersHaveTheDecimalSignOfTheLanguage()
    {
        const Museum museum{completeExhibits()};
        const ParameterValues hall = museum.initialSceneState().hall();
        for (const char* code : {"en", "de"}) {
            ui::setLanguage(QString::fromLatin1(code));
            const bool german = ui::languageCode() == QLatin1String("de");
            const QString half = german ? QStringLiteral("0,5") : QStringLiteral("0.5");
            QCOMPARE(ui::numberLocale().toString(0.5, 'f', 1), half);
            for (std::size_t i = 0; i < hall.rows().size(); ++i) {
                const ParameterInfo& row = hall.rows()[i];
                if (row.kind != Kind::real) continue;
                // The text for editing can be read back, with either decimal sign.
                const QString shown = ui::editedText(row, row.initial);
                QVERIFY2(!german || !shown.contains(QLatin1Char('.')), qPrintable(shown));
                for (QString typed : {shown, QString(shown).replace(QLatin1Char(','), QLatin1Char('.'))}) {
                    const auto read = ui::typedValue(row, typed);
                    QVERIFY2(read && *read == row.initial, qPrintable(typed));
                }
                QCOMPARE(ui::exactText(row, row.initial), QString::fromStdString(formatValue(row, row.initial)));
            }
        }
    }

    void theLocaleChoosesUnlessTheVisitorDid()
    {
        const QTemporaryDir home;
        for (const char* name : {"HOME", "XDG_CONFIG_HOME"}) qputenv(name, home.path().toLocal8Bit());
        for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) qunsetenv(name);
        QCOMPARE(ui::languageOfWindow(), QStringLiteral("en"));
        qputenv("LANG", "de_AT.UTF-8");
        QCOMPARE(ui::languageOfWindow(), QStringLiteral("de"));
        qputenv("LC_MESSAGES", "fr_FR");
        QCOMPARE(ui::languageOfWindow(), QStringLiteral("en"));
        qputenv("LC_ALL", "de");
        QCOMPARE(ui::languageOfWindow(), QStringLiteral("de"));
        ui::keepLanguage(QStringLiteral("en"));
        QCOMPARE(ui::languageOfWindow(), QStringLiteral("en"));
        QCOMPARE(ui::savedLanguage(), QStringLiteral("en"));
        ui::keepLanguage({});
        QCOMPARE(ui::savedLanguage(), QString());
        QCOMPARE(ui::languageOfWindow(), QStringLiteral("de"));
        qputenv("LC_ALL", "C.UTF-8");
        QCOMPARE(ui::languageOfWindow(), QStringLiteral("en"));
    }

    void aLanguageIsSpokenAtOnceAndAnUnknownOneIsEnglish()
    {
        ui::setLanguage(QStringLiteral("de"));
        QCOMPARE(ui::languageCode(), QStringLiteral("de"));
        QCOMPARE(ui::translatedText("Shadow method"), QStringLiteral("Schattenverfahren"));
        QCOMPARE(ui::midSentence(ui::translatedText("Roughness")), QStringLiteral("Rauheit"));
        QCOMPARE(QObject::tr("&File"), QStringLiteral("&Datei"));
        ui::setLanguage(QStringLiteral("xx"));
        QCOMPARE(ui::languageCode(), QStringLiteral("en"));
        QCOMPARE(ui::translatedText("Shadow method"), QStringLiteral("Shadow method"));
        QCOMPARE(ui::midSentence(ui::translatedText("Roughness")), QStringLiteral("roughness"));
        QCOMPARE(QObject::tr("&File"), QStringLiteral("&File"));
    }
};

VITRINE_UI_TEST(LanguageTest)
#include "language_test.moc"
