#pragma once

#include "exhibits/framework/parameters.h"

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

class PresetShelf;
class Workbench;

/// What stands at the four corners of the pad, row by row: upper left, upper right, lower left, lower right. Each is
/// what is on show, a preset of the exhibit whose parameters are shown, or a look that was kept there.
class PadCorners final : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t count = 4;
    enum class Source { onShow, kept, preset };
    struct Corner {
        Source source = Source::onShow;
        QString name;                           ///< Of a preset; empty: `source` says all.
        QString id;                             ///< Of a preset: its path.
        std::optional<ParameterValues> values;  ///< Nothing: what is on show, or a preset that is still being read.
        QPixmap picture;                        ///< May be null.
    };

    /// Both must outlive it.
    PadCorners(Workbench&, PresetShelf&, QObject* parent);

    /// Begins anew for the exhibit whose parameters are shown: what is on show, and its first presets.
    void begin();
    void takeOnShow(std::size_t corner);
    /// What is on show now stays there, whatever is shown later.
    void keep(std::size_t corner);
    /// A preset from `presets`. One that cannot be read is said, and the corner stays as it was.
    void takePreset(std::size_t corner, const QString& id);

    [[nodiscard]] const Corner& at(std::size_t corner) const { return corners_.at(corner); }
    /// The first corner that is what is on show; nothing: none is.
    [[nodiscard]] std::optional<std::size_t> onShow() const;
    /// All have been read.
    [[nodiscard]] bool ready() const;
    /// The presets of the exhibit: name and id.
    [[nodiscard]] std::vector<std::pair<QString, QString>> presets() const;

    /// How much each corner counts at a place in the square, (0, 0) its upper left corner: 1 together, and on an edge
    /// nothing but its two ends.
    [[nodiscard]] static std::array<double, count> weightsAt(const QPointF& place);
    /// The corner's place in the square.
    [[nodiscard]] static QPointF placeOf(std::size_t corner);

signals:
    void changed();

private:
    [[nodiscard]] QPixmap pictureOnShow() const;

    Workbench& workbench_;
    PresetShelf& shelf_;
    std::array<Corner, count> corners_;
    std::array<int, count> readings_{};  // The newest order of each corner.
};

}  // namespace vitrine::ui
