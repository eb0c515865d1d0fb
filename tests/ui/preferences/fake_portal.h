#pragma once

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusMetaType>
#include <QDBusVariant>
#include <QDBusVirtualObject>
#include <QMap>
#include <QProcess>
#include <QVariantMap>

#include <atomic>

namespace vitrine::test {

/// Private message bus while the object exists.
class PrivateBus {
public:
    PrivateBus()
    {
        daemon_.setProgram(QStringLiteral("dbus-daemon"));
        daemon_.setArguments({QStringLiteral("--session"), QStringLiteral("--nofork"), QStringLiteral("--nopidfile"),
                              QStringLiteral("--print-address=1")});
        daemon_.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        daemon_.start();
        if (daemon_.waitForStarted() && daemon_.waitForReadyRead())
            address_ = QString::fromUtf8(daemon_.readLine()).trimmed();
    }
    ~PrivateBus()
    {
        daemon_.terminate();
        daemon_.waitForFinished();
    }
    PrivateBus(const PrivateBus&) = delete;
    PrivateBus& operator=(const PrivateBus&) = delete;

    /// Returns the address; empty if there is no dbus-daemon.
    [[nodiscard]] const QString& address() const { return address_; }

private:
    QProcess daemon_;
    QString address_;
};

/// Desktop portal with the interface for settings.
class FakePortal final : public QDBusVirtualObject {
public:
    using Spaces = QMap<QString, QVariantMap>;

    explicit FakePortal(QDBusConnection bus) : bus_(std::move(bus))
    {
        qDBusRegisterMetaType<Spaces>();
        bus_.registerVirtualObject(path, this);
        bus_.registerService(QStringLiteral("org.freedesktop.portal.Desktop"));
    }
    ~FakePortal() override
    {
        bus_.unregisterService(QStringLiteral("org.freedesktop.portal.Desktop"));
        bus_.unregisterObject(path);
    }

    Spaces settings;
    bool answersNonsense = false;
    bool silent = false;
    int asked = 0;

    void change(const QString& space, const QString& key, const QVariant& value)
    {
        settings[space][key] = value;
        QDBusMessage signal = QDBusMessage::createSignal(path, interface, QStringLiteral("SettingChanged"));
        signal << space << key << QVariant::fromValue(QDBusVariant(value));
        bus_.send(signal);
    }
    [[nodiscard]] QString introspect(const QString&) const override { return {}; }
    bool handleMessage(const QDBusMessage& message, const QDBusConnection& bus) override
    {
        if (message.member() != QLatin1String("ReadAll")) return false;
        ++asked;
        if (silent) return true;
        bus.send(answersNonsense ? message.createReply(QStringLiteral("nonsense"))
                                 : message.createReply(QVariant::fromValue(settings)));
        return true;
    }

    static inline const QString appearance = QStringLiteral("org.freedesktop.appearance");
    static inline const QString gnome = QStringLiteral("org.gnome.desktop.interface");

private:
    static inline const QString path = QStringLiteral("/org/freedesktop/portal/desktop");
    static inline const QString interface = QStringLiteral("org.freedesktop.portal.Settings");

    QDBusConnection bus_;
};

}  // namespace vitrine::test
