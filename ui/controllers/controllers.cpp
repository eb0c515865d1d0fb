#include "ui/controllers/controllers.h"

#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/parameters/shown_text.h"

#include <QSocketNotifier>

#include <algorithm>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int firstOpened = 2000;        // Milliseconds after the start.
constexpr int searchEvery = 2000;        // Milliseconds between two searches for MIDI devices.
constexpr std::size_t mostKnown = 1000;  // Controls that are remembered while one is learned.

}  // namespace

QString controlName(const Control& control)
{
    switch (control.kind) {
    case Control::Kind::osc: {
        const QString address = QString::fromStdString(control.address);
        return control.channel == 1 ? address : Controllers::tr("%1, number %2").arg(address).arg(control.channel);
    }
    case Control::Kind::controlChange:
        return Controllers::tr("CC %1, channel %2").arg(control.number).arg(control.channel);
    case Control::Kind::note: return Controllers::tr("Key %1, channel %2").arg(control.number).arg(control.channel);
    case Control::Kind::pitchBend: return Controllers::tr("Pitch bend, channel %1").arg(control.channel);
    }
    return {};
}

Controllers::Controllers(const Museum& museum, History& history, Preferences& preferences, QObject* parent, Open open)
    : QObject(parent), museum_(museum), history_(history), preferences_(preferences), open_(std::move(open))
{
    readMapping();
    search_.setInterval(searchEvery);
    connect(&search_, &QTimer::timeout, this, &Controllers::findDevices);
    connect(&preferences_, &Preferences::changed, this, [this] {
        readMapping();
        started_ = true;  // A switch has its effect at once.
        follow();
    });
    // A control whose parameter was changed otherwise waits again, which its note says.
    connect(&history_, &History::changesSettled, this, &Controllers::noteAll);
    QTimer::singleShot(firstOpened, this, [this] {
        if (!std::exchange(started_, true)) follow();
    });
}

Controllers::~Controllers()
{
    for (Input* each : {&osc_, &midi_}) delete each->notifier;  // Before its descriptor is closed.
}

void Controllers::readMapping()
{
    const QMap<QString, QString>& kept = preferences_.values().controllers;
    std::map<QString, Mapped> mapped;
    for (auto entry = kept.begin(); entry != kept.end(); ++entry) {
        const std::optional<Control> control = controlFrom(entry.value().toStdString());
        if (!control) continue;
        const auto before = mapped_.find(entry.key());
        if (limits_ && !limits_->contains(entry.key())) continue;
        const bool same = before != mapped_.end() && before->second.control == *control;
        mapped.emplace(entry.key(), same ? before->second : Mapped{*control, {}});
    }
    const std::map<QString, Mapped> old = std::exchange(mapped_, std::move(mapped));
    for (const auto& [key, one] : old) emit noteChanged(key);
    noteAll();
}

void Controllers::follow()
{
    const PreferenceValues& values = preferences_.values();
    if (osc_.port == values.oscPort && (midi_.port != 0) == values.midi) return;
    openInput(osc_, ControlInputKind::osc, values.oscPort);
    openInput(midi_, ControlInputKind::midi, values.midi ? 1 : 0);
    if (midi_.input)
        search_.start();
    else
        search_.stop();
    if (!osc_.input && !midi_.input) learn({});
    QStringList problems;
    for (const Input* each : {&osc_, &midi_})
        if (!each->problem.isEmpty()) problems << each->problem;
    emit problemsChanged(problems);
    findDevices();
    emit listeningChanged();
}

void Controllers::openInput(Input& input, ControlInputKind kind, int port)
{
    if (input.port == port) return;
    delete input.notifier;
    input = {};
    input.port = port;
    if (port == 0) return;
    try {
        input.input = open_(kind, port);
    } catch (const std::exception& thrown) {
        input.problem = messageOf(thrown);
        return;
    }
    input.notifier = new QSocketNotifier(input.input->descriptor(), QSocketNotifier::Read, this);
    connect(input.notifier, &QSocketNotifier::activated, this,
            [this, source = input.input.get()] { take(source->read()); });
}

void Controllers::findDevices()
{
    QStringList names;
    if (midi_.input)
        for (const std::string& name : midi_.input->devices()) names << QString::fromStdString(name);
    if (names == devices_) return;
    devices_ = names;
    emit listeningChanged();
}

QStringList Controllers::listening() const
{
    QStringList texts;
    if (osc_.input) texts << tr("OSC %1").arg(osc_.port);
    if (midi_.input) texts << tr("MIDI %1").arg(devices_.size());
    return texts;
}

