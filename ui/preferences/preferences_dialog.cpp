#include "ui/preferences/preferences_dialog.h"

#include "ui/kit/language.h"
#include "ui/kit/scroll_room.h"
#include "ui/parameters/parameter_row.h"
#include "ui/preferences/keys_page.h"
#include "ui/viewport/adaptive_scale.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {

PreferencesDialog::PreferencesDialog(Preferences& preferences, KeyBindings& keys, QWidget* parent)
    : QDialog(parent), preferences_(preferences), tabs_(new QTabWidget(this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Preferences"));
    tabs_->setAccessibleName(tr("Preferences"));
    tabs_->setDocumentMode(true);
    addWindowPage();
    addPicturePage();
    tabs_->addTab(new KeysPage(keys, this), tr("Keys"));
    addControllersPage();
    addFilesPage();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    // Enter in a number field confirms the number only.
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    buttons->setContentsMargins(8, 0, 8, 0);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 8);
    layout->addWidget(tabs_, 1);
    layout->addWidget(buttons);
    connect(&preferences_, &Preferences::changed, this, &PreferencesDialog::showAll);
    showAll();
    tabs_->tabBar()->setFocus();
}

QGridLayout* PreferencesDialog::page(const QString& title)
{
    auto* content = new QWidget;
    auto* whole = new QVBoxLayout(content);
    whole->setContentsMargins(16, 16, 16, 16);
    auto* lines = new QGridLayout;
    lines->setHorizontalSpacing(8);
    lines->setVerticalSpacing(8);
    lines->setColumnStretch(1, 1);
    whole->addLayout(lines);
    whole->addStretch(1);
    tabs_->addTab(new ScrollRoom(content), title);
    return lines;
}

void PreferencesDialog::addWindowPage()
{
    QGridLayout& lines = *page(tr("Window"));
    addChoice(
        lines,
        {tr("Theme"),
         tr("Colors of panels and dialogs. “As the desktop” also follows its contrast setting; high contrast is light "
            "or dark like the desktop.")},
        {{0, tr("As the desktop")}, {1, tr("Light", "theme")}, {2, tr("Dark")}, {3, tr("High contrast")}},
        [](const PreferenceValues& values) { return static_cast<int>(values.theme); },
        [](PreferenceValues& values, int choice) { values.theme = static_cast<ThemeChoice>(choice); });
    addLanguage(lines);
    addNumber(lines, {tr("Size of type"), tr("Text size of the window, relative to the desktop's.")}, tr(" %"), 10,
              PreferenceValues::typeSizes, &PreferenceValues::typeSize);
    addChoice(
        lines,
        {tr("Motion"),
         tr("Motion of the window. Reduced: the camera jumps instead of gliding, panels do not slide, messages do not "
            "fade, and the exhibits' clock is paused until you start it (Space in the picture) or press an exhibit's "
            "button. Walking and dragging are not affected.")},
        {{0, tr("As the desktop")}, {1, tr("Reduced")}, {2, tr("Full")}},
        [](const PreferenceValues& values) { return static_cast<int>(values.motion); },
        [](PreferenceValues& values, int choice) { values.motion = static_cast<MotionChoice>(choice); });
}

