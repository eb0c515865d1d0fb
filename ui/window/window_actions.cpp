#include "ui/window/window_actions.h"

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/table/measured_table.h"
#include "exhibits/jobs.h"
#include "exhibits/museum/museum.h"
#include "render/files/manual.h"
#include "ui/compare/compare_actions.h"
#include "ui/compare/compare_controller.h"
#include "ui/editor/document_file.h"
#include "ui/export/copies.h"
#include "ui/export/screenshot.h"
#include "ui/jobs/export_again.h"
#include "ui/kit/language.h"
#include "ui/kit/menu_text.h"
#include "ui/kit/text.h"
#include "ui/lessons/lesson_controller.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/presets/preset_controller.h"
#include "ui/presets/preset_list.h"
#include "ui/record/bookmarks.h"
#include "ui/record/bookmarks_dialog.h"
#include "ui/tree/tree_dock.h"
#include "ui/tree/tree_editor.h"
#include "ui/viewport/viewport.h"
#include "ui/window/about_dialog.h"
#include "ui/window/file_opener.h"
#include "ui/window/focus_areas.h"
#include "ui/window/main_window.h"
#include "ui/window/own_objects_menu.h"
#include "ui/window/parameter_tabs.h"
#include "ui/window/recent_files.h"
#include "ui/window/search_entries.h"
#include "ui/window/shortcut_sheet.h"
#include "ui/window/window_dialogs.h"
#include "ui/window/window_docks.h"
#include "ui/window/window_preferences.h"

#include <QAction>
#include <QDesktopServices>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QUrl>

#include <utility>

namespace vitrine::ui {
namespace {

using Keys = QList<QKeySequence>;

/// Translated text with its English original.
struct Words : QString {
    QByteArray english;
};

/// Makes an id that is the same in every language: "export-picture" from "Export &picture…".
QString idOf(const QByteArray& english)
{
    QString id;
    const QString words = QString::fromUtf8(english).toLower().remove(QLatin1Char('&'));
    for (const QChar c : words)
        if (c.isLetterOrNumber())
            id += c;
        else if (!id.endsWith(QLatin1Char('-')))
            id += QLatin1Char('-');
    while (id.endsWith(QLatin1Char('-'))) id.chop(1);
    return id;
}

}  // namespace

/// Maker of actions, which are added to the menu begun last.
class WindowActions::Maker {
public:
    Maker(MainWindow& window, QList<QAction*>& all) : window_(window), all_(all) {}

