#pragma once

#include "ui/controllers/control_input.h"
#include "ui/controllers/takeover.h"
#include "ui/kit/preferences.h"
#include "ui/model/history.h"
#include "ui/parameters/controlled_parameters.h"

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

class QSocketNotifier;

namespace vitrine::ui {

/// Moves parameters by OSC and MIDI controllers, with soft takeover. The preferences switch the inputs on, and keep
/// which control moves which parameter. Nothing is opened while both inputs are off.
class Controllers final : public QObject, public ControlledParameters {
    Q_OBJECT

public:
    /// Milliseconds within which further moves of the same controls are one undo step with the last.
    static constexpr int sameStep = 1000;
    using Open = std::function<std::unique_ptr<ControlInput>(ControlInputKind, int port)>;

    /// All must outlive this object. Inputs that the preferences switch on are opened two seconds later, when the
    /// window has its first picture.
    Controllers(const Museum&, History&, Preferences&, QObject* parent, Open open = openControlInput);
    ~Controllers() override;

    [[nodiscard]] ParameterNote note(const QString& key) const override;
    [[nodiscard]] bool mayLearn(const QString& key) const override;
    [[nodiscard]] bool isLearning(const QString& key) const override { return !key.isEmpty() && key == learning_; }
    [[nodiscard]] bool isControlled(const QString& key) const override { return mapped_.contains(key); }
    /// Emits `nothingListens` instead if both inputs are off.
    void learn(const QString& key) override;
    void forget(const QString& key) override;

    /// Lets controls move these parameters only, and learns none: for exhibitions.
    void limitTo(const QStringList& keys);
    /// Takes messages as if an input had delivered them.
    void take(const std::vector<ControlMessage>&);
    /// Returns the open inputs for the status line: "OSC 9000", "MIDI 2"; empty: none.
    [[nodiscard]] QStringList listening() const;
    /// Returns the names of the open MIDI devices.
    [[nodiscard]] const QStringList& devices() const { return devices_; }

signals:
    /// Emitted when the note of a parameter may have changed.
    void noteChanged(const QString& key);
    void listeningChanged();
    /// Emitted when inputs could not be opened, with sentences why; empty: all that are on are open.
    void problemsChanged(const QStringList& texts);
    void nothingListens();

private:
    struct Mapped {
        Control control;
        Takeover takeover;
        QElapsedTimer since = {};  ///< Time since the control moved the parameter.
    };
    /// Parameter of a key: its subject and row.
    struct Place {
        std::size_t subject, row;
    };
    struct Input {
        std::unique_ptr<ControlInput> input;
        QSocketNotifier* notifier = nullptr;
        int port = 0;  ///< Port of OSC; 1 for MIDI. 0: off.
        QString problem;
    };

    void follow();
    void readMapping();
    void openInput(Input&, ControlInputKind, int port);
    void findDevices();
    void noteAll();
    [[nodiscard]] std::optional<Place> placeOf(const QString& key) const;
    [[nodiscard]] const ParameterInfo& infoAt(const Place&) const;
    [[nodiscard]] const Value& valueOf(const Place&) const;
    /// Gives the control to the parameter that waits for one.
    void takeLearned(const ControlMove&);
    void set(const QString& key, Mapped&, const Value&);
    void keep(const QString& key, const QString& control);

    const Museum& museum_;
    History& history_;
    Preferences& preferences_;
    Open open_;
    Input osc_, midi_;
    QTimer search_;  ///< Looks for MIDI devices.
    QStringList devices_;
    std::map<QString, Mapped> mapped_;  ///< By the parameter's key.
    std::optional<QStringList> limits_;
    QString learning_;
    std::map<Control, double> known_;  ///< Positions since learning began.
    Gesture gesture_ = 0;
    bool started_ = false;
};

/// Returns the name of a control for people: "CC 21, channel 1" or "/fader/3".
[[nodiscard]] QString controlName(const Control&);

}  // namespace vitrine::ui
