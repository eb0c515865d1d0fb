#include "ui/print/print_setup.h"

#include "exhibits/framework/files/state_folder.h"
#include "exhibits/printing/print_json.h"
#include "render/files/read_file.h"
#include "ui/kit/ini_file.h"
#include "ui/kit/language.h"

#include <QSettings>

namespace vitrine::ui {
namespace {

constexpr std::uint64_t mostSettingsBytes = 4U << 20U;

std::filesystem::path rememberedSettings()
{
    return configFolder() / "print.json";
}

/// The sheet's name is stored separately, because a print's settings hold the sheet's numbers only.
QSettings rememberedNames()
{
    return {iniPath(QString::fromStdString((stateFolder() / "print.ini").string())), QSettings::IniFormat};
}

const QString sheetKey = QStringLiteral("sheet");

}  // namespace

PrintSetup::PrintSetup(bool canShow, QObject* parent) : QObject(parent), canShow_(canShow)
{
    state_ = possible(state_);
    history_.restart({{state_.values}, {}});
    connect(&history_, &History::changed, this, &PrintSetup::follow);
    connect(&history_, &History::replaced, this, &PrintSetup::follow);
    connect(&stack(), &QUndoStack::indexChanged, this, &PrintSetup::follow);  // Also changes of files or sheet alone.
}

PrintSetup::~PrintSetup()
{
    stack().disconnect(this);  // A stack that is destroyed emits signals.
}

PrintState PrintSetup::possible(PrintState state) const
{
    const auto& origin = printing::printTable().origin;
    if (!canShow_ && state.values[origin] == printing::ViewOrigin::shown)
        state.values.set(origin, printing::ViewOrigin::files);
    return state;
}

void PrintSetup::change(const QString& text, PrintState after, Gesture gesture)
{
    after = possible(std::move(after));
    if (after == state_) return;
    const SceneState sceneState{{after.values}, {}};
    if (after.files == files_ && after.sheet == sheet_) {
        history_.change(text, sceneState, gesture);
        return;
    }
    const auto set = [this](const QStringList& files, const std::string& sheet) {
        files_ = files;
        sheet_ = sheet;
    };
    history_.record(
        text, sceneState, [set, files = after.files, sheet = after.sheet] { set(files, sheet); },
        [set, files = files_, sheet = sheet_] { set(files, sheet); });
}

void PrintSetup::change(const QString& text, const ParameterValues& values, Gesture gesture)
{
    PrintState after = state_;
    after.values = values;
    change(text, std::move(after), gesture);
}

void PrintSetup::follow()
{
    PrintState now = possible({history_.sceneState().values[0], files_, sheet_});
    if (now == state_) return;
    const bool views = now.files != state_.files || !printing::sameViews(state_.values, now.values);
    state_ = std::move(now);
    emit changed(views);
}

std::string PrintSetup::text() const
{
    return printing::settingsText(state_.values, textsOf(state_.files));
}

QStringList PrintSetup::load(const std::string& text, const std::string& fileName)
{
    const printing::SavedSettings settings = printing::savedSettings(text, fileName);
    PrintState loaded{settings.values, {}, state_.sheet};
    for (const std::string& file : settings.files) loaded.files << QString::fromStdString(file);
    change(tr("Load settings"), std::move(loaded));
    QStringList notes;
    for (const std::string& note : settings.notes) notes << translatedText(note);
    return notes;
}

QStringList PrintSetup::recall()
{
    state_.sheet = sheet_ = rememberedNames().value(sheetKey).toString().toStdString();
    emit changed(true);
    QStringList notes;
    std::error_code ignored;
    if (std::filesystem::exists(rememberedSettings(), ignored))
        notes = load(render::readFile(rememberedSettings(), mostSettingsBytes), rememberedSettings().string());
    stack().clear();
    return notes;
}

void PrintSetup::remember() const
{
    writeOwnFile(rememberedSettings(), text());
    rememberedNames().setValue(sheetKey, QString::fromStdString(state_.sheet));
}

std::vector<std::string> textsOf(const QStringList& files)
{
    std::vector<std::string> texts;
    for (const QString& file : files) texts.push_back(file.toStdString());
    return texts;
}

}  // namespace vitrine::ui

#include "moc_print_setup.cpp"
