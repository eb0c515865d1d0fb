#include "ui/kit/desktop_preferences.h"

#include <QDBusMessage>
#include <QDBusMetaType>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QFileInfo>
#include <QMap>
#include <QVariantMap>

namespace vitrine::ui {
namespace {

using Spaces = QMap<QString, QVariantMap>;

constexpr int longestWait = 60000;  // Milliseconds: the portal may have to be started first. Nothing waits for it.

const QString service = QStringLiteral("org.freedesktop.portal.Desktop");
const QString portalPath = QStringLiteral("/org/freedesktop/portal/desktop");
const QString interface = QStringLiteral("org.freedesktop.portal.Settings");
const QString appearance = QStringLiteral("org.freedesktop.appearance");
const QString gnome = QStringLiteral("org.gnome.desktop.interface");

bool hasSessionBus()
{
    return !qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS") ||
           QFileInfo::exists(qEnvironmentVariable("XDG_RUNTIME_DIR") + QStringLiteral("/bus"));
}

/// Removes the extra layers of variants in which some portals wrap a value.
QVariant bare(QVariant value)
{
    for (int i = 0; i < 4 && value.metaType() == QMetaType::fromType<QDBusVariant>(); ++i)
        value = value.value<QDBusVariant>().variant();
    return value;
}

}  // namespace

DesktopPortal::DesktopPortal(const QDBusConnection& bus, QObject* parent) : QObject(parent)
{
    ask(bus);
}

DesktopPortal::DesktopPortal(QObject* parent) : QObject(parent)
{
    if (hasSessionBus()) ask(QDBusConnection::sessionBus());
}

void DesktopPortal::ask(QDBusConnection bus)
{
    if (!bus.isConnected()) return;
    asks_ = true;
    qDBusRegisterMetaType<Spaces>();
    bus.connect(service, portalPath, interface, QStringLiteral("SettingChanged"), this,
                SLOT(take(QString, QString, QDBusVariant)));
    QDBusMessage question = QDBusMessage::createMethodCall(service, portalPath, interface, QStringLiteral("ReadAll"));
    question << QStringList{appearance, gnome};
    auto* answer = new QDBusPendingCallWatcher(bus.asyncCall(question, longestWait), this);
    connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
        answer->deleteLater();
        const QDBusPendingReply<Spaces> reply = *answer;
        // On an error there is no portal, or one with another interface.
        if (!reply.isError()) {
            const DesktopPreferences before = desktopPreferences_;
            const Spaces spaces = reply.value();
            for (auto space = spaces.begin(); space != spaces.end(); ++space)
                for (auto key = space->begin(); key != space->end(); ++key) note(space.key(), key.key(), key.value());
            decide(before);
        }
        emit answered();
    });
}

void DesktopPortal::take(const QString& space, const QString& key, const QDBusVariant& value)
{
    const DesktopPreferences before = desktopPreferences_;
    note(space, key, value.variant());
    decide(before);
}

void DesktopPortal::note(const QString& space, const QString& key, const QVariant& value)
{
    const QVariant said = bare(value);
    if (space == appearance && said.metaType() == QMetaType::fromType<uint>()) {
        const uint number = said.toUInt();
        if (key == QLatin1String("color-scheme"))
            desktopPreferences_.dark = number == 1   ? std::optional(true)
                                       : number == 2 ? std::optional(false)
                                                     : std::nullopt;
        if (key == QLatin1String("contrast")) desktopPreferences_.highContrast = number == 1;
        if (key == QLatin1String("reduced-motion")) motionReduced_ = number == 1;
    }
    if (space == gnome && key == QLatin1String("enable-animations") && said.metaType() == QMetaType::fromType<bool>())
        animationsOff_ = !said.toBool();
}

void DesktopPortal::decide(const DesktopPreferences& before)
{
    desktopPreferences_.reducedMotion = animationsOff_ || motionReduced_;
    if (!(desktopPreferences_ == before)) emit changed();
}

}  // namespace vitrine::ui

#include "moc_desktop_preferences.cpp"
