// Controllers in the real window. The OSC messages come from liblo-tools' oscsend; MIDI messages are given as bytes.
#include "tests/ui/preferences/open_preferences.h"
#include "tests/ui/ui_main.h"

#include "ui/controllers/controllers.h"
#include "ui/kit/message_strip.h"
#include "ui/parameters/parameter_menus.h"

#include <QCheckBox>
#include <QContextMenuEvent>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QProcess>
#include <QStandardPaths>
#include <QStatusBar>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

/// Returns whether a library of this name is loaded in the process.
bool isOpened(const char* library)
{
    QFile maps("/proc/self/maps");
    return maps.open(QIODevice::ReadOnly) && maps.readAll().contains(library);
}

/// UDP socket at a free port.
class Datagrams {
public:
    Datagrams() : socket_(::socket(AF_INET, SOCK_DGRAM, 0))
    {
        sockaddr_in any = at(0);
        socklen_t size = sizeof any;
        ok_ = ::bind(socket_, reinterpret_cast<const sockaddr*>(&any), size) == 0 &&
              ::getsockname(socket_, reinterpret_cast<sockaddr*>(&any), &size) == 0;
        port_ = ntohs(any.sin_port);
    }
    ~Datagrams() { ::close(socket_); }
    Datagrams(const Datagrams&) = delete;
    Datagrams& operator=(const Datagrams&) = delete;

    [[nodiscard]] bool isBound() const { return ok_; }
    [[nodiscard]] int port() const { return port_; }
    void send(const QByteArray& bytes, int port)
    {
        sockaddr_in to = at(port);
        to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        const auto size = static_cast<std::size_t>(bytes.size());
        ::sendto(socket_, bytes.constData(), size, 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
    }

private:
    static sockaddr_in at(int port)
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        return address;
    }

    int socket_, port_ = 0;
    bool ok_ = false;
};

}  // namespace

class ControllersWindowTest : public test::OpenPreferences {
    Q_OBJECT

    int port_ = 0;

    [[nodiscard]] Controllers& controllers() { return *window_->findChild<Controllers*>(); }
    [[nodiscard]] int steps() { return window_->history().stack().count(); }
    void listen()
    {
        PreferenceValues wanted = values();
        wanted.oscPort = port_ = Datagrams().port();
        window_->preferences().values().set(wanted);
        QCOMPARE(controllers().listening(), QStringList{QString("OSC %1").arg(port_)});
    }
    void send(const QStringList& message)
    {
        QProcess sender;
        sender.start("oscsend", QStringList{"127.0.0.1", QString::number(port_)} + message);
        QVERIFY(sender.waitForFinished());
        QCOMPARE(sender.exitCode(), 0);
    }
    void cc(int number, int value)
    {
        controllers().take({{{}, {}, {0xb0, static_cast<unsigned char>(number), static_cast<unsigned char>(value)}}});
    }
    /// Opens the menu of a parameter, and triggers the entry if there is one. Returns the texts of all entries.
    QStringList menu(const char* row, const char* entry = "")
    {
        QWidget* over = window_->panel().row(row);
        QContextMenuEvent event(QContextMenuEvent::Keyboard, QPoint(20, 10), over->mapToGlobal(QPoint(20, 10)));
        QApplication::sendEvent(over, &event);
        auto* opened = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        if (!opened) return {};
        QStringList texts;
        QAction* chosen = nullptr;
        for (QAction* each : opened->actions()) {
            texts << each->text();
            if (each->text() == QLatin1String(entry)) chosen = each;
        }
        if (chosen) chosen->trigger();
        opened->close();
        return texts;
    }
    /// Returns the label below a parameter; empty if it has none.
    [[nodiscard]] QString note(const char* row = "roughness")
    {
        for (const QLabel* label : window_->panel().row(row)->findChildren<QLabel*>())
            if (label->accessibleName().startsWith("Controller of") && label->isVisible()) return label->text();
        return {};
    }

private slots:
    void initTestCase()
    {
        prepare();
        if (QStandardPaths::findExecutable("oscsend").isEmpty()) QSKIP("liblo-tools is not installed.");
    }
    void init()
    {
        start();
        window_->choose(1);
        settle();
    }
    void cleanup()
    {
        finish();
        lookLikeNothingWasChosen();
    }

