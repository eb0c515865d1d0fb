#include "ui/print/print_setup.h"

#include "exhibits/framework/files/state_folder.h"
#include "exhibits/printing/print_json.h"
#include "render/files/read_file.h"
#include "ui/kit/language.h"

#include <utility>

namespace vitrine::ui {
namespace {

constexpr std::uint64_t mostSettingsBytes = 4U << 20U;

std::filesystem::path rememberedSettings()
{
    return configFolder() / "print.json";
}

}  // namespace

PrintSetup::PrintSetup(bool canShow, QObject* parent) : QObject(parent), canShow_(canShow)
{
    values_ = possible(values_);
    history_.restart({{values_}, {}});
    connect(&history_, &History::changed, this, &PrintSetup::follow);
    connect(&history_, &History::replaced, this, &PrintSetup::follow);
}

PrintSetup::~PrintSetup()
{
    stack().disconnect(this);  // A stack that is destroyed emits signals.
}

ParameterValues PrintSetup::possible(ParameterValues values) const
{
    using printing::ViewOrigin;
    const auto& origin = printing::printTable().origin;
    // A chart is a tab of the dialog, and not an origin of the views.
    if (values[origin] == ViewOrigin::chart || (!canShow_ && values[origin] == ViewOrigin::shown))
        values.set(origin, canShow_ ? ViewOrigin::shown : ViewOrigin::files);
    return values;
}

void PrintSetup::change(const QString& text, ParameterValues after, Gesture gesture)
{
    after = possible(std::move(after));
    if (after == values_) return;
    history_.change(text, {{std::move(after)}, {}}, gesture);
}

void PrintSetup::follow()
{
    ParameterValues now = possible(history_.sceneState().values[0]);
    if (now == values_) return;
    const bool views = !printing::sameViews(values_, now);
    values_ = std::move(now);
    emit changed(views);
}

QStringList PrintSetup::pictures() const
{
    QStringList files;
    for (const std::string& file : printing::picturesOf(values_)) files << QString::fromStdString(file);
    return files;
}

std::string PrintSetup::text() const
{
    return printing::settingsText(values_);
}

QStringList PrintSetup::load(const std::string& text, const std::string& fileName)
{
    const printing::SavedSettings settings = printing::savedSettings(text, fileName);
    change(tr("Load settings"), settings.values);
    QStringList notes;
    for (const std::string& note : settings.notes) notes << translatedText(note);
    return notes;
}

QStringList PrintSetup::recall()
{
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
}

std::vector<std::string> textsOf(const QStringList& files)
{
    std::vector<std::string> texts;
    for (const QString& file : files) texts.push_back(file.toStdString());
    return texts;
}

}  // namespace vitrine::ui

#include "moc_print_setup.cpp"
