#include "ui/print/print_setup.h"

#include "exhibits/framework/save_bytes.h"
#include "exhibits/framework/state_folder.h"
#include "exhibits/printing/print_json.h"
#include "render/files/read_file.h"

#include <QSettings>
#include <QUndoCommand>

namespace vitrine::ui {
namespace {

constexpr std::uint64_t mostSettingsBytes = 4U << 20U;

std::filesystem::path rememberedSettings()
{
    return configFolder() / "print.json";
}

/// The sheet's name is no part of a print's settings: its numbers are.
QSettings rememberedNames()
{
    return {QString::fromStdString((stateFolder() / "print.ini").string()), QSettings::IniFormat};
}

const QString sheetKey = QStringLiteral("sheet");

}  // namespace

class PrintStep final : public QUndoCommand {
public:
    PrintStep(PrintSetup& setup, const QString& text, PrintState after, Gesture gesture)
        : QUndoCommand(text), setup_(setup), before_(setup.state()), after_(std::move(after)), gesture_(gesture)
    {
    }

    [[nodiscard]] int id() const override { return gesture_ == 0 ? -1 : gesture_; }
    void redo() override { setup_.show(after_); }
    void undo() override { setup_.show(before_); }
    bool mergeWith(const QUndoCommand* next) override
    {
        after_ = static_cast<const PrintStep*>(next)->after_;
        setObsolete(after_ == before_);
        return true;
    }

private:
    PrintSetup& setup_;
    PrintState before_, after_;
    Gesture gesture_;
};

PrintSetup::PrintSetup(bool canShow, QObject* parent) : QObject(parent), canShow_(canShow)
{
    state_ = possible(state_);
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
    if (after != state_) stack_.push(new PrintStep(*this, text, std::move(after), gesture));
}

void PrintSetup::change(const QString& text, const ParameterValues& values, Gesture gesture)
{
    PrintState after = state_;
    after.values = values;
    change(text, std::move(after), gesture);
}

void PrintSetup::show(const PrintState& state)
{
    const bool views = state.files != state_.files || !printing::sameViews(state_.values, state.values);
    state_ = state;
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
    for (const std::string& file : settings.sources) loaded.files << QString::fromStdString(file);
    change(tr("Load settings"), std::move(loaded));
    QStringList notes;
    for (const std::string& note : settings.notes) notes << QString::fromStdString(note);
    return notes;
}

QStringList PrintSetup::recall()
{
    state_.sheet = rememberedNames().value(sheetKey).toString().toStdString();
    emit changed(true);
    QStringList notes;
    std::error_code ignored;
    if (std::filesystem::exists(rememberedSettings(), ignored))
        notes = load(render::readFile(rememberedSettings(), mostSettingsBytes), rememberedSettings().string());
    stack_.clear();
    return notes;
}

void PrintSetup::remember() const
{
    savePresetBytes(rememberedSettings(), text());
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
