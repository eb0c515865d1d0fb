#include "ui/editor/shader_panel.h"

#include "exhibits/framework/scene/text_document.h"
#include "exhibits/shader_export/stand_alone.h"
#include "render/failure.h"
#include "ui/editor/code_colors.h"
#include "ui/editor/document_file.h"
#include "ui/editor/find_bar.h"
#include "ui/editor/live_text.h"
#include "ui/editor/shader_copy.h"
#include "ui/kit/accessible_content.h"
#include "ui/kit/flow_layout.h"
#include "ui/kit/language.h"
#include "ui/kit/tab_order.h"
#include "ui/kit/text.h"
#include "ui/kit/type_size.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include <utility>

namespace vitrine::ui {
namespace {

QString fileName(const std::string& path)
{
    return QFileInfo(QString::fromStdString(path)).fileName();
}

QString titleOf(const PassText& text)
{
    const QString name = QString::fromStdString(text.pass);
    if (text.stage == "vertex") return ShaderPanel::tr("%1, vertex shader").arg(name);
    if (text.stage == "compute") return ShaderPanel::tr("%1, compute shader").arg(name);
    return ShaderPanel::tr("%1, fragment shader").arg(name);
}

}  // namespace

ShaderPanel::ShaderPanel(Workbench& window, DocumentFile& file, QWidget* parent)
    : QWidget(parent), window_(window), file_(file), live_(new LiveText(window, this)),
      copy_(new ShaderCopy(window, this)), layout_(new QVBoxLayout(this)), choice_(new QComboBox), state_(new QLabel),
      find_(new FindBar)
{
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(0);
    layout_->addWidget(bar());
    layout_->addWidget(state_);
    layout_->addWidget(find_);
    file_.setFlush([this] { live_->flush(); });
    connect(choice_, &QComboBox::activated, this, [this] {
        showChosen();
        if (!isEdited()) askForPasses();  // Values may have changed since.
    });
    connect(live_, &LiveText::replaced, this, &ShaderPanel::showReplaced);
    connect(live_, &LiveText::checked, this, &ShaderPanel::showFindings);
    connect(find_, &FindBar::asked, this, &ShaderPanel::find);
    connect(find_, &FindBar::closed, this, [this] {
        if (view_) view_->widget().setFocus();
    });
    connect(&window.history(), &History::changesSettled, this, [this] {
        if (isVisible() && (!isEdited() || passes_.empty())) askForPasses();
    });
    setFocusPolicy(Qt::NoFocus);
}

ShaderPanel::~ShaderPanel()
{
    if (planning_.valid()) planning_.wait();
}

QWidget* ShaderPanel::bar()
{
    auto* bar = new QWidget;
    auto* layout = new FlowLayout(bar);  // A narrow window breaks the line.
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(4);
    const auto button = [&](const QString& text, const QString& tip) {
        auto* made = new QToolButton;
        made->setText(text);
        made->setToolTip(tip);
        made->setAccessibleName(text);
        made->setFocusPolicy(Qt::StrongFocus);
        growHeight(*made, 26);
        layout->addWidget(made);
        return made;
    };
    choice_->setAccessibleName(tr("Text that is shown"));
    choice_->setToolTip(tr("Your shader, which you can edit, or the shader of a pass as the driver gets it."));
    choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice_->setMinimumContentsLength(18);
    choice_->setFocusPolicy(Qt::StrongFocus);
    growHeight(*choice_, 26);
    layout->addWidget(choice_);
    templates_ = button(tr("New"), tr("Begins a shader from a template. Your present text comes back with undo."));
    templates_->setPopupMode(QToolButton::InstantPopup);
    save_ = button(tr("Save"), tr("Writes your text to its file (Ctrl+S)."));
    outside_ =
        button(tr("Open in my editor"),
               tr("Saves the text, and opens its file in the program that your desktop has for it. What you save "
                  "there is shown here."));
    copyButton_ = button(tr("Copy as a shader of my own"), {});
    copyButton_->setEnabled(false);
    connect(copyButton_, &QToolButton::clicked, this, [this] { copy_->ask(subject_); });
    connect(save_, &QToolButton::clicked, this, [this] { file_.save(); });
    connect(outside_, &QToolButton::clicked, this, &ShaderPanel::openOutside);
    state_->setTextFormat(Qt::PlainText);
    state_->setAccessibleName(tr("State of the text"));
    state_->setMinimumWidth(40);
    state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    state_->setContentsMargins(8, 0, 8, 4);
    return bar;
}

void ShaderPanel::fillTemplates()
{
    delete templates_->menu();
    auto* menu = new QMenu(templates_);
    if (live_->source())
        for (const TextTemplate& each : live_->source()->templates())
            menu->addAction(translatedText(each.title), this, [this, each] {
                choice_->setCurrentIndex(0);
                live_->begin(each);
            });
    templates_->setMenu(menu);
}

void ShaderPanel::setSubject(std::size_t exhibit)
{
    if (subject_ == exhibit && choice_->count() > 0) return;
    subject_ = exhibit;
    passes_.clear();
    if (isVisible()) live_->setSubject(exhibit);
    fillTemplates();
    fillChoice();
    if (isVisible()) askForPasses();
}

void ShaderPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!view_) openView();
    live_->setSubject(subject_);
    fillTemplates();
    fillChoice();
    askForPasses();
}