    void menu(const QString& title)
    {
        menu_ = window_.menuBar()->addMenu(title);
        menu_->setToolTipsVisible(true);  // Tooltips say why an entry is disabled.
    }
    void separator() { menu_->addSeparator(); }
    void submenu(QMenu* menu) { menu_->addMenu(menu); }
    /// Adds an action. Its id, under which the visitor's own shortcuts are stored, is made from the English text. When
    /// you change that text, give the action its old id by name.
    QAction* add(const Words& text, const Keys& keys, const QString& tip, std::function<void()> work)
    {
        return add(idOf(text.english), text, keys, tip, std::move(work));
    }
    QAction* add(const QString& id, const QString& text, const Keys& keys, const QString& tip,
                 std::function<void()> work)
    {
        auto* action = new QAction(text, &window_);
        action->setObjectName(id);
        action->setShortcuts(keys);
        action->setToolTip(tip);
        action->setStatusTip(tip);
        if (work) QObject::connect(action, &QAction::triggered, &window_, [work](bool) { work(); });
        take(action);
        return action;
    }
    QAction* toggle(const Words& text, const Keys& keys, const QString& tip, std::function<void(bool)> work)
    {
        QAction* action = add(text, keys, tip, {});
        action->setCheckable(true);
        QObject::connect(action, &QAction::toggled, &window_, work);
        return action;
    }
    void take(QAction* action)
    {
        if (menu_) menu_->addAction(action);
        window_.addAction(action);
        all_ << action;
    }
    /// Adds the following actions to no menu: they have keys and are found by the search.
    void noMenu() { menu_ = nullptr; }
    /// Restricts an action's shortcut to the picture having the focus: for plain letters and Tab.
    void inViewport(QAction* action)
    {
        window_.removeAction(action);
        action->setShortcutContext(Qt::WidgetShortcut);
        window_.viewport().addAction(action);
    }

private:
    MainWindow& window_;
    QList<QAction*>& all_;
    QMenu* menu_ = nullptr;
};

namespace {

Words tr(const char* text)
{
    return {MainWindow::tr(text), text};
}

/// Lets the visitor choose a file, and opens it.
void chooseFile(MainWindow& window)
{
    auto* dialog = new QFileDialog(&window, tr("Open"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters(
        {tr("All that can be opened (%1)").arg(FileOpener::openable().join(QLatin1Char(' '))), tr("All files (*)")});
    QObject::connect(dialog, &QFileDialog::fileSelected, &window.files(), &FileOpener::open);
    dialog->open();
}

/// Makes the menu of the bookmarks that are set.
QMenu* bookmarksMenu(QWidget* parent, Bookmarks& bookmarks)
{
    auto* menu = new QMenu(tr("&Go to bookmark"), parent);
    QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, &bookmarks] {
        menu->clear();
        for (int number = 1; number <= Bookmarks::most; ++number)
            if (const QString name = bookmarks.name(number); !name.isEmpty())
                menu->addAction(menuText(name), menu, [&bookmarks, number] { bookmarks.go(number); });
        if (menu->isEmpty()) menu->addAction(tr("There are no bookmarks yet"))->setEnabled(false);
    });
    return menu;
}

/// Changes the exposure of the picture by this many stops.
void expose(MainWindow& window, double stops)
{
    const ParameterValues& hall = window.history().sceneState().hall();
    const std::optional<std::size_t> row = hall.table().find("exposure");
    if (!row) return;  // The museum of a test has another hall.
    const ParameterInfo& info = hall.table().rows()[*row];
    const double next = std::get<double>(hall.row(*row)) + stops;
    window.history().set(hallIndex, *row, nearestLegal(info, next).value_or(hall.row(*row)), newGesture());
}

/// Sets the shown exhibit's parameters to their initial values.
void resetShown(MainWindow& window)
{
    const SceneObject& subject = window.museum().subject(window.shown());
    SceneState next = window.history().sceneState();
    next.values[window.shown()] = subject.parameters().initial();
    window.history().change(tr("Reset %1").arg(translatedText(subject.title())), next);
}

}  // namespace

std::unique_ptr<WindowCommands> makeWindowActions(MainWindow& window)
{
    return std::make_unique<WindowActions>(window);
}

WindowActions::WindowActions(MainWindow& window)
{
    Maker make(window, all);
    addFileMenu(make, window);
    addEditMenu(make, window);
    addPresetMenu(make, window.presetController());
    addViewMenu(make, window);
    addCompareMenu(make, window.comparison().actions());
    addExhibitMenu(make, window);
    addHelpMenu(make, window);
    addWithoutMenu(make, window);
    watch(window);
}

void WindowActions::enableOnly(QAction* action, std::function<bool()> possible, const QString& why)
{
    enableUnless(action, [possible = std::move(possible), why] { return possible() ? QString() : why; });
}

void WindowActions::enableUnless(QAction* action, std::function<QString()> whyNot)
{
    conditional_.push_back({action, std::move(whyNot), action->toolTip()});
}

void WindowActions::refresh() const
{
    for (const Conditional& each : conditional_) {
        const QString whyNot = each.whyNot();
        const QString& tip = whyNot.isEmpty() ? each.tip : whyNot;
        if (whyNot.isEmpty() == each.action->isEnabled() && each.action->toolTip() == tip) continue;
        each.action->setEnabled(whyNot.isEmpty());
        each.action->setToolTip(tip);
        each.action->setStatusTip(each.action->toolTip());
    }
}

void WindowActions::watch(MainWindow& window) const
{
    const auto follow = [this] { refresh(); };
    QObject::connect(&window.history(), &History::changesSettled, &watching_, follow);
    QObject::connect(&window.viewport(), &Viewport::looked, &watching_, follow);
    QObject::connect(&window.presetController(), &PresetController::marked, &watching_, follow);
    QObject::connect(&window.docks().presets(), &PresetList::selectedChanged, &watching_, follow);
    QObject::connect(&window.docks().tree().editor(), &TreeEditor::treeChanged, &watching_, follow);
    QObject::connect(&window.again(), &ExportAgain::noted, &watching_, follow);
    refresh();
}

void WindowActions::addFileMenu(Maker& make, MainWindow& window)
{
    make.menu(tr("&File"));
    make.add(tr("&Open…"), {QKeySequence(Qt::CTRL | Qt::Key_O)},
             tr("A preset, a picture with one inside, a scene of shapes, a model or a panorama."),
             [&window] { chooseFile(window); });
    make.submenu(recentMenu(&window, window.files()));
    addSaving(make, window);
    make.add(tr("Save e&xhibition…"), {},
             tr("Saves everything in one file: all exhibits, the hall and where you stand."),
             [&window] { window.presetController().saveExhibition(); });
    make.separator();
    make.add(tr("Screens&hot"), {QKeySequence(Qt::Key_F12)}, tr("Saves the picture as PNG in your pictures folder."),
             [&window] { saveScreenshot(window, window); });
    make.add(tr("&Copy picture"), {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C)},
             tr("Copies the picture to the clipboard."), [&window] { copyPicture(window); });
    make.add(tr("Copy as command &line"), {},
             tr("Copies a command line that renders the identical picture in a terminal."),
             [&window] { copyCommandLine(window); });
    make.add(tr("Export &picture…"), {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E)},
             tr("Saves the picture at any size, as PNG, JPEG, EXR or TIFF."),
             [&window] { window.dialogs().openJob(*jobs::findJob("render")); });
    enableOnly(
        make.add(tr("Export picture a&gain"), {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_E)},
                 tr("Exports the current view with the settings of the last export, under the next free name."),
                 [&window] { window.again().run(); }),
        [&window] { return window.again().possible(); },
        tr("No picture was exported yet; use “Export picture…” first."));
    make.add(tr("Recor&d…"), {QKeySequence(Qt::SHIFT | Qt::Key_F12)},
             tr("Records a video or frames: along bookmarks, around the current target, or as a tour of all exhibits."),
             [&window] { window.dialogs().openJob(*jobs::findJob("record")); });
    make.add(tr("Export le&nticular print…"), {QKeySequence(Qt::CTRL | Qt::Key_P)},
             tr("Exports a print for a lenticular sheet from views of the exhibit or your own pictures, or a "
                "calibration chart."),
             [&window] { window.dialogs().openPrint(); });
    make.add(tr("Export spr&ites…"), {},
             tr("Exports a sprite sheet of an object from all sides, with one palette, normals and depth, for games."),
             [&window] { window.dialogs().openJob(*jobs::findJob("sprite")); })
        ->setEnabled(window.museum().find(jobs::findJob("sprite")->needs().subject).has_value());
    enableOnly(
        make.add(QStringLiteral("export-table"), tr("Export measuremen&ts…"), {},
                 tr("Runs the measurements of the visited exhibit, such as the methods of the pixel art, and saves "
                    "them as CSV."),
                 [&window] { window.dialogs().openJob(*jobs::findJob("table")); }),
        [&window] { return capability<MeasuresTable>(window.museum().subject(window.chosen())) != nullptr; },
        tr("The visited exhibit has no table of measurements; the Study panel measures its parameters."));
    make.separator();
    make.add(tr("&Quit"), {QKeySequence(Qt::CTRL | Qt::Key_Q)},
             tr("Closes the window. The session is restored at the next start."), [&window] { window.close(); });
}

