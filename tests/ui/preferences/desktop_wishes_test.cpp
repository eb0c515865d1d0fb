#include "tests/ui/preferences/fake_portal.h"

#include "ui/kit/desktop_wishes.h"

#include <QSignalSpy>
#include <QTest>

#include <memory>

using namespace vitrine;
using namespace vitrine::ui;

/// What a desktop's portal says, over a bus of the test's own.
class DesktopWishesTest : public QObject {
    Q_OBJECT

    std::unique_ptr<test::PrivateBus> daemon_;
    std::unique_ptr<test::FakePortal> desktop_;

    [[nodiscard]] QDBusConnection bus(const char* name)
    {
        return QDBusConnection::connectToBus(daemon_->address(), QLatin1String(name));
    }

private slots:
    void initTestCase()
    {
        daemon_ = std::make_unique<test::PrivateBus>();
        if (daemon_->address().isEmpty()) QSKIP("There is no dbus-daemon here.");
    }
    void init()
    {
        QVERIFY(bus("desktop").isConnected());
        desktop_ = std::make_unique<test::FakePortal>(bus("desktop"));
    }
    void cleanup() { desktop_.reset(); }

    void whatItWishesIsTakenAndItsChangesAreFollowed()
    {
        desktop_->settings[test::FakePortal::appearance] = {{"color-scheme", 1U}, {"contrast", 1U}};
        desktop_->settings[test::FakePortal::gnome] = {{"enable-animations", false}};
        DesktopPortal portal(bus("program"));
        QCOMPARE(portal.wishes(), DesktopWishes());  // Nobody waits for it.
        QTRY_COMPARE(portal.wishes(), (DesktopWishes{true, true, true}));
        desktop_->change(test::FakePortal::appearance, "color-scheme", 2U);
        QTRY_COMPARE(portal.wishes().dark, std::optional(false));
        desktop_->change(test::FakePortal::appearance, "contrast", 0U);
        QTRY_VERIFY(!portal.wishes().highContrast);
        desktop_->change(test::FakePortal::gnome, "enable-animations", true);
        QTRY_VERIFY(!portal.wishes().reducedMotion);
        desktop_->change(test::FakePortal::appearance, "reduced-motion", 1U);
        QTRY_VERIFY(portal.wishes().reducedMotion);
        desktop_->change(test::FakePortal::appearance, "color-scheme", 0U);
        QTRY_COMPARE(portal.wishes().dark, std::optional<bool>());
    }

    void valuesOfOtherKindsWishNothing()
    {
        desktop_->settings[test::FakePortal::appearance] = {
            {"color-scheme", "dark"}, {"contrast", QStringList{"1"}}, {"reduced-motion", -1}};
        desktop_->settings[test::FakePortal::gnome] = {{"enable-animations", 0U}};
        DesktopPortal portal(bus("program"));
        QSignalSpy told(&portal, &DesktopPortal::answered);
        QTRY_COMPARE(told.count(), 1);
        QCOMPARE(portal.wishes(), DesktopWishes());
        desktop_->change(test::FakePortal::appearance, "contrast", 1U);
        QTRY_VERIFY(portal.wishes().highContrast);  // It listens all the same.
    }

    void anAnswerThatIsNoneIsNone()
    {
        desktop_->answersNonsense = true;
        DesktopPortal portal(bus("program"));
        QSignalSpy told(&portal, &DesktopPortal::answered);
        QTRY_COMPARE(told.count(), 1);
        QCOMPARE(portal.wishes(), DesktopWishes());
    }

    void aDesktopWithoutAPortalIsNotWaitedFor()
    {
        desktop_.reset();
        DesktopPortal portal(bus("program"));
        QSignalSpy told(&portal, &DesktopPortal::answered);
        QTRY_COMPARE(told.count(), 1);
        QCOMPARE(portal.wishes(), DesktopWishes());
    }

    void aPortalThatSaysNothingHoldsUpNothing()
    {
        desktop_->silent = true;
        DesktopPortal portal(bus("program"));
        QTRY_COMPARE(desktop_->asked, 1);
        QCOMPARE(portal.wishes(), DesktopWishes());
    }

    void withoutABusOfTheSessionNoneIsLookedFor()
    {
        const QByteArray address = qgetenv("DBUS_SESSION_BUS_ADDRESS");
        qunsetenv("DBUS_SESSION_BUS_ADDRESS");
        const DesktopPortal portal;
        QCOMPARE(portal.wishes(), DesktopWishes());
        QVERIFY(!portal.asks());
        if (!address.isEmpty()) qputenv("DBUS_SESSION_BUS_ADDRESS", address);
    }
};

QTEST_GUILESS_MAIN(DesktopWishesTest)
#include "desktop_wishes_test.moc"
