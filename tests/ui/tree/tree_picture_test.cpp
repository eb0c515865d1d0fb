// Positions of outlines and handles in a picture, and the effect of dragging a handle. No GL.

#include "tests/ui/ui_main.h"

#include "ui/tree/tree_handles.h"
#include "ui/tree/tree_outline.h"

#include <QtTest>

#include <cmath>
#include <numbers>

using namespace vitrine;
using namespace vitrine::ui;

class TreePictureTest final : public QObject {
    Q_OBJECT

    static constexpr double pi = std::numbers::pi;
    const QSizeF widget_{800, 600};
    const render::View view_ = render::makeView({{1, 2, 6}, {0, 0, 0}, 0.8}, {{800, 600}});

    [[nodiscard]] QPointF at(const glm::dvec3& world) const { return onScreen(view_, widget_, world).value(); }
    [[nodiscard]] static TreeShape ball(double radius)
    {
        return {{glm::dvec3(-radius), glm::dvec3(radius)}, [radius](const render::Ray& ray) {
                    return std::isfinite(render::firstHit(ray, glm::dvec3(0), radius));
                }};
    }
    /// Returns the position in world space of a point in a place's own space.
    [[nodiscard]] static glm::dvec3 moved(const TreePlace& place, const glm::dvec3& own)
    {
        return glm::dvec3(place.exhibitFromParent *
                          glm::dvec4(place.translate + place.rotation() * (place.scale * own), 1));
    }

private slots:
    void theOutlineOfABallIsItsSilhouette()
    {
        const glm::dmat4 world(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0),
                               glm::dvec4(0.5, 0.25, 0, 1));
        const auto lines = outlineOf(ball(0.7), view_, world, widget_, [] { return true; });
        QVERIFY(lines.size() > 50);
        const glm::dvec3 center(0.5, 0.25, 0);
        const double toCenter = glm::distance(view_.eye, center);
        const double halfAngle = std::asin(0.7 / toCenter);
        double largest = 0;
        for (const QLineF& line : lines) {
            const glm::dvec2 ndc(2 * line.x1() / 800 - 1, 1 - 2 * line.y1() / 600);
            const glm::dvec3 ray = glm::normalize(view_.direction(ndc));
            const double angle = std::acos(glm::dot(ray, glm::normalize(center - view_.eye)));
            largest = std::max(largest, std::abs(angle - halfAngle));
        }
        const double pixel = 2 * std::tan(0.4) / 600;
        QVERIFY2(largest < pixel, qPrintable(QString::number(largest / pixel)));
    }

    void anOutlineThatIsNotWantedAnyMoreIsGivenUp()
    {
        int asked = 0;
        QVERIFY(outlineOf(ball(0.7), view_, glm::dmat4(1), widget_, [&] { return ++asked < 4; }).empty());
        QCOMPARE(asked, 4);
    }

    void whatHasNoEndIsLookedForInTheWholePicture()
    {
        TreeShape wall = ball(1);
        wall.box = {glm::dvec3(-INFINITY), glm::dvec3(INFINITY)};
        QVERIFY(!outlineOf(wall, view_, glm::dmat4(1), widget_, [] { return true; }).empty());
    }

    void aMovedHandleTakesThePlaceWithThePointer()
    {
        TreePlace place{glm::dmat4(1), {0.3, -0.2, 0.4}};
        for (const Handle& handle : handlesOf(HandleMode::move, place, glm::dmat4(1), view_, widget_)) {
            const QPointF along = handle.line[1] - handle.line[0];
            const QPointF pointer = along * 0.2;
            const TreePlace to = dragged(HandleMode::move, place, handle, 0, pointer);
            for (int axis = 0; axis < 3; ++axis)
                if (axis != handle.axis) QCOMPARE(to.translate[axis], place.translate[axis]);
            const QPointF went = at(to.translate) - at(place.translate);
            QVERIFY2(QLineF(went, pointer).length() < 1.5, qPrintable(QString::number(handle.axis)));
        }
    }

    void aRingTurnsAboutItsOwnAxis()
    {
        TreePlace place{glm::dmat4(1), {0.1, 0, 0}, {0.4, -0.7, 0.9}};
        const auto rings = handlesOf(HandleMode::turn, place, glm::dmat4(1), view_, widget_);
        QCOMPARE(rings.size(), std::size_t(3));
        for (const Handle& ring : rings) {
            TreePlace to = place;
            to.rotate[ring.axis] += 1e-4;
            // Points of the ring move along it, because points of the axis do not move.
            glm::dvec3 axis(0);
            const glm::dmat3 change = to.rotation() * glm::transpose(place.rotation());
            axis = glm::normalize(
                glm::dvec3(change[1][2] - change[2][1], change[2][0] - change[0][2], change[0][1] - change[1][0]));
            for (std::size_t i = 0; i < ring.line.size(); i += 7) {
                const QPointF step =
                    dragged(HandleMode::turn, place, ring, i, ring.perUnit[i] * 0.5).rotate[ring.axis] * QPointF(1, 0);
                QVERIFY(std::abs(step.x() - (place.rotate[ring.axis] + 0.5)) < pi / 17000);
            }
            // The ring's plane is perpendicular to that axis: seen along it, it is a circle around the center.
            const glm::dvec3 middle = place.translate;
            const QPointF center = at(middle);
            const QPointF tip = at(middle + 0.2 * axis);
            double most = 0, least = 1e9;
            for (const QPointF& p : ring.line) {
                most = std::max(most, QLineF(center, p).length());
                least = std::min(least, QLineF(center, p).length());
            }
            const double towardsEye = std::abs(glm::dot(axis, glm::normalize(view_.eye - middle)));
            QVERIFY2(std::abs(least / most - towardsEye) < 0.08, qPrintable(QString::number(least / most)));
            QVERIFY(QLineF(center, tip).length() < most);
        }
    }

    void aScaleHandleDoublesAtTwiceItsLength()
    {
        const TreePlace place{glm::dmat4(1), {0, 0, 0}, {0, 0.5, 0}, {1, 2, 0.5}};
        for (const Handle& handle : handlesOf(HandleMode::scale, place, glm::dmat4(1), view_, widget_)) {
            const QPointF along = handle.line[1] - handle.line[0];
            const TreePlace to = dragged(HandleMode::scale, place, handle, 0, along);
            QCOMPARE(to.scale[handle.axis], 2 * place.scale[handle.axis]);
            QVERIFY(dragged(HandleMode::scale, place, handle, 0, along * -5).scale[handle.axis] > 0);
            // Along the node's own axis.
            glm::dvec3 own(0);
            own[handle.axis] = 0.05;
            const QPointF there = at(moved(place, own)) - at(moved(place, {}));
            QVERIFY(std::abs(QLineF({}, there).angleTo(QLineF({}, along))) < 1 ||
                    std::abs(QLineF({}, there).angleTo(QLineF({}, along)) - 360) < 1);
        }
    }

    void aGripTakesTheNearestHandle()
    {
        const render::View ahead = render::makeView({{0, 0, 6}, {0, 0, 0}, 0.8}, {{800, 600}});
        const auto handles = handlesOf(HandleMode::move, {}, glm::dmat4(1), ahead, widget_);
        QCOMPARE(handles.size(), std::size_t(2));  // The handle of z points at the eye.
        const auto grip = gripAt(handles, handles[1].line[1] + QPointF(3, 2));
        QVERIFY(grip);
        QCOMPARE(grip->handle, std::size_t(1));
        QVERIFY(!gripAt(handles, handles[1].line[1] + QPointF(30, 30)));
        QVERIFY(handlesOf(HandleMode::none, {}, glm::dmat4(1), view_, widget_).empty());
    }
};

VITRINE_UI_TEST(TreePictureTest)

#include "tree_picture_test.moc"