void WindowActions::addSaving(Maker& make, MainWindow& window)
{
    make.add(tr("&Save"), {QKeySequence(Qt::CTRL | Qt::Key_S)},
             tr("Saves your edits of the scene or the shader to its file; without any, the values in the panel to the "
                "preset in use."),
             [&window] {
                 DocumentFile& file = window.docks().documentFile();
                 file.flush();
                 if (file.edited())
                     file.save();
                 else
                     window.presetController().save();
             });
    enableOnly(
        make.add(QStringLiteral("save-file-as"), tr("Save scene or shader &as…"), {},
                 tr("Writes the scene or the shader to another file."),
                 [&window] { window.docks().documentFile().saveAs(); }),
        [&window] { return window.docks().documentFile().source() != nullptr; },
        tr("The visited exhibit shows no file that is edited here."));
}

void WindowActions::addEditMenu(Maker& make, MainWindow& window)
{
    make.menu(tr("&Edit"));
    QAction* undo = window.history().stack().createUndoAction(&window, tr("&Undo"));
    undo->setObjectName(QStringLiteral("undo"));
    undo->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
    make.take(undo);
    QAction* redo = window.history().stack().createRedoAction(&window, tr("&Redo"));
    redo->setObjectName(QStringLiteral("redo"));
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    make.take(redo);
    make.separator();
    QAction* search = make.add(tr("&Search…"), {QKeySequence(Qt::CTRL | Qt::Key_F), QKeySequence(Qt::CTRL | Qt::Key_K)},
                               tr("Finds parameters of all exhibits, presets, commands and pages."),
                               [this, &window] { (new SearchDialog(searchEntries(window, all), &window))->show(); });
    window.docks().parameters().setSearch(search);
    make.add(tr("P&in or unpin the parameter"), {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D)},
             tr("Shows the parameter with the focus under the essential ones, or puts it back to its group."),
             [&window] { window.panel().pinFocused(); });
    make.add(tr("Reset &all parameters"), {},
             tr("Resets all parameters in the panel to their initial values. Can be undone."),
             [&window] { resetShown(window); });
    make.add(QStringLiteral("vary-at-random"), tr("Randomi&ze parameters"),
             {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_V)},
             tr("Sets all parameters in the panel to random values within their slider ranges, except files, accuracy "
                "and excluded parameters (see their menus). Can be undone."),
             [&window] { window.panel().vary(); });
    make.separator();
    make.add(tr("Prefere&nces…"), {QKeySequence(Qt::CTRL | Qt::Key_Comma)},
             tr("Theme, size of type, motion, mouse, what a picture may cost, keys, recent files."),
             [&window] { window.preferences().openDialog(); });
}