std::optional<Controllers::Place> Controllers::placeOf(const QString& key) const
{
    const qsizetype slash = key.indexOf(QLatin1Char('/'));
    const std::optional<std::size_t> subject = museum_.find(key.left(slash).toStdString());
    if (slash < 0 || !subject) return {};
    const auto row = history_.sceneState().values[*subject].table().find(key.mid(slash + 1).toStdString());
    if (!row) return {};
    return Place{*subject, *row};
}

const ParameterInfo& Controllers::infoAt(const Place& place) const
{
    return history_.sceneState().values[place.subject].rows()[place.row];
}

const Value& Controllers::valueOf(const Place& place) const
{
    return history_.sceneState().values[place.subject].row(place.row);
}

bool Controllers::mayLearn(const QString& key) const
{
    const std::optional<Place> place = placeOf(key);
    return place && isMovable(infoAt(*place)) && !limits_;
}

ParameterNote Controllers::note(const QString& key) const
{
    if (isLearning(key))
        return {tr("Move a control of your controller…"),
                tr("The next control that moves will move this parameter. Its menu ends the learning.")};
    const auto found = mapped_.find(key);
    const std::optional<Place> place = placeOf(key);
    if (found == mapped_.end() || !place || !isMovable(infoAt(*place))) return {};
    const QString name = controlName(found->second.control);
    const std::optional<double> at = found->second.takeover.waitingAt(valueOf(*place));
    if (!at) return {name, tr("Moved by %1. The menu of the parameter forgets it.").arg(name)};
    const ParameterInfo& info = infoAt(*place);
    const QString stands = shownText(info, valueAt(info, *at));
    return {tr("%1, at %2").arg(name, stands),
            tr("%1 stands at %2. Move it to the present value, %3; from there on it moves the parameter.")
                .arg(name, stands, shownText(info, valueOf(*place)))};
}

void Controllers::learn(const QString& key)
{
    if (!key.isEmpty() && !osc_.input && !midi_.input) {
        emit nothingListens();
        return;
    }
    known_.clear();
    const QString before = std::exchange(learning_, key);
    if (!before.isEmpty()) emit noteChanged(before);
    if (!key.isEmpty()) emit noteChanged(key);
}

void Controllers::limitTo(const QStringList& keys)
{
    limits_ = keys;
    learn({});
    readMapping();
}

void Controllers::forget(const QString& key)
{
    keep(key, {});
}

void Controllers::keep(const QString& key, const QString& control)
{
    PreferenceValues values = preferences_.values();
    if (control.isEmpty())
        values.controllers.remove(key);
    else
        values.controllers.insert(key, control);
    preferences_.set(values);
}

void Controllers::takeLearned(const ControlMove& move)
{
    const auto known = known_.find(move.control);
    const bool isKnown = known != known_.end();
    // A message with several numbers, such as that of a pad, moves the control whose number changes.
    const bool chosen = move.alone || (isKnown && known->second != move.position);
    if (!isKnown && known_.size() < mostKnown) known_.emplace(move.control, move.position);
    if (!chosen) return;
    const QString key = std::exchange(learning_, {});
    keep(key, QString::fromStdString(controlText(move.control)));
    emit noteChanged(key);
}

void Controllers::take(const std::vector<ControlMessage>& messages)
{
    std::map<QString, Value> next;  // Newest values only: a message may come for each millisecond.
    for (const ControlMessage& message : messages)
        for (const ControlMove& move : decode(message)) {
            if (!learning_.isEmpty()) takeLearned(move);
            for (auto& [key, mapped] : mapped_) {
                const std::optional<Place> place = mapped.control == move.control ? placeOf(key) : std::nullopt;
                if (!place || !isMovable(infoAt(*place))) continue;
                const auto made = next.find(key);
                const Value& present = made == next.end() ? valueOf(*place) : made->second;
                if (const auto value = mapped.takeover.move(infoAt(*place), present, move.position))
                    next.insert_or_assign(key, *value);
                emit noteChanged(key);
            }
        }
    for (const auto& [key, value] : next) set(key, mapped_.at(key), value);
}

void Controllers::set(const QString& key, Mapped& mapped, const Value& value)
{
    const std::optional<Place> place = placeOf(key);
    if (!place) return;
    // Two controls that are moved at the same time alternate, and stay in one step.
    const bool goesOn = mapped.since.isValid() && mapped.since.elapsed() <= sameStep;
    if (!goesOn || history_.gesture() != gesture_) gesture_ = newGesture();
    mapped.since.start();
    history_.set(place->subject, place->row, value, gesture_,
                 tr("Change %1 by a controller").arg(midSentence(translatedText(label(infoAt(*place))))));
    emit noteChanged(key);
}

void Controllers::noteAll()
{
    for (const auto& [key, mapped] : mapped_) emit noteChanged(key);
}

}  // namespace vitrine::ui

#include "moc_controllers.cpp"
