#pragma once

#include <QDBusConnection>
#include <QDBusVariant>
#include <QObject>

#include <optional>

namespace vitrine::ui {

/// Settings of the desktop that apply to all programs.
struct DesktopPreferences {
    std::optional<bool> dark;  ///< Dark color scheme. Unset: no preference, or not known.
    bool highContrast = false;
    bool reducedMotion = false;  ///< Animations should be reduced.

    bool operator==(const DesktopPreferences&) const = default;
};

/// Reads the desktop's settings from its portal (xdg-desktop-portal, interface Settings) and follows their changes.
/// Until the portal answers, and without one, all settings are the defaults. Does not block.
class DesktopPortal final : public QObject {
    Q_OBJECT

public:
    explicit DesktopPortal(const QDBusConnection& bus, QObject* parent = nullptr);
    /// Uses the session bus. Without a running session bus no portal is looked for, because that would start one.
    explicit DesktopPortal(QObject* parent = nullptr);

    [[nodiscard]] const DesktopPreferences& desktopPreferences() const { return desktopPreferences_; }
    /// Returns whether there is a bus and the portal was asked.
    [[nodiscard]] bool asks() const { return asks_; }

signals:
    void changed();
    /// Emitted when the portal has answered the first query, even with an error.
    void answered();

private slots:
    void take(const QString& space, const QString& key, const QDBusVariant& value);

private:
    void ask(QDBusConnection bus);
    void note(const QString& space, const QString& key, const QVariant& value);
    /// Updates `desktopPreferences()` and emits `changed` if they differ from `before`.
    void decide(const DesktopPreferences& before);

    DesktopPreferences desktopPreferences_;
    bool asks_ = false;
    // Settings as the portal gives them: reduced motion has an old and a new key.
    bool animationsOff_ = false;
    bool motionReduced_ = false;
};

}  // namespace vitrine::ui