void WindowActions::addPresetMenu(Maker& make, PresetController& presetController)
{
    make.menu(tr("&Preset"));
    savePreset = make.add(tr("&Save preset"), {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S)},
                          tr("Saves the values that the panel shows to the preset in use, or at once to a new one of "
                             "your own."),
                          [&presetController] { presetController.save(); });
    savePresetAs = make.add(tr("Save preset &as…"), {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)},
                            tr("Saves the values that the panel shows under a new name."),
                            [&presetController] { presetController.saveAs(); });
    make.separator();
    const qsizetype first = presetMenu.size();
    presetMenu << make.add(tr("&Rename preset"), {QKeySequence(Qt::Key_F2)}, tr("Renames the selected preset."),
                           [&presetController] { presetController.rename(); });
    presetMenu << make.add(tr("&Tags of preset…"), {},
                           tr("Edits the tags of the selected preset, by which it can be found."),
                           [&presetController] { presetController.editTags(); });
    presetMenu << make.add(tr("&Duplicate preset"), {}, tr("Copies the selected preset to a preset of your own."),
                           [&presetController] { presetController.duplicate(); });
    presetMenu << make.add(tr("De&lete preset"), {}, tr("Deletes the selected preset; undo brings it back."),
                           [&presetController] { presetController.remove(); });
    make.separator();
    QAction* importing = make.add(tr("&Import preset…"), {}, tr("Copies a preset file to your own presets."),
                                  [&presetController] { presetController.importFile(); });
    presetMenu << importing;
    presetMenu << make.add(tr("&Export preset…"), {}, tr("Writes the selected preset to a file."),
                           [&presetController] { presetController.exportFile(); });
    for (QAction* action : presetMenu.mid(first))
        if (action != importing)
            enableOnly(
                action, [&presetController] { return !presetController.selected().isEmpty(); },
                tr("No preset is selected in the list."));
}

void WindowActions::addViewMenu(Maker& make, MainWindow& window)
{
    make.menu(tr("&View"));
    panels =
        make.toggle(tr("Hide &panels"), {QKeySequence(Qt::CTRL | Qt::Key_B), QKeySequence(Qt::SHIFT | Qt::Key_F11)},
                    tr("Hides all panels and bars; only the picture is left."),
                    [&window](bool hidden) { window.hidePanels(hidden); });
    make.separator();
    for (QDockWidget* dock : window.docks().all()) {
        QAction* toggle = dock->toggleViewAction();
        toggle->setObjectName(QStringLiteral("panel-") + dock->objectName());
        toggle->setToolTip(tr("Shows or hides this panel."));
        toggle->setStatusTip(toggle->toolTip());
        make.take(toggle);
    }
    make.separator();
    addBookmarks(make, window);
    make.separator();
    addScreenAndClock(make, window);
}