    void longNothingIsOpenedUntilItIsSwitchedOn()
    {
        QTest::qWait(2500);  // Inputs are opened two seconds after the start.
        QVERIFY(controllers().listening().isEmpty());
        for (const char* library : {"libvitrine_controllers", "liblo.", "librtmidi"})
            QVERIFY2(!isOpened(library), library);
        QVERIFY(menu("roughness", "Learn controller").contains("Learn controller"));
        const QStringList said = window_->findChild<MessageStrip*>()->texts();
        QVERIFY2(said.join(' ').contains("Set an OSC port"), qPrintable(said.join(' ')));
        QCOMPARE(note(), QString());
        QVERIFY(openDialog("Controllers"));
        const int port = Datagrams().port();  // Free again from here on.
        type("OSC port", port);
        QVERIFY(isOpened("libvitrine_controllers"));
        QVERIFY2(controllers().listening().size() == 1,
                 qPrintable(window_->findChild<MessageStrip*>()->texts().join(' ')));
        reset("Reset OSC port");
        QVERIFY(controllers().listening().isEmpty());
    }

    void aFaderIsLearnedTakesOverSoftlyAndIsForgotten()
    {
        listen();
        menu("roughness", "Learn controller");
        QVERIFY2(note().startsWith("Move a control"), qPrintable(note()));
        QVERIFY(menu("roughness").contains("Stop learning"));
        QCOMPARE(roughness(), 0.25);
        send({"/fader/3", "f", "0.75"});
        QTRY_COMPARE(note(), QString("/fader/3, at 0.75"));
        QCOMPARE(roughness(), 0.25);
        QCOMPARE(steps(), 0);
        QVERIFY(window_->panel().row("roughness")->toolTip().contains("present value, 0.25"));
        send({"/fader/3", "f", "0.5"});  // Still above.
        QTRY_COMPARE(note(), QString("/fader/3, at 0.5"));
        QCOMPARE(roughness(), 0.25);
        send({"/fader/3", "f", "0.125"});
        QTRY_VERIFY(std::abs(roughness() - 0.125) < 0.003);
        QCOMPARE(note(), QString("/fader/3"));
        for (const char* value : {"0.3", "0.5", "0.875"}) send({"/fader/3", "f", value});
        QTRY_VERIFY(std::abs(roughness() - 0.875) < 0.003);
        send({"/fader/4", "f", "0.1"});  // Another one.
        QTest::qWait(100);
        QVERIFY(std::abs(roughness() - 0.875) < 0.003);
        QCOMPARE(steps(), 1);  // One gesture.
        QCOMPARE(window_->history().stack().undoText(), QString("Change roughness by a controller"));
        window_->history().stack().undo();
        QCOMPARE(roughness(), 0.25);
        QTRY_VERIFY2(note().startsWith("/fader/3, at 0.87"), qPrintable(note()));  // It waits again.
        menu("roughness", "Forget controller");
        QCOMPARE(note(), QString());
        QVERIFY(!menu("roughness").contains("Forget controller"));
        QVERIFY(Preferences::saved().controllers.isEmpty());
    }

    void longWhatIsLearnedLastsBeyondTheSession()
    {
        listen();
        menu("roughness", "Learn controller");
        send({"/1/knob", "i", "1"});
        QTRY_COMPARE(Preferences::saved().controllers.value("sdf_morph/roughness"), QString("osc 1 /1/knob"));
        closeWindow();
        openWindow();
        window_->choose(1);
        QCOMPARE(note(), QString("/1/knob"));
        QTRY_COMPARE(controllers().listening().size(), 1);  // Opened after the first picture.
        send({"/1/knob", "d", "0.25"});
        send({"/1/knob", "d", "0.5"});
        QTRY_VERIFY(std::abs(roughness() - 0.5) < 0.003);
    }

