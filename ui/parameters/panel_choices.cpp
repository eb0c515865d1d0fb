#include "ui/parameters/panel_choices.h"

namespace vitrine::ui {

void PanelChoices::set(PanelChoice choice, const QStringList& keys, bool on)
{
    QSet<QString>& chosen = keys_[static_cast<std::size_t>(choice)];
    for (const QString& key : keys) {
        if (on)
            chosen.insert(key);
        else
            chosen.remove(key);
    }
    emit changed(choice);
}

QStringList PanelChoices::list(PanelChoice choice) const
{
    QStringList all(of(choice).begin(), of(choice).end());
    all.sort();
    return all;
}

void PanelChoices::setList(PanelChoice choice, const QStringList& keys)
{
    keys_[static_cast<std::size_t>(choice)] = QSet<QString>(keys.begin(), keys.end());
    emit changed(choice);
}

}  // namespace vitrine::ui

#include "moc_panel_choices.cpp"