void WindowActions::addScreenAndClock(Maker& make, MainWindow& window)
{
    fullScreen =
        make.toggle(tr("F&ull screen"), {QKeySequence(Qt::Key_F11)}, tr("Fills the screen."), [&window](bool on) {
            window.setWindowState(on ? window.windowState() | Qt::WindowFullScreen
                                     : window.windowState() & ~Qt::WindowFullScreen);
        });
    pause = make.toggle(tr("Pause &clock"), {QKeySequence(Qt::Key_Space), QKeySequence(Qt::Key_Pause)},
                        tr("Stops and starts the exhibits' clock."),
                        [&window](bool on) { window.viewport().clock().setPaused(on); });
    make.inViewport(pause);
#ifndef NDEBUG  // Release builds have embedded shaders.
    make.add(tr("&Reload shaders"), {QKeySequence(Qt::Key_F5), QKeySequence(Qt::CTRL | Qt::Key_R)},
             tr("Compiles changed shaders again; if one fails, the last good picture is kept."),
             [&window] { window.viewport().shaders().reload(); });
#endif
}

void WindowActions::addCompareMenu(Maker& make, const CompareActions& actions)
{
    make.menu(tr("&Compare"));
    make.submenu(&actions.sources());
    for (QAction* action : actions.all()) {
        if (action)
            make.take(action);
        else
            make.separator();
    }
    presetMenu << actions.preset();
}

void WindowActions::addExhibitMenu(Maker& make, MainWindow& window)
{
    make.menu(tr("E&xhibit"));
    make.add(QStringLiteral("entrance"), tr("Go to &entrance"), {QKeySequence(Qt::CTRL | Qt::Key_Home)},
             tr("Returns to the entrance of the hall."), [&window] { window.visit(hallIndex); });
    enableOnly(
        make.add(tr("&Back"), {QKeySequence(Qt::ALT | Qt::Key_Left)},
                 tr("Returns to where you stood before; Backspace does the same while the picture has the focus."),
                 [&window] { window.viewport().visitor().goBack(); }),
        [&window] { return window.viewport().visitor().canGoBack(); },
        tr("There is no earlier position to return to."));
    enableUnless(
        make.add(QStringLiteral("press-its-button"), tr("&Press the exhibit's button"), {},
                 tr("Presses the red button of the exhibit in front of you; E does the same while the picture has the "
                    "focus."),
                 [&window] { window.viewport().interaction().press(); }),
        [&window] { return translatedText(window.viewport().interaction().whyNotPress()); });
    make.add(tr("S&hader"), {QKeySequence(Qt::Key_F4)},
             tr("Shows the shaders that draw the visited exhibit; a shader of yours is edited there."),
             [&window] { window.docks().showShader(); });
    make.submenu(ownObjectsMenu(window));
    make.separator();
    for (QAction* action : window.lessons().menu()) make.take(action);
}

void WindowActions::addBookmarks(Maker& make, MainWindow& window)
{
    Bookmarks& bookmarks = window.bookmarks();
    make.add(tr("Add &bookmark"), {}, tr("Sets the first free one of the nine bookmarks to the current view."),
             [&bookmarks] { bookmarks.add(); });
    make.submenu(bookmarksMenu(&window, bookmarks));
    make.add(tr("&Manage bookmarks…"), {}, tr("Sets, visits and deletes bookmarks, and saves them as a tour."),
             [&window, &bookmarks] {
                 auto* dialog = new BookmarksDialog(bookmarks, &window);
                 QObject::connect(dialog, &BookmarksDialog::tourAsked, &window.dialogs(), &WindowDialogs::saveTour);
                 dialog->show();
             });
    QObject::connect(&window.viewport().input(), &ViewportInput::bookmarkAsked, &bookmarks, &Bookmarks::go);
}

