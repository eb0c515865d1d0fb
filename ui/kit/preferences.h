#pragma once

#include <QMap>
#include <QObject>
#include <QStringList>

#include <cstdint>

namespace vitrine::ui {

enum class ThemeChoice : std::uint8_t { desktop, light, dark, highContrast };
enum class MotionChoice : std::uint8_t { desktop, reduced, full };

/// A whole number with its range, both ends allowed.
struct PreferenceRange {
    int least, most, initial;
};

/// What the visitor prefers of the program itself, whatever is on show. As made, it holds the initial values.
struct PreferenceValues {
    static constexpr PreferenceRange typeSizes{100, 200, 100};
    static constexpr PreferenceRange lookSpeeds{25, 400, 100};
    static constexpr PreferenceRange wheelSpeeds{25, 400, 100};
    static constexpr PreferenceRange sampleLimits{1, 256, 256};
    static constexpr PreferenceRange movingScales{25, 100, 25};
    static constexpr PreferenceRange recentCounts{0, 50, 10};

    ThemeChoice theme = ThemeChoice::desktop;
    MotionChoice motion = MotionChoice::desktop;
    int typeSize = typeSizes.initial;        ///< Percent of the desktop's.
    int lookSpeed = lookSpeeds.initial;      ///< Percent of the usual turn for a way of the pointer.
    int wheelSpeed = wheelSpeeds.initial;    ///< Percent of the usual zoom for a step of the wheel.
    bool invertedLook = false;               ///< Dragging down looks up.
    int mostSamples = sampleLimits.initial;  ///< Per pixel of a picture at rest; the largest: as many as the hall says.
    int leastScale = movingScales.initial;   ///< Percent of full resolution, of a picture in motion.
    int recentFiles = recentCounts.initial;  ///< How many are kept.
    /// Shortcuts by the id of the action, in Qt's portable text; only of actions whose shortcuts are not their own.
    QMap<QString, QStringList> keys;

    bool operator==(const PreferenceValues&) const = default;
};

/// The preferences of this user on this machine, kept in window.ini of `configFolder()`. Changes are written at once.
class Preferences final : public QObject {
    Q_OBJECT

public:
    /// Reads them: what is not there, or not valid, is initial. A file that is no such file at all is put aside beside
    /// itself, so that nothing is lost when preferences are written anew.
    explicit Preferences(QObject* parent = nullptr);

    [[nodiscard]] const PreferenceValues& values() const { return values_; }
    /// Keeps them, each within its range, and writes those that change; none that is initial stays in the file.
    void set(PreferenceValues);
    /// One sentence or two about what was wrong with the file; empty when nothing was.
    [[nodiscard]] const QString& complaint() const { return complaint_; }
    /// What happened when the file was written last, for people; empty when it was written.
    [[nodiscard]] const QString& failure() const { return failure_; }

    /// As they are in the file now, for those who start before the window does.
    [[nodiscard]] static PreferenceValues saved();

signals:
    void changed(const vitrine::ui::PreferenceValues& before);
    /// They could not be written; they hold until the program ends.
    void notWritten(const QString& why);

private:
    void read();
    /// Writes what differs from `before`, and nothing else: another window may have changed the rest.
    void write(const PreferenceValues& before);

    PreferenceValues values_;
    QStringList wrong_;  ///< Keys in the file whose values are not valid.
    QString complaint_, failure_;
};

}  // namespace vitrine::ui