void PreferencesDialog::addPicturePage()
{
    QGridLayout& lines = *page(tr("Picture and mouse"));
    const auto number = [](int PreferenceValues::*member) {
        return std::pair([member](const PreferenceValues& values) { return values.*member; },
                         [member](PreferenceValues& values, int value) { values.*member = value; });
    };
    Choices samples{{PreferenceValues::sampleLimits.initial, tr("As set in the hall")}};
    for (const int most : {64, 32, 16, 8, 4, 2, 1}) samples.emplace_back(most, tr("%n at most", nullptr, most));
    const auto [samplesOf, setSamples] = number(&PreferenceValues::mostSamples);
    addChoice(lines,
              {tr("Samples when idle"),
               tr("Largest number of samples per pixel in the window when nothing moves: few finish sooner and leave "
                  "rougher edges. Exports, recordings and prints have their own.")},
              samples, samplesOf, setSamples);
    Choices scales;
    for (const double scale : AdaptiveScale::scales) {
        const int percent = static_cast<int>(std::lround(scale * 100));
        scales.insert(scales.begin(), {percent, tr("%1 % at least").arg(percent)});
    }
    const auto [scaleOf, setScale] = number(&PreferenceValues::leastScale);
    addChoice(lines,
              {tr("Resolution in motion"),
               tr("Resolution of the picture while something moves: high is sharper, with fewer frames per second on a "
                  "slow machine.")},
              scales, scaleOf, setScale);
    addNumber(lines, {tr("Speed of looking"), tr("Angle by which dragging turns the view, or orbits an exhibit.")},
              tr(" %"), 5, PreferenceValues::lookSpeeds, &PreferenceValues::lookSpeed);
    addSwitch(lines, tr("Dragging down looks up"),
              tr("Reverses the direction in which dragging up or down turns the view."),
              &PreferenceValues::invertedLook);
    addNumber(lines,
              {tr("Speed of the wheel"), tr("Distance by which one step of the mouse wheel approaches an exhibit.")},
              tr(" %"), 5, PreferenceValues::wheelSpeeds, &PreferenceValues::wheelSpeed);
}

void PreferencesDialog::addControllersPage()
{
    QGridLayout& lines = *page(tr("Controllers"));
    QSpinBox* port =
        addNumber(lines,
                  {tr("OSC port"), tr("UDP port at which OSC controllers, such as an app on a tablet, are listened to; "
                                      "usual is 9000. Every program on your network can then move the parameters that "
                                      "have learned a controller.")},
                  {}, 1, PreferenceValues::oscPorts, &PreferenceValues::oscPort);
    port->setSpecialValueText(tr("Off"));
    addSwitch(lines, tr("MIDI devices"), tr("Reads all MIDI devices of this machine, also those plugged in later."),
              &PreferenceValues::midi);
    auto* words =
        new QLabel(tr("To give a control to a parameter, choose “Learn controller” in the menu of the parameter "
                      "(right click or Shift+F10), then move the control."),
                   this);
    words->setTextFormat(Qt::PlainText);
    words->setWordWrap(true);
    lines.addWidget(words, lines.rowCount(), 0, 1, 3);
    auto* forget = new QPushButton(tr("Forget all controllers"), this);
    forget->setToolTip(tr("Forgets which control moves which parameter."));
    forget->setAutoDefault(false);
    connect(forget, &QPushButton::clicked, this,
            [this] { change([](PreferenceValues& values) { values.controllers.clear(); }); });
    lines.addWidget(forget, lines.rowCount(), 1, Qt::AlignLeft);
}

void PreferencesDialog::addFilesPage()
{
    QGridLayout& lines = *page(tr("Files"));
    addNumber(lines, {tr("Recent files"), tr("Number of files listed in File > Open recent; 0 lists none.")}, {}, 1,
              PreferenceValues::recentCounts, &PreferenceValues::recentFiles);
    auto* forget = new QPushButton(tr("Clear the list now"), this);
    forget->setToolTip(tr("Clears the list of recent files; the files themselves are kept."));
    forget->setAutoDefault(false);
    connect(forget, &QPushButton::clicked, this, &PreferencesDialog::forgetRecentAsked);
    lines.addWidget(forget, lines.rowCount(), 1, Qt::AlignLeft);
}

void PreferencesDialog::addLine(QGridLayout& lines, const LineTexts& texts, QWidget& control,
                                std::function<void(const PreferenceValues&)> show,
                                std::function<bool(const PreferenceValues&)> differs,
                                std::function<void(PreferenceValues&)> reset)
{
    const int row = lines.rowCount();
    if (!texts.label.isEmpty()) {
        auto* words = new QLabel(texts.label, this);
        words->setBuddy(&control);
        words->setToolTip(texts.tip);
        control.setAccessibleName(texts.label);
        lines.addWidget(words, row, 0);
    }
    control.setToolTip(texts.tip);
    control.setAccessibleDescription(texts.tip);
    control.setFocusPolicy(Qt::StrongFocus);
    lines.addWidget(&control, row, 1);
    auto* dot = new ResetDot(this);
    dot->setAccessibleName(tr("Reset %1").arg(control.accessibleName()));
    dot->setToolTip(dot->accessibleName());
    lines.addWidget(dot, row, 2);
    connect(dot, &QAbstractButton::clicked, this, [this, reset = std::move(reset)] { change(reset); });
    shows_.push_back(
        [&control, dot, show = std::move(show), differs = std::move(differs)](const PreferenceValues& values) {
            const QSignalBlocker quiet(&control);
            show(values);
            dot->setDiffers(differs(values));
        });
}

