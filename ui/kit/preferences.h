#pragma once

#include <QMap>
#include <QObject>
#include <QStringList>

#include <cstdint>

namespace vitrine::ui {

enum class ThemeChoice : std::uint8_t { desktop, light, dark, highContrast };
enum class MotionChoice : std::uint8_t { desktop, reduced, full };

/// Range of a whole number, both ends included, and its initial value.
struct PreferenceRange {
    int least, most, initial;
};

/// Preferences about the program itself. Default-constructed, all values are initial.
struct PreferenceValues {
    static constexpr PreferenceRange typeSizes{100, 200, 100};
    static constexpr PreferenceRange lookSpeeds{25, 400, 100};
    static constexpr PreferenceRange wheelSpeeds{25, 400, 100};
    static constexpr PreferenceRange sampleLimits{1, 256, 256};
    static constexpr PreferenceRange movingScales{25, 100, 25};
    static constexpr PreferenceRange recentCounts{0, 50, 10};
    static constexpr PreferenceRange oscPorts{0, 65535, 0};

    ThemeChoice theme = ThemeChoice::desktop;
    MotionChoice motion = MotionChoice::desktop;
    int typeSize = typeSizes.initial;      ///< Font size in percent of the desktop's.
    int lookSpeed = lookSpeeds.initial;    ///< Turn for a movement of the pointer, in percent of the usual one.
    int wheelSpeed = wheelSpeeds.initial;  ///< Zoom for a step of the wheel, in percent of the usual one.
    bool invertedLook = false;             ///< Dragging down looks up.
    /// Most samples per pixel of a static picture; the largest value: no limit.
    int mostSamples = sampleLimits.initial;
    int leastScale = movingScales.initial;   ///< Lowest resolution of a picture in motion, in percent.
    int recentFiles = recentCounts.initial;  ///< Number of recent files that are kept.
    int oscPort = oscPorts.initial;          ///< UDP port for OSC controllers; 0: none is opened.
    bool midi = false;                       ///< MIDI devices are read.
    /// Shortcuts by action id, in Qt's portable text. Only actions with changed shortcuts have an entry.
    QMap<QString, QStringList> keys;
    /// Controls that move parameters, as text (`controlText`), by "exhibit/parameter".
    QMap<QString, QString> controllers;

    bool operator==(const PreferenceValues&) const = default;
};

/// Preferences of this user on this machine, stored in window.ini of `configFolder()`. Changes are written at once.
class Preferences final : public QObject {
    Q_OBJECT

public:
    /// Reads the file. Missing and invalid values are initial. A file of another kind is renamed, so that writing
    /// preferences does not destroy it.
    explicit Preferences(QObject* parent = nullptr);

    [[nodiscard]] const PreferenceValues& values() const { return values_; }
    /// Sets the values, each clamped to its range, and writes the changed ones. Initial values are removed from the
    /// file.
    void set(PreferenceValues);
    /// Sentences about errors in the file when it was read; empty if there were none.
    [[nodiscard]] const QString& complaint() const { return complaint_; }
    /// Sentence why the last write failed; empty if it succeeded.
    [[nodiscard]] const QString& failure() const { return failure_; }

    /// Reads the values from the file, for use before the window exists.
    [[nodiscard]] static PreferenceValues saved();

signals:
    void changed(const vitrine::ui::PreferenceValues& before);
    /// Emitted when writing failed. The values stay in effect until the program ends.
    void notWritten(const QString& why);

private:
    void read();
    /// Writes the values that differ from `before` and no others, because another window may have changed those.
    void write(const PreferenceValues& before);

    PreferenceValues values_;
    QStringList wrong_;  ///< Keys in the file with invalid values.
    QString complaint_, failure_;
};

}  // namespace vitrine::ui