void ShaderPanel::openView()
{
    try {
        view_ = openCodeView(this);
    } catch (const Failure& failure) {
        setState(translatedText(failure.message()));
        window_.say(MessageStrip::Mood::problem, translatedText(failure.message()));
        return;
    }
    QWidget& widget = view_->widget();
    widget.setAccessibleName(tr("Text of the shader"));
    widget.setAccessibleDescription(tr("F6 leaves the text, Ctrl+F finds words in it."));
    widget.installEventFilter(this);
    layout_->insertWidget(2, &widget, 1);
    tabAsLaidOut(*this);
    connect(&widget, &QWidget::customContextMenuRequested, this, &ShaderPanel::openMenu);
    view_->edited = [this] {
        if (isEdited()) live_->edit(view_->text());
    };
    dress();
}

void ShaderPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) dress();
}

void ShaderPanel::dress()
{
    if (view_) view_->setAppearance(codeColors(theme()), codeFont(*this));
}

bool ShaderPanel::isEdited() const
{
    return live_->source() && choice_->currentIndex() == 0;
}

void ShaderPanel::fillChoice()
{
    QStringList titles, present;
    if (live_->source()) titles << tr("%1, edited here").arg(fileName(live_->place().path));
    for (const PassText& each : passes_) titles << titleOf(each);
    for (int i = 0; i < choice_->count(); ++i) present << choice_->itemText(i);
    if (titles != present) {
        const QString before = choice_->currentText();
        const bool wasEdited = choice_->currentIndex() <= 0;
        choice_->clear();
        choice_->addItems(titles);
        const int at = live_->source() && wasEdited ? 0 : std::max(0, choice_->findText(before));
        choice_->setCurrentIndex(titles.isEmpty() ? -1 : at);
    }
    showChosen();
}

void ShaderPanel::showChosen()
{
    for (QToolButton* each : {templates_, save_, outside_}) each->setEnabled(live_->source() != nullptr);
    if (!view_) return;
    view_->setReadOnly(!isEdited());
    if (isEdited()) {
        if (view_->text() != live_->text()) view_->begin(live_->text());
        return showFindings();
    }
    const int index = choice_->currentIndex() - (live_->source() ? 1 : 0);
    const bool isPass = index >= 0 && index < static_cast<int>(passes_.size());
    const QString text = isPass ? QString::fromStdString(passes_[static_cast<std::size_t>(index)].text) : QString();
    view_->setNotes({});
    if (view_->text() != text) view_->begin(text);
    setState(isPass ? tr("As the driver gets it; read only.") : tr("Nothing of this exhibit is drawn now."));
}

void ShaderPanel::showReplaced()
{
    if (live_->source()) choice_->setItemText(0, tr("%1, edited here").arg(fileName(live_->place().path)));
    if (!view_ || !isEdited() || view_->text() == live_->text()) return;
    view_->replace(live_->text());
}

void ShaderPanel::showFindings()
{
    if (!view_ || !isEdited()) return;
    if (live_->isChecking()) return setState(tr("Checking…"));
    std::vector<CodeNote> notes;
    const std::string own = live_->place().path;
    const TextFinding* first = nullptr;
    for (const TextFinding& each : live_->findings()) {
        const QString sentence = translatedText(each.sentence);
        if (each.file == own)
            notes.push_back({each.line, each.column, sentence, each.isError});
        else
            notes.push_back({1, 1,
                             QStringLiteral("%1:%2:%3: %4")
                                 .arg(QString::fromStdString(each.file))
                                 .arg(each.line)
                                 .arg(each.column)
                                 .arg(sentence),
                             each.isError});
        if (!first && each.isError) first = &each;
    }
    view_->setNotes(notes);
    setState(first
                 ? tr("Line %1: %2 The last good picture stays.").arg(first->line).arg(translatedText(first->sentence))
                 : tr("The picture shows this text."));
}

