#include "ui/sprites/sprite_setup.h"

#include "ui/kit/ini_file.h"

#include "exhibits/framework/preset_values.h"
#include "exhibits/framework/state_folder.h"

#include <QSettings>

namespace vitrine::ui {
namespace {

QSettings rememberedSprites()
{
    return {iniPath(QString::fromStdString((stateFolder() / "sprites.ini").string())), QSettings::IniFormat};
}

QString rowKey(const ParameterInfo& row)
{
    return QStringLiteral("values/") + QString::fromUtf8(row.name.data(), static_cast<qsizetype>(row.name.size()));
}

const QString animationKey = QStringLiteral("animation");

}  // namespace

SpriteSetup::SpriteSetup(QObject* parent) : QObject(parent)
{
    connect(&history_, &History::changed, this, &SpriteSetup::changed);
    connect(&history_, &History::replaced, this, &SpriteSetup::changed);
}

void SpriteSetup::setAnimation(const std::string& name)
{
    if (name == animation_) return;
    animation_ = name;
    emit changed();
}

void SpriteSetup::change(const QString& text, const ParameterValues& values)
{
    history_.change(text, {{values}, {}});
}

void SpriteSetup::recall()
{
    const QSettings kept = rememberedSprites();
    ParameterValues values = spriteTable().initial();
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const QVariant text = kept.value(rowKey(values.rows()[i]));
        std::vector<std::string> ignored;
        if (!text.isValid()) continue;
        if (const auto value = valueFromText(values.rows()[i], text.toString().toStdString(), ignored))
            values.setRow(i, *value);
    }
    animation_ = kept.value(animationKey).toString().toStdString();
    history_.restart({{values}, {}});
    emit changed();
}

void SpriteSetup::remember() const
{
    QSettings kept = rememberedSprites();
    kept.remove(QStringLiteral("values"));
    for (std::size_t i = 0; i < values().rows().size(); ++i)
        if (!values().isInitial(i))
            kept.setValue(rowKey(values().rows()[i]),
                          QString::fromStdString(jsonFromValue(values().rows()[i], values().row(i)).dump()));
    kept.setValue(animationKey, QString::fromStdString(animation_));
}

}  // namespace vitrine::ui

#include "moc_sprite_setup.cpp"
