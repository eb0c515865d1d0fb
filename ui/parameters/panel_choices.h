#pragma once

#include <QObject>
#include <QSet>
#include <QStringList>

#include <array>
#include <cstdint>

namespace vitrine::ui {

/// Things that the visitor chooses in a parameter panel.
enum class PanelChoice : std::uint8_t {
    toggled,  ///< Groups that were unfolded, or folded where they are unfolded at first.
    locked,   ///< Parameters that keep their values when the others are randomized.
    pinned,   ///< Parameters that are shown under the essential ones.
};

/// The visitor's arrangement of the parameter panel. Keys are "exhibit/group" and "exhibit/parameter". The window keeps
/// it with its layout.
class PanelChoices final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] bool has(PanelChoice choice, const QString& key) const { return of(choice).contains(key); }
    void set(PanelChoice, const QStringList& keys, bool on);
    /// Returns the keys in alphabetical order.
    [[nodiscard]] QStringList list(PanelChoice) const;
    void setList(PanelChoice, const QStringList& keys);

signals:
    void changed(PanelChoice);

private:
    [[nodiscard]] const QSet<QString>& of(PanelChoice choice) const { return keys_[static_cast<std::size_t>(choice)]; }

    std::array<QSet<QString>, 3> keys_;
};

}  // namespace vitrine::ui