void ShaderPanel::setState(const QString& text)
{
    if (text == state_->text()) return;
    state_->setText(text);
    state_->setToolTip(text);
    if (isEdited() && !live_->isChecking()) announce(*state_, text);
}

QString ShaderPanel::stateText() const
{
    return state_->text();
}

void ShaderPanel::askForPasses()
{
    if (planning_.valid() && planning_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    planning_ = std::async(std::launch::async,
                           [this, &museum = window_.museum(), exhibit = subject_,
                            state = window_.history().sceneState(), request = window_.viewport().scene().request()] {
                               std::vector<PassText> passes;
                               QString whyNoCopy = tr("This is a shader of your own already.");
                               try {
                                   passes = passTexts(museum, state, request, exhibit);
                                   if (exhibit == hallIndex)
                                       whyNoCopy = tr("The hall is drawn by many passes; visit an exhibit first.");
                                   else if (!capability<HasText>(museum.subject(exhibit)))
                                       whyNoCopy = translatedText(guest::whyNotAlone(museum, state, exhibit));
                               } catch (const Failure&) {
                                   // A file that is missing is reported with the picture.
                               }
                               QMetaObject::invokeMethod(
                                   this,
                                   [this, exhibit, whyNoCopy, passes = std::move(passes)]() mutable {
                                       takePasses(exhibit, std::move(passes), whyNoCopy);
                                   },
                                   Qt::QueuedConnection);
                           });
}

void ShaderPanel::takePasses(std::size_t exhibit, std::vector<PassText> passes, const QString& whyNoCopy)
{
    if (exhibit != subject_) return askForPasses();
    copyButton_->setEnabled(whyNoCopy.isEmpty());
    copyButton_->setToolTip(whyNoCopy.isEmpty()
                                ? tr("Writes the shader of this exhibit, with its present settings, into a file that "
                                     "you can change, and shows it as a shader of your own.")
                                : whyNoCopy);
    passes_ = std::move(passes);
    fillChoice();
}

void ShaderPanel::openOutside()
{
    if (!live_->source()) return;
    live_->flush();
    if ((file_.edited() || !live_->place().writable) && !file_.save()) return;
    QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(live_->place().path)));
}

void ShaderPanel::openMenu(const QPoint& at)
{
    using Command = CodeView::Command;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [&](const QString& text, Command command) {
        menu->addAction(text, this, [this, command] { view_->perform(command); })->setEnabled(view_->can(command));
    };
    add(tr("&Undo"), Command::undo);
    add(tr("&Redo"), Command::redo);
    menu->addSeparator();
    add(tr("Cu&t"), Command::cut);
    add(tr("&Copy"), Command::copy);
    add(tr("&Paste"), Command::paste);
    add(tr("Select &all"), Command::selectAll);
    menu->addSeparator();
    menu->addAction(tr("&Find…\tCtrl+F"), this, [this] { find_->open(view_->selected()); });
    menu->popup(view_->widget().mapToGlobal(at));
}

void ShaderPanel::find(const QString& words, bool forward)
{
    if (view_) find_->setFound(view_->find(words, forward));
}

bool ShaderPanel::eventFilter(QObject* object, QEvent* event)
{
    const bool override = event->type() == QEvent::ShortcutOverride;
    if (!view_ || object != &view_->widget() || (!override && event->type() != QEvent::KeyPress))
        return QWidget::eventFilter(object, event);
    const auto& key = *static_cast<QKeyEvent*>(event);
    const bool finds = key.matches(QKeySequence::Find);
    const bool again = key.key() == Qt::Key_F3 && !find_->words().text().isEmpty();
    const bool closes = key.key() == Qt::Key_Escape && find_->isVisible();
    if (!finds && !again && !closes) return QWidget::eventFilter(object, event);
    event->accept();
    if (override) return true;
    if (finds)
        find_->open(view_->selected());
    else if (closes)
        find_->hide();
    else
        find(find_->words().text(), !(key.modifiers() & Qt::ShiftModifier));
    return true;
}

}  // namespace vitrine::ui

#include "moc_shader_panel.cpp"