void PreferencesDialog::addChoice(QGridLayout& lines, const LineTexts& texts, const Choices& choices,
                                  std::function<int(const PreferenceValues&)> value,
                                  std::function<void(PreferenceValues&, int)> set)
{
    auto* box = new QComboBox(this);
    for (const auto& [number, words] : choices) box->addItem(words, number);
    connect(box, &QComboBox::activated, this, [this, box, set](int index) {
        change([&](PreferenceValues& values) { set(values, box->itemData(index).toInt()); });
    });
    const int initial = value(PreferenceValues());
    addLine(
        lines, texts, *box,
        [box, value](const PreferenceValues& values) {
            const int number = value(values);
            // The file may have another number, edited by hand.
            if (box->findData(number) < 0) box->addItem(QString::number(number), number);
            box->setCurrentIndex(box->findData(number));
        },
        [value, initial](const PreferenceValues& values) { return value(values) != initial; },
        [set, initial](PreferenceValues& values) { set(values, initial); });
}

QSpinBox* PreferencesDialog::addNumber(QGridLayout& lines, const LineTexts& texts, const QString& unit, int step,
                                       PreferenceRange range, int PreferenceValues::*member)
{
    auto* box = new QSpinBox(this);
    box->setRange(range.least, range.most);
    box->setSingleStep(step);
    box->setSuffix(unit);
    box->setKeyboardTracking(false);  // An incomplete number is not applied.
    connect(box, &QSpinBox::valueChanged, this,
            [this, member](int value) { change([&](PreferenceValues& values) { values.*member = value; }); });
    addLine(
        lines, texts, *box, [box, member](const PreferenceValues& values) { box->setValue(values.*member); },
        [member, range](const PreferenceValues& values) { return values.*member != range.initial; },
        [member, range](PreferenceValues& values) { values.*member = range.initial; });
    return box;
}

void PreferencesDialog::addSwitch(QGridLayout& lines, const QString& words, const QString& tip,
                                  bool PreferenceValues::*member)
{
    auto* box = new QCheckBox(words, this);
    box->setAccessibleName(words);
    // `clicked` is not used, because screen readers toggle without a click.
    connect(box, &QCheckBox::toggled, this,
            [this, member](bool on) { change([&](PreferenceValues& values) { values.*member = on; }); });
    addLine(
        lines, {{}, tip}, *box,
        [box, member](const PreferenceValues& values) {
            const QSignalBlocker quiet(box);
            box->setChecked(values.*member);
        },
        [member](const PreferenceValues& values) { return values.*member != PreferenceValues().*member; },
        [member](PreferenceValues& values) { values.*member = PreferenceValues().*member; });
}

void PreferencesDialog::addLanguage(QGridLayout& lines)
{
    auto* box = new QComboBox(this);
    box->addItem(tr("As the system"), QString());
    for (const QString& code : languages()) box->addItem(nameOfLanguage(code), code);
    const auto keep = [this](const QString& code) {
        keepLanguage(code);
        showAll();
    };
    connect(box, &QComboBox::activated, this, [box, keep](int index) { keep(box->itemData(index).toString()); });
    addLine(
        lines,
        {tr("Language"),
         tr("Language of the window, from its next start. Files and the numbers in them do not change.")},
        *box, [box](const PreferenceValues&) { box->setCurrentIndex(std::max(box->findData(savedLanguage()), 0)); },
        [](const PreferenceValues&) { return !savedLanguage().isEmpty(); }, [keep](PreferenceValues&) { keep({}); });
}

void PreferencesDialog::change(const std::function<void(PreferenceValues&)>& how)
{
    PreferenceValues values = preferences_.values();
    how(values);
    preferences_.set(values);
}

void PreferencesDialog::showAll()
{
    for (const auto& show : shows_) show(preferences_.values());
}

}  // namespace vitrine::ui

#include "moc_preferences_dialog.cpp"
