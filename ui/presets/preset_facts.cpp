#include "ui/presets/preset_facts.h"

#include "exhibits/framework/table/value_text.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/text.h"
#include "ui/presets/preset_files.h"

#include <QDateTime>
#include <QFileInfo>
#include <QLocale>

namespace vitrine::ui {
namespace {

QString wordsOf(const ParameterInfo& parameter, const Value& value)
{
    if (parameter.kind == Kind::toggle)
        return std::get<double>(value) != 0 ? PresetPreview::tr("on") : PresetPreview::tr("off");
    const QString unit = text(info(parameter.unit).symbol);
    const QString shown = translatedText(formatValue(parameter, value));
    return unit.isEmpty() || !parameter.isNumeric() ? shown : shown + QLatin1Char(' ') + unit;
}

}  // namespace

PresetFacts presetFacts(const PresetStore& store, const std::filesystem::path& path, const std::string& exhibit,
                        const Parameters& table)
{
    PresetFacts facts;
    const QString file = QString::fromStdString(path.string());
    facts.name = QString::fromStdString(path.stem().string());
    facts.picture.load(QString::fromStdString(PresetStore::thumbnailPath(path).string()));
    try {
        const StoredPreset stored = store.load(path, exhibit, table);
        const Preset& preset = stored.preset;
        if (!preset.name.empty()) facts.name = presetName(preset.name, stored.shipped);
        facts.origin = stored.shipped
                           ? PresetPreview::tr("Supplied with the exhibit: it can be duplicated, but not changed.")
                           : PresetPreview::tr("Yours, saved on %1.")
                                 .arg(QLocale().toString(QFileInfo(file).lastModified(), QLocale::ShortFormat));
        facts.tags = presetTags(preset.tags, stored.shipped);
        const auto& rows = preset.values.rows();
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (preset.values.motion(i))
                facts.differences << PresetPreview::tr("%1 moves").arg(translatedText(label(rows[i])));
            else if (!preset.values.isInitial(i))
                facts.differences << PresetPreview::tr("%1: %2").arg(translatedText(label(rows[i])),
                                                                     wordsOf(rows[i], preset.values.row(i)));
        }
        // Values of parameters that a file will add to the table.
        for (const auto& [name, json] : preset.values.pending())
            facts.differences << PresetPreview::tr("%1: %2").arg(QString::fromStdString(name),
                                                                 QString::fromStdString(json).trimmed());
    } catch (const std::exception& thrown) {
        facts.problem = messageOf(thrown);
    }
    return facts;
}

}  // namespace vitrine::ui
