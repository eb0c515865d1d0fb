#include "ui/kit/language.h"

#include "exhibits/framework/files/state_folder.h"
#include "render/text/translation.h"
#include "ui/kit/ini_file.h"
#include "ui/kit/text.h"

#include <QCoreApplication>
#include <QFile>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

#include <memory>

// Qt requires this outside of any namespace. Without it the linker drops the resources of the library.
static void initializeTranslations()
{
    Q_INIT_RESOURCE(translations);
}

namespace vitrine::ui {
namespace {

constexpr const char* context = "vitrine";

/// Translator with one context for all texts: equal texts have equal translations, whatever class shows them.
class OneContext final : public QTranslator {
public:
    using QTranslator::QTranslator;

    [[nodiscard]] QString translate(const char* asked, const char* source, const char* disambiguation,
                                    int n) const override
    {
        // Qt translates the names of keys: "Shift" is also an operation on shapes.
        if (QLatin1String(asked) == QLatin1String("QShortcut")) return {};
        return QTranslator::translate(context, source, disambiguation, n);  // Empty if there is no entry.
    }
};

struct CurrentLanguage {
    QString code = QStringLiteral("en");
    bool asked = false;
    std::unique_ptr<QTranslator> ours, qts;
};

CurrentLanguage& currentLanguage()
{
    static CurrentLanguage now;
    return now;
}

QSettings languageSettings()
{
    return QSettings(iniPath(QString::fromStdString((configFolder() / "window.ini").string())), QSettings::IniFormat);
}

QString languageKey()
{
    return QStringLiteral("language");
}

QString resource(const QString& code, const char* ending)
{
    return QStringLiteral(":/translations/vitrine_%1.%2").arg(code, QLatin1String(ending));
}

/// Returns the translator of a language; null for English and for unknown languages.
std::unique_ptr<QTranslator> translatorFor(const QString& code)
{
    initializeTranslations();
    auto translator = std::make_unique<OneContext>();
    if (code == QLatin1String("en") || !languages().contains(code) || !translator->load(resource(code, "qm")))
        return nullptr;
    return translator;
}

/// Returns the translations of texts of the lower layers, or null. The texts are listed in a file beside the
/// translator's.
std::shared_ptr<const Catalog> catalogOf(const QString& code, const QTranslator& translator)
{
    QFile list(resource(code, "txt"));
    if (!list.open(QIODevice::ReadOnly)) return nullptr;
    Catalog::Entries entries;
    for (const QByteArray& line : list.readAll().split('\n')) {
        if (line.isEmpty()) continue;
        QByteArray english = line;
        english.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&apos;", "'");
        english.replace("&amp;", "&");
        const QString translation = translator.translate(context, english.constData(), nullptr, -1);
        if (!translation.isEmpty()) entries.emplace_back(english.toStdString(), translation.toStdString());
    }
    return std::make_shared<const Catalog>(std::move(entries));
}

}  // namespace

const QStringList& languages()
{
    static const QStringList all{QStringLiteral("en"), QStringLiteral("de")};
    return all;
}

QString nameOfLanguage(const QString& code)
{
    if (code == QLatin1String("en")) return QStringLiteral("English");
    return code == QLatin1String("de") ? QStringLiteral("Deutsch") : QString();
}

QString languageOfLocale()
{
    for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const QString value = qEnvironmentVariable(variable);
        if (value.isEmpty()) continue;
        const QString code = value.section(QLatin1Char('.'), 0, 0).section(QLatin1Char('_'), 0, 0).toLower();
        return languages().contains(code) ? code : QStringLiteral("en");
    }
    return QStringLiteral("en");
}

QString savedLanguage()
{
    const QString saved = languageSettings().value(languageKey()).toString();
    return languages().contains(saved) ? saved : QString();
}

void keepLanguage(const QString& code)
{
    QSettings kept = languageSettings();
    if (code.isEmpty())
        kept.remove(languageKey());
    else
        kept.setValue(languageKey(), code);
}

QString languageOfWindow()
{
    const QString saved = savedLanguage();
    return saved.isEmpty() ? languageOfLocale() : saved;
}

void setLanguage(const QString& code)
{
    CurrentLanguage& now = currentLanguage();
    now.asked = true;
    for (auto* old : {&now.ours, &now.qts})
        if (*old) {
            QCoreApplication::removeTranslator(old->get());
            old->reset();
        }
    now.ours = translatorFor(code);
    now.code = now.ours ? code : QStringLiteral("en");
    vitrine::setLanguage(now.code.toStdString(), now.ours ? catalogOf(code, *now.ours) : nullptr);
    QLocale::setDefault(now.ours ? QLocale(code) : QLocale::system());  // For dates and for numbers in input fields.
    if (!now.ours || !QCoreApplication::instance()) return;
    auto qts = std::make_unique<QTranslator>();
    if (qts->load(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        now.qts = std::move(qts);
        QCoreApplication::installTranslator(now.qts.get());
    }
    QCoreApplication::installTranslator(now.ours.get());  // Installed last, so that it is searched first.
}

QString languageCode()
{
    return currentLanguage().code;
}

bool languageAsked()
{
    return currentLanguage().asked;
}

QString translatedText(const Message& message)
{
    return text(translated(message));
}

QString midSentence(const QString& name)
{
    return currentLanguage().code == QLatin1String("en") ? name.toLower() : name;
}

std::string translatedInLocale(const Message& message)
{
    const QString code = currentLanguage().code == QLatin1String("en") ? languageOfLocale() : currentLanguage().code;
    const std::unique_ptr<QTranslator> translator = translatorFor(code);
    const std::shared_ptr<const Catalog> texts = translator ? catalogOf(code, *translator) : nullptr;
    return texts ? texts->translated(message) : message.english();
}

}  // namespace vitrine::ui
