#include "ui/window/search_entries.h"

#include "ui/kit/language.h"
#include "ui/kit/menu_text.h"
#include "ui/kit/text.h"
#include "ui/lessons/page_dialog.h"
#include "ui/presets/preset_controller.h"
#include "ui/presets/recent_presets.h"
#include "ui/window/main_window.h"
#include "ui/window/window_dialogs.h"
#include "ui/window/window_docks.h"

#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QRegularExpression>

namespace vitrine::ui {
namespace {

QString plainTitle(const QMenu& menu)
{
    return menu.title().remove(QLatin1Char('&'));
}

/// Adds the commands of the menu bar, and with the title of their menu those of its submenus.
void addCommands(std::vector<SearchEntry>& all, const MainWindow& window, const QList<QAction*>& commands)
{
    for (const QMenu* menu : window.menuBar()->findChildren<QMenu*>())
        for (QAction* action : menu->actions()) {
            if (action->menu() || action->isSeparator() || !action->isEnabled()) continue;
            all.push_back({nameText(*action),
                           plainTitle(*menu),
                           action->toolTip(),
                           {},
                           keysText(*action),
                           commands.contains(action),
                           [chosen = QPointer<QAction>(action)] {
                               if (chosen) chosen->trigger();
                           }});
        }
}

void addParameters(std::vector<SearchEntry>& all, MainWindow& window, std::size_t subject)
{
    const QString title = translatedText(window.museum().subject(subject).title());
    const ParameterValues& values = window.history().sceneState().values[subject];
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const ParameterInfo& parameter = values.rows()[i];
        const QString group = translatedText(parameter.group);
        QStringList more{text(parameter.name)};
        for (const std::string_view choice : parameter.choices) more << translatedText(choice);
        all.push_back(
            {translatedText(label(parameter)),
             group.isEmpty() ? title : QObject::tr("%1: %2").arg(title, group),
             translatedText(parameter.help),
             more.join(QLatin1Char(' ')),
             {},
             false,
             [&window, subject, name = std::string(parameter.name)] { window.showParameter(subject, name); }});
        if (!parameter.qualityReference) continue;
        all.back().measure = [&window, subject, i, show = all.back().go] {
            show();
            window.docks().measureAccuracy(subject, i);
        };
        all.back().figure = [&window, subject, i, show = all.back().go] {
            show();
            window.docks().measureIntoFigure(subject, i);
        };
    }
}

void addPresets(std::vector<SearchEntry>& all, MainWindow& window, std::size_t subject)
{
    const QString place = QObject::tr("Preset of %1").arg(translatedText(window.museum().subject(subject).title()));
    const QStringList recent = recentPresets();
    for (const auto& [name, id] : window.presetController().choices(subject)) {
        all.push_back(
            {name, place, {}, {}, {}, false, [&window, preset = id] { window.presetController().loadOfAny(preset); }});
        all.back().recent = static_cast<int>(recent.indexOf(id)) + 1;
    }
}

/// Returns the text of a page without its formatting.
QString textOfPage(const QString& name)
{
    QFile file(PageDialog::pathOf(name));
    static const QRegularExpression tags(QStringLiteral("<[^>]*>"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).replace(tags, QStringLiteral(" "))
                                          : QString();
}

void addPage(std::vector<SearchEntry>& all, const MainWindow& window, std::size_t subject)
{
    const SceneObject& about = window.museum().subject(subject);
    all.push_back({QObject::tr("How it works: %1").arg(translatedText(about.title())),
                   QObject::tr("Page"),
                   translatedText(about.summary()),
                   textOfPage(text(about.name())),
                   {},
                   false,
                   [&window, subject] { window.dialogs().openPage(subject); }});
}

}  // namespace

std::vector<SearchEntry> searchEntries(MainWindow& window, const QList<QAction*>& commands)
{
    std::vector<SearchEntry> all;
    addCommands(all, window, commands);
    const std::size_t subjects = window.museum().subjects().size();
    for (std::size_t i = 0; i < subjects; ++i) {
        addParameters(all, window, i);
        addPresets(all, window, i);
        addPage(all, window, i);
    }
    return all;
}

}  // namespace vitrine::ui