    void aPadWithTwoNumbersGivesEachToAParameter()
    {
        listen();
        menu("roughness", "Learn controller");
        send({"/pad", "ff", "0.1", "0.2"});
        send({"/pad", "ff", "0.1", "0.3"});  // The second one is moved.
        QTRY_VERIFY2(note().startsWith("/pad, number 2"), qPrintable(note()));
        menu("animated", "Learn controller");
        send({"/switch", "T"});
        QTRY_COMPARE(note("animated"), QString("/switch"));
    }

    void longMidiMessagesMoveParameters()
    {
        listen();
        menu("roughness", "Learn controller");
        cc(21, 100);
        QVERIFY2(note().startsWith("CC 21, channel 1, at "), qPrintable(note()));
        cc(21, 20);
        QCOMPARE(note(), QString("CC 21, channel 1"));
        QVERIFY(std::abs(roughness() - 20 / 127.0) < 0.003);
        // Two faders that are moved together are at most one step each.
        menu("morph", "Learn controller");
        cc(22, 64);
        const int before = steps();
        for (int i = 20; i < 60; ++i) {
            cc(21, i);
            cc(22, i + 44);
        }
        QVERIFY(steps() <= before + 2);
        QVERIFY(std::abs(roughness() - 59 / 127.0) < 0.003);
        QTest::qWait(Controllers::sameStep + 50);
        const int resting = steps();
        cc(21, 10);
        QCOMPARE(steps(), resting + 1);  // Another gesture.
    }

    void aPortThatIsTakenIsSaidWithWhatToDo()
    {
        const Datagrams other;
        QVERIFY(other.isBound());
        PreferenceValues wanted = values();
        wanted.oscPort = other.port();
        window_->preferences().values().set(wanted);
        QVERIFY(controllers().listening().isEmpty());
        const QString said = window_->findChild<MessageStrip*>()->texts().join(' ');
        QVERIFY2(said.contains(QString("Cannot listen to OSC at port %1").arg(other.port())), qPrintable(said));
        wanted.oscPort = 0;
        window_->preferences().values().set(wanted);
        QVERIFY(!window_->findChild<MessageStrip*>()->texts().join(' ').contains("Cannot listen"));
    }

    void midiIsReadWhereThisMachineHasIt()
    {
        PreferenceValues wanted = values();
        wanted.midi = true;
        window_->preferences().values().set(wanted);
        const QString said = window_->findChild<MessageStrip*>()->texts().join(' ');
        if (QFile::exists("/dev/snd/seq"))
            QVERIFY2(!controllers().listening().isEmpty(), qPrintable(said));
        else
            QVERIFY2(said.contains("MIDI devices cannot be read"), qPrintable(said));
    }

    void hostileDatagramsChangeNothing()
    {
        listen();
        menu("roughness", "Learn controller");
        Datagrams sender;
        const auto datagram = [&](const QByteArray& bytes) { sender.send(bytes, port_); };
        datagram({});
        datagram("/fader");
        datagram(QByteArray("/a\0\0,f\0\0", 8));               // The number is missing.
        datagram(QByteArray("/a\0\0,f\0\0\x7f\xc0\0\0", 12));  // Not a number.
        datagram(QByteArray("#bundle\0\0\0\0\0\0\0\0\1\xff\xff\xff\xf0", 20));
        datagram(QByteArray(60000, '/'));
        datagram(QByteArray("/a\0\0,s\0\0text\0\0\0\0", 16));
        QTest::qWait(200);
        QVERIFY(note().startsWith("Move a control"));
        send({"/good", "f", "0.5"});
        QTRY_VERIFY(note().startsWith("/good"));
    }
};

VITRINE_ADD_TEST(ControllersWindowTest, &test::runWithBus<ControllersWindowTest>)

#include "controllers_window_test.moc"
