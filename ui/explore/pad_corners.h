#pragma once

#include "exhibits/framework/table/parameters.h"

#include <QObject>
#include <QPixmap>
#include <QPointF>
#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::ui {

class PresetController;
class Workbench;

/// Settings at the four corners of the pad, row by row: upper left, upper right, lower left, lower right. Each corner
/// has the present values, a preset of the shown exhibit, or values that were kept there.
class PadCorners final : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t count = 4;
    enum class Source { onShow, kept, preset };
    struct Corner {
        Source source = Source::onShow;
        QString name;                           ///< Name of the preset; empty for other sources.
        QString id;                             ///< Path of the preset.
        std::optional<ParameterValues> values;  ///< Unset for the present values, and while a preset is being read.
        QPixmap picture;                        ///< May be null.
    };

    /// Both must outlive this object.
    PadCorners(Workbench&, PresetController&, QObject* parent);

    /// Resets the corners for the shown exhibit: the present values and its first presets.
    void begin();
    void takeOnShow(std::size_t corner);
    /// Keeps the present values at a corner, whatever is changed later.
    void keep(std::size_t corner);
    /// Sets a corner to a preset from `presets`. If it cannot be read, shows a message and leaves the corner unchanged.
    void takePreset(std::size_t corner, const QString& id);

    [[nodiscard]] const Corner& at(std::size_t corner) const { return corners_.at(corner); }
    /// Returns the first corner with the present values, if any.
    [[nodiscard]] std::optional<std::size_t> onShow() const;
    /// Returns whether all presets have been read.
    [[nodiscard]] bool ready() const;
    /// Returns the presets of the exhibit: name and id.
    [[nodiscard]] std::vector<std::pair<QString, QString>> presets() const;

    /// Returns the bilinear weights of the corners at a position in the square; (0, 0) is the upper left corner. The
    /// sum is 1.
    [[nodiscard]] static std::array<double, count> weightsAt(const QPointF& place);
    /// Returns the corner's position in the square.
    [[nodiscard]] static QPointF placeOf(std::size_t corner);

signals:
    void changed();

private:
    [[nodiscard]] QPixmap pictureOnShow() const;

    Workbench& workbench_;
    PresetController& presetController_;
    std::array<Corner, count> corners_;
    std::array<int, count> readings_{};  // Number of the latest reading of each corner; older ones are dropped.
};

}  // namespace vitrine::ui
