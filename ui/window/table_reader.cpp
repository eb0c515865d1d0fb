#include "ui/window/table_reader.h"

#include "exhibits/museum/museum.h"
#include "ui/kit/language.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

namespace vitrine::ui {

TableReader::TableReader(Workbench& window, QObject* parent) : QObject(parent), window_(window), asked_(named())
{
    History& history = window.history();
    connect(&history, &History::changed, this, [this, &history](std::size_t exhibit, std::size_t row) {
        if (history.sceneState().values[exhibit].rows()[row].addsParameters) read();
    });
    connect(&history, &History::replaced, this, &TableReader::read);
    connect(&window.viewport().scene(), &PresentScene::filesChanged, this, &TableReader::readAgain);
}

std::vector<TableReader::Named> TableReader::named() const
{
    std::vector<Named> all;
    for (const ParameterValues& values : window_.history().sceneState().values)
        if (std::vector<std::string> files = values.tableFiles(); !files.empty())
            all.push_back({std::move(files), values.sharedTable()});
    return all;
}

void TableReader::read()
{
    if (!taking_ && named() != asked_) readAgain();
}

void TableReader::readAgain()
{
    asked_ = named();
    if (asked_.empty()) {
        window_.setProblems(QStringLiteral("files that give parameters"), {});
        return;
    }
    window_.viewport().renderThread().post(
        [this, &museum = window_.museum(), sceneState = window_.history().sceneState()]() -> std::function<void()> {
            auto tabled = std::make_shared<const TabledSceneState>(museum.readTables(sceneState));
            return [this, tabled] { take(*tabled); };
        });
}

void TableReader::take(const TabledSceneState& tabled)
{
    QStringList unreadable;
    for (const Message& why : tabled.unreadable) unreadable << translatedText(why);
    window_.setProblems(QStringLiteral("files that give parameters"), unreadable);
    for (const std::string& note : tabled.notes) window_.say(MessageStrip::Mood::notice, translatedText(note));
    taking_ = true;
    window_.history().exchangeTables(tabled.sceneState);
    taking_ = false;
    asked_ = named();
}

}  // namespace vitrine::ui

#include "moc_table_reader.cpp"
