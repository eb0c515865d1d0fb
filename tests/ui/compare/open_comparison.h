#pragma once

#include "tests/ui/open_window.h"

#include "ui/compare/compare_controller.h"
#include "ui/compare/compare_overlay.h"
#include "ui/compare/picture_b.h"
#include "ui/model/settings_b.h"

namespace vitrine::test {

/// Test of the comparison of A and B in the real window, over a gallery whose picture has one color: its red is the
/// roughness.
class OpenComparison : public OpenWindow {
protected:
    [[nodiscard]] ui::CompareController& controller() { return window_->comparison(); }
    [[nodiscard]] ui::Viewport& view() { return window_->viewport(); }
    void setRoughness(double value)
    {
        window_->history().set(1, gallery_->table().roughness.row, value, ui::newGesture());
    }
    [[nodiscard]] double otherRoughness()
    {
        return controller().other().sceneState().values[1][gallery_->table().roughness];
    }
    /// Waits until both pictures and their difference are finished.
    void rest()
    {
        settle();
        QTRY_VERIFY(!controller().picture().wanted() || controller().picture().finished());
        QTest::qWait(30);
    }
    /// Sets A to 0.8 and B to 0.2, with a wipe between them.
    void compare()
    {
        window_->choose(1);
        setRoughness(0.2);
        settle();
        action("Hold the current settings as B")->trigger();
        setRoughness(0.8);
        rest();
    }
    /// Returns a color of the screen including overlays; coordinates are shares of width and height.
    [[nodiscard]] QColor shownAt(double x, double y = 0.7)
    {
        const QImage all = view().grab().toImage();
        return all.pixelColor(static_cast<int>(x * (all.width() - 1)), static_cast<int>(y * (all.height() - 1)));
    }
    [[nodiscard]] bool isA(double x) { return std::abs(shownAt(x).red() - 204) <= 1; }
    [[nodiscard]] bool isB(double x) { return std::abs(shownAt(x).red() - 51) <= 1; }
    /// Returns the view direction in radians about the vertical axis.
    [[nodiscard]] double heading()
    {
        const render::Camera camera = window_->history().sceneState().camera;
        const glm::dvec3 ahead = camera.target - camera.eye;
        return std::atan2(ahead.x, -ahead.z);
    }
    [[nodiscard]] QPoint at(double x, double y = 0.7)
    {
        return {static_cast<int>(x * view().width()), static_cast<int>(y * view().height())};
    }
    void dragInPicture(double from, double to)
    {
        QTest::mousePress(&view(), Qt::LeftButton, {}, at(from));
        for (int i = 1; i <= 8; ++i) QTest::mouseMove(&view(), at(from + (to - from) * i / 8));
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, at(to));
    }
};

}  // namespace vitrine::test
