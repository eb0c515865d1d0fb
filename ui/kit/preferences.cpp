#include "ui/kit/preferences.h"

#include "ui/kit/ini_file.h"

#include "exhibits/framework/files/state_folder.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QKeySequence>
#include <QSettings>

#include <algorithm>
#include <array>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr qint64 largestFile = 1 << 20;  // Bytes; a valid file has a few hundred.
constexpr int mostKeys = 1000;           // Number of actions with shortcuts of the visitor's own.
constexpr int mostShortcuts = 4;         // Shortcuts of one action.
constexpr int longestShortcut = 60;      // Characters.
constexpr int mostControllers = 1000;    // Parameters with a control of their own.
constexpr int longestController = 200;   // Characters of a parameter's key, and of its control.

constexpr std::array themeNames{"desktop", "light", "dark", "highContrast"};
constexpr std::array motionNames{"desktop", "reduced", "full"};

struct NumberKey {
    const char* name;
    int PreferenceValues::*value;
    PreferenceRange range;
};
constexpr std::array<NumberKey, 7> numberKeys{
    {{"typeSize", &PreferenceValues::typeSize, PreferenceValues::typeSizes},
     {"lookSpeed", &PreferenceValues::lookSpeed, PreferenceValues::lookSpeeds},
     {"wheelSpeed", &PreferenceValues::wheelSpeed, PreferenceValues::wheelSpeeds},
     {"mostSamples", &PreferenceValues::mostSamples, PreferenceValues::sampleLimits},
     {"leastScale", &PreferenceValues::leastScale, PreferenceValues::movingScales},
     {"recentCount", &PreferenceValues::recentFiles, PreferenceValues::recentCounts},
     {"oscPort", &PreferenceValues::oscPort, PreferenceValues::oscPorts}}};

struct SwitchKey {
    const char* name;
    bool PreferenceValues::*value;
};
constexpr std::array<SwitchKey, 2> switchKeys{
    {{"invertedLook", &PreferenceValues::invertedLook}, {"midi", &PreferenceValues::midi}}};

const QString controllersGroup = QStringLiteral("controllers");

QString filePath()
{
    return QString::fromStdString((configFolder() / "window.ini").string());
}

/// Returns why the file cannot be a preferences file; empty if it may be one, or does not exist.
QString damage(const QString& path)
{
    QFile file(path);
    if (!file.exists()) return {};
    if (!QFileInfo(path).isFile()) return Preferences::tr("it is no file");
    if (file.size() > largestFile) return Preferences::tr("it is too large");
    if (!file.open(QIODevice::ReadOnly)) return file.errorString();
    // All valid values are texts and numbers. These markers would have Qt make objects of bytes that are not trusted.
    const QByteArray bytes = file.read(largestFile + 1);
    for (const char* maker : {"@Variant(", "@DateTime("})
        if (bytes.contains(maker)) return Preferences::tr("it contains unknown preferences");
    if (bytes.contains('\0')) return Preferences::tr("it is no text");
    const QSettings settings(iniPath(path), QSettings::IniFormat);
    (void)settings.allKeys();
    return settings.status() == QSettings::FormatError ? Preferences::tr("it is not in the format of preferences")
                                                       : QString();
}

template <typename Choice, std::size_t count>
void readChoice(const QSettings& settings, const char* key, const std::array<const char*, count>& names, Choice& value,
                QStringList& wrong)
{
    if (!settings.contains(QLatin1String(key))) return;
    const QString saved = settings.value(QLatin1String(key)).toString();
    for (std::size_t i = 0; i < count; ++i)
        if (saved == QLatin1String(names[i])) {
            value = static_cast<Choice>(i);
            return;
        }
    wrong << QLatin1String(key);
}

void readNumber(const QSettings& settings, const NumberKey& key, PreferenceValues& values, QStringList& wrong)
{
    if (!settings.contains(QLatin1String(key.name))) return;
    bool isNumber = false;
    const int number = settings.value(QLatin1String(key.name)).toString().toInt(&isNumber);
    if (isNumber && number >= key.range.least && number <= key.range.most)
        values.*key.value = number;
    else
        wrong << QLatin1String(key.name);
}

void readSwitch(const QSettings& settings, const SwitchKey& key, PreferenceValues& values, QStringList& wrong)
{
    if (!settings.contains(QLatin1String(key.name))) return;
    const QString saved = settings.value(QLatin1String(key.name)).toString();
    values.*key.value = saved == QLatin1String("true");
    if (saved != QLatin1String("true") && saved != QLatin1String("false")) wrong << QLatin1String(key.name);
}

bool isShortcut(const QString& text)
{
    if (text.size() > longestShortcut) return false;
    const QKeySequence keys = QKeySequence::fromString(text, QKeySequence::PortableText);
    for (int i = 0; i < keys.count(); ++i)
        if (keys[static_cast<uint>(i)].key() == Qt::Key_unknown) return false;
    return keys.count() == 1;
}

void readKeys(QSettings& settings, PreferenceValues& values, QStringList& wrong)
{
    settings.beginGroup(QStringLiteral("keys"));
    for (const QString& id : settings.childKeys().mid(0, mostKeys)) {
        QStringList shortcuts = settings.value(id).toStringList();
        shortcuts.removeAll(QString());
        const bool good =
            shortcuts.size() <= mostShortcuts && std::all_of(shortcuts.begin(), shortcuts.end(), isShortcut);
        if (good)
            values.keys.insert(id, shortcuts);
        else
            wrong << QStringLiteral("keys/") + id.left(longestShortcut);
    }
    settings.endGroup();
}

