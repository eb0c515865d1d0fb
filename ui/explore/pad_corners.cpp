#include "ui/explore/pad_corners.h"

#include "exhibits/framework/files/preset_store.h"
#include "ui/kit/language.h"
#include "ui/kit/tile_delegate.h"
#include "ui/model/workbench.h"
#include "ui/presets/preset_controller.h"
#include "ui/viewport/viewport.h"

#include <algorithm>

namespace vitrine::ui {

PadCorners::PadCorners(Workbench& workbench, PresetController& presetController, QObject* parent)
    : QObject(parent), workbench_(workbench), presetController_(presetController)
{
}

void PadCorners::begin()
{
    for (std::size_t i = 0; i < count; ++i) {
        ++readings_.at(i);
        corners_.at(i) = {};
    }
    const auto all = presets();
    for (std::size_t i = 1; i < count && i <= all.size(); ++i) takePreset(i, all[i - 1].second);
    emit changed();
}

void PadCorners::takeOnShow(std::size_t corner)
{
    ++readings_.at(corner);
    corners_.at(corner) = {};
    emit changed();
}

void PadCorners::keep(std::size_t corner)
{
    ++readings_.at(corner);
    const ParameterValues& now = workbench_.history().sceneState().values[workbench_.shown()];
    corners_.at(corner) = {Source::kept, {}, {}, now, pictureOnShow()};
    emit changed();
}

void PadCorners::takePreset(std::size_t corner, const QString& id)
{
    const std::optional<ReadSettings> found = presetController_.settingsIn(id);
    if (!found || found->exhibit != workbench_.shown()) {
        emit changed();  // The chooser shows the corner's present entry again.
        return;
    }
    corners_.at(corner) = {Source::preset, found->name, id, std::nullopt,
                           QPixmap(QString::fromStdString(PresetStore::thumbnailPath(id.toStdString()).string()))};
    // Files that the preset names may add parameters. They are read on the render thread.
    workbench_.viewport().renderThread().post([this, &museum = workbench_.museum(), sceneState = found->sceneState,
                                               exhibit = found->exhibit, corner,
                                               number = ++readings_.at(corner)]() -> std::function<void()> {
        const TabledSceneState read = museum.readTables(sceneState);
        return [this, read, exhibit, corner, number] {
            if (number != readings_.at(corner)) return;
            QStringList unreadable;
            for (const Message& why : read.unreadable) unreadable << translatedText(why);
            workbench_.setProblems(QStringLiteral("files of corner %1").arg(corner), unreadable);
            corners_.at(corner).values = read.sceneState.values[exhibit];
            emit changed();
        };
    });
    emit changed();
}

std::optional<std::size_t> PadCorners::onShow() const
{
    for (std::size_t i = 0; i < count; ++i)
        if (corners_.at(i).source == Source::onShow) return i;
    return std::nullopt;
}

bool PadCorners::ready() const
{
    return std::all_of(corners_.begin(), corners_.end(), [](const Corner& corner) {
        return corner.source == Source::onShow || corner.values.has_value();
    });
}

std::vector<std::pair<QString, QString>> PadCorners::presets() const
{
    return presetController_.choices(workbench_.shown());
}

std::array<double, PadCorners::count> PadCorners::weightsAt(const QPointF& place)
{
    const double x = std::clamp(place.x(), 0.0, 1.0), y = std::clamp(place.y(), 0.0, 1.0);
    return {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
}

QPointF PadCorners::placeOf(std::size_t corner)
{
    return {corner % 2 == 1 ? 1.0 : 0.0, corner >= 2 ? 1.0 : 0.0};
}

QPixmap PadCorners::pictureOnShow() const
{
    const QImage& picture = workbench_.viewport().pictures().shown().image();
    return picture.isNull() ? QPixmap() : thumbnailOf(picture);
}

}  // namespace vitrine::ui

#include "moc_pad_corners.cpp"
