#include "ui/preset_shelf.h"

#include "ui/main_window.h"
#include "ui/preset_list.h"

namespace vitrine::ui {

PresetShelf::PresetShelf(MainWindow& window, PresetList& list) : QObject(&window), window_(window), list_(list) {}
void PresetShelf::refresh() {}
void PresetShelf::load(const QString&) {}
void PresetShelf::save() {}
void PresetShelf::saveAs() {}
void PresetShelf::rename() {}
void PresetShelf::duplicate() {}
void PresetShelf::remove() {}
void PresetShelf::importFile() {}
void PresetShelf::exportFile() {}
void PresetShelf::saveExhibition() {}
void PresetShelf::loadFile(const QString&) {}
bool PresetShelf::loadFromPicture(const QString&) { return false; }
bool PresetShelf::loadText(const std::string&, const QString&) { return false; }
std::string PresetShelf::lookText() const { return {}; }

}  // namespace vitrine::ui

#include "moc_preset_shelf.cpp"