void readControllers(QSettings& settings, PreferenceValues& values, QStringList& wrong)
{
    settings.beginGroup(controllersGroup);
    for (const QString& key : settings.allKeys().mid(0, mostControllers)) {
        const QString control = settings.value(key).toString();
        if (key.size() <= longestController && !control.isEmpty() && control.size() <= longestController)
            values.controllers.insert(key, control);
        else
            wrong << controllersGroup + QLatin1Char('/') + key.left(longestController);
    }
    settings.endGroup();
}

PreferenceValues readFrom(const QString& path, QStringList& wrong)
{
    PreferenceValues values;
    QSettings settings(iniPath(path), QSettings::IniFormat);
    readChoice(settings, "theme", themeNames, values.theme, wrong);
    readChoice(settings, "motion", motionNames, values.motion, wrong);
    for (const NumberKey& key : numberKeys) readNumber(settings, key, values, wrong);
    for (const SwitchKey& key : switchKeys) readSwitch(settings, key, values, wrong);
    readKeys(settings, values, wrong);
    readControllers(settings, values, wrong);
    return values;
}

/// Writes the controllers that differ from those before, and no others.
void writeControllers(QSettings& settings, const QMap<QString, QString>& before, const QMap<QString, QString>& now)
{
    settings.beginGroup(controllersGroup);
    for (auto entry = before.begin(); entry != before.end(); ++entry)
        if (!now.contains(entry.key())) settings.remove(entry.key());
    for (auto entry = now.begin(); entry != now.end(); ++entry)
        if (before.value(entry.key()) != entry.value()) settings.setValue(entry.key(), entry.value());
    settings.endGroup();
}

PreferenceValues within(PreferenceValues values)
{
    for (const NumberKey& key : numberKeys)
        values.*key.value = std::clamp(values.*key.value, key.range.least, key.range.most);
    return values;
}

}  // namespace

Preferences::Preferences(QObject* parent) : QObject(parent)
{
    read();
}

void Preferences::read()
{
    const QString path = filePath();
    if (const QString why = damage(path); !why.isEmpty()) {
        const QString aside = path + QStringLiteral(".damaged");
        QFile::remove(aside);
        complaint_ =
            QFile::rename(path, aside)
                ? tr("The preferences in %1 could not be read: %2. They were reset to their defaults; the file was "
                     "kept as %3.")
                      .arg(path, why, aside)
                : tr("The preferences in %1 could not be read: %2. They were reset to their defaults.").arg(path, why);
        return;
    }
    QStringList wrong;
    values_ = readFrom(path, wrong);
    wrong_ = wrong;
    if (wrong.isEmpty()) return;
    constexpr int mostNamed = 5;
    const QString names = wrong.mid(0, mostNamed).join(QStringLiteral(", ")) +
                          (wrong.size() > mostNamed ? QStringLiteral(", …") : QString());
    complaint_ = tr("Some preferences in %1 are invalid and were reset to their defaults: %2. You can set them in Edit "
                    "> Preferences.")
                     .arg(path, names);
}

PreferenceValues Preferences::saved()
{
    QStringList ignored;
    const QString path = filePath();
    return damage(path).isEmpty() ? readFrom(path, ignored) : PreferenceValues();
}

void Preferences::set(PreferenceValues values)
{
    values = within(std::move(values));
    if (values == values_) return;
    const PreferenceValues before = std::exchange(values_, std::move(values));
    write(before);
    emit changed(before);
    if (!failure_.isEmpty()) emit notWritten(failure_);
}

void Preferences::write(const PreferenceValues& before)
{
    const QString path = filePath();
    QDir().mkpath(QFileInfo(path).path());
    QSettings settings(iniPath(path), QSettings::IniFormat);
    // Initial values are not written, so that a later version may change them.
    const PreferenceValues initial;
    // QSettings locks the file, reads it again and changes only these keys.
    const auto keep = [&](const QString& key, const QVariant& value, bool changes, bool differs) {
        if (!changes && !wrong_.contains(key)) return;
        if (differs)
            settings.setValue(key, value);
        else
            settings.remove(key);
    };
    keep(QStringLiteral("theme"), QLatin1String(themeNames[static_cast<std::size_t>(values_.theme)]),
         values_.theme != before.theme, values_.theme != initial.theme);
    keep(QStringLiteral("motion"), QLatin1String(motionNames[static_cast<std::size_t>(values_.motion)]),
         values_.motion != before.motion, values_.motion != initial.motion);
    for (const NumberKey& key : numberKeys)
        keep(QLatin1String(key.name), values_.*key.value, values_.*key.value != before.*key.value,
             values_.*key.value != initial.*key.value);
    for (const SwitchKey& key : switchKeys)
        keep(QLatin1String(key.name), values_.*key.value, values_.*key.value != before.*key.value, values_.*key.value);
    const QString group = QStringLiteral("keys/");
    for (const QString& wrong : std::as_const(wrong_))
        if (wrong.contains(QLatin1Char('/'))) settings.remove(wrong);
    writeControllers(settings, before.controllers, values_.controllers);
    for (auto key = before.keys.begin(); key != before.keys.end(); ++key)
        if (!values_.keys.contains(key.key())) settings.remove(group + key.key());
    for (auto key = values_.keys.begin(); key != values_.keys.end(); ++key)
        if (!before.keys.contains(key.key()) || before.keys.value(key.key()) != key.value())
            // QSettings would write an empty list as a serialized object.
            settings.setValue(group + key.key(), key.value().isEmpty() ? QVariant(QString()) : QVariant(key.value()));
    settings.sync();
    wrong_.clear();
    failure_ = settings.status() == QSettings::NoError
                   ? QString()
                   : tr("The preferences could not be saved to %1. They are kept until the program ends.").arg(path);
}

}  // namespace vitrine::ui

#include "moc_preferences.cpp"
