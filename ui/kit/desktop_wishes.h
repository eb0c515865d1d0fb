#pragma once

#include <QDBusConnection>
#include <QDBusVariant>
#include <QObject>

#include <optional>

namespace vitrine::ui {

/// What the desktop's settings ask of all programs, as far as it says.
struct DesktopWishes {
    std::optional<bool> dark;  ///< Empty: it has no preference, or does not say.
    bool highContrast = false;
    bool reducedMotion = false;  ///< Things should not move by themselves.

    bool operator==(const DesktopWishes&) const = default;
};

/// Asks the desktop's portal (xdg-desktop-portal, interface Settings) what it wishes, and goes on listening. Until it
/// answers, and where there is none, nothing is wished; nobody waits for it.
class DesktopPortal final : public QObject {
    Q_OBJECT

public:
    explicit DesktopPortal(const QDBusConnection& bus, QObject* parent = nullptr);
    /// On the bus of the session; without one it is not looked for, which would start one.
    explicit DesktopPortal(QObject* parent = nullptr);

    [[nodiscard]] const DesktopWishes& wishes() const { return wishes_; }
    /// There is a bus, and the portal was asked.
    [[nodiscard]] bool asks() const { return asks_; }

signals:
    void changed();
    /// The first question was answered, if only by a refusal.
    void answered();

private slots:
    void take(const QString& space, const QString& key, const QDBusVariant& value);

private:
    void ask(QDBusConnection bus);
    void note(const QString& space, const QString& key, const QVariant& value);
    /// Says what is another wish than before.
    void decide(const DesktopWishes& before);

    DesktopWishes wishes_;
    bool asks_ = false;
    // What the portal said: the wish for less motion has an old and a new name.
    bool animationsOff_ = false;
    bool motionReduced_ = false;
};

}  // namespace vitrine::ui