void WindowActions::addHelpMenu(Maker& make, MainWindow& window)
{
    make.menu(tr("&Help"));
    make.add(QStringLiteral("how-this-works"), tr("About this e&xhibit"), {QKeySequence(Qt::Key_F1)},
             tr("Opens the page about the visited exhibit: its technique, figures, formulas, sources."),
             [&window] { window.dialogs().openPage(window.chosen()); });
    make.add(tr("&Keyboard, mouse and gamepad"), {QKeySequence(Qt::Key_Question), QKeySequence(Qt::SHIFT | Qt::Key_F1)},
             tr("All shortcuts on one page."), [this, &window] { (new ShortcutSheet(all, &window))->show(); });
    const QString manual = QString::fromStdString(render::manualFile().string());
    QAction* read = make.add(tr("&Manual"), {},
                             manual.isEmpty() ? tr("This copy of the program has no manual (README.md).")
                                              : tr("Opens %1.").arg(manual),
                             [manual] { QDesktopServices::openUrl(QUrl::fromLocalFile(manual)); });
    read->setEnabled(!manual.isEmpty());
    make.separator();
    make.add(tr("&About Vitrine"), {}, tr("Version, libraries, license."), [&window] { window.dialogs().openAbout(); });
}

void WindowActions::addWithoutMenu(Maker& make, MainWindow& window)
{
    make.noMenu();
    make.add(tr("Next panel"), {QKeySequence(Qt::Key_F6)},
             tr("Moves the focus to the next part of the window: picture, panels, clock."),
             [&window] { focusNextArea(window, 1); });
    make.add(tr("Previous panel"), {QKeySequence(Qt::SHIFT | Qt::Key_F6)},
             tr("Moves the focus to the previous part of the window."), [&window] { focusNextArea(window, -1); });
    make.add(tr("Show charts"), {}, tr("Shows the charts of the visited exhibit's values, beside its study."),
             [&window] { window.docks().showCharts(); });
    make.add(tr("Show log"), {}, tr("Shows all messages since the start, beside the frame report."),
             [&window] { window.docks().showLog(); });
    for (const int way : {1, -1})
        make.inViewport(make.add(way > 0 ? tr("Expose more") : tr("Expose less"),
                                 {QKeySequence(way > 0 ? Qt::Key_BracketRight : Qt::Key_BracketLeft)},
                                 way > 0 ? tr("Makes the picture brighter by a quarter of a stop.")
                                         : tr("Makes the picture darker by a quarter of a stop."),
                                 [&window, way] { expose(window, 0.25 * way); }));
    for (QAction* action : window.lessons().steps()) make.take(action);
    for (QAction* action : window.comparison().actions().more()) make.take(action);
    for (const auto& [i, exhibit] : window.museum().exhibits()) {
        const int place = exhibit.place();
        const bool hasKey = window.museum().isInHall(i) && place <= 10;  // Alt+0 stands for place 10.
        const Keys keys = hasKey ? Keys{QKeySequence(Qt::ALT | static_cast<Qt::Key>(Qt::Key_0 + place % 10))} : Keys{};
        make.add(QStringLiteral("visit-") + text(exhibit.name()), tr("Visit %1").arg(translatedText(exhibit.title())),
                 keys, translatedText(exhibit.summary()), [&window, index = i] { window.visit(index); });
    }
    Bookmarks& bookmarks = window.bookmarks();
    const auto key = [](int number) { return static_cast<Qt::Key>(Qt::Key_0 + number); };
    for (int number = 1; number <= Bookmarks::most; ++number) {
        make.add(
            QStringLiteral("go-to-bookmark-%1").arg(number), tr("Go to bookmark %1").arg(number),
            {QKeySequence(Qt::CTRL | key(number))},
            tr("Goes to the view of this bookmark; if it is not set, sets it to the current view."),
            [&bookmarks, number] { bookmarks.name(number).isEmpty() ? bookmarks.set(number) : bookmarks.go(number); });
        make.add(QStringLiteral("set-bookmark-%1").arg(number), tr("Set bookmark %1").arg(number),
                 {QKeySequence(Qt::CTRL | Qt::ALT | key(number))},
                 tr("Sets this bookmark to the current view and replaces the old one."),
                 [&bookmarks, number] { bookmarks.set(number); });
    }
}

}  // namespace vitrine::ui
