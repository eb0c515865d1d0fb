#pragma once

#include <QColor>
#include <QFont>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

class QWidget;

namespace vitrine::ui {

/// Colors of a text of code.
struct CodeColors {
    QColor background, text, margin, marginText, currentLine, selection, selectionText;
    QColor keyword, type, function, number, comment, directive, error, remark;
};

/// Error or remark that is shown below its line.
struct CodeNote {
    int line = 1, column = 1;  ///< From 1; columns in bytes of UTF-8.
    QString text;
    bool isError = true;
};

/// View of a text of GLSL with line numbers and an undo of its own. Its widget belongs to the parent that
/// `openCodeView` was given, and must not outlive this object.
class CodeView {
public:
    enum class Command { undo, redo, cut, copy, paste, selectAll };

    virtual ~CodeView() = default;

    [[nodiscard]] virtual QWidget& widget() = 0;
    [[nodiscard]] virtual QString text() const = 0;
    /// Shows another text, which cannot be undone.
    virtual void begin(const QString& text) = 0;
    /// Replaces the text as one step of the view's undo, and keeps the place. `edited` is not called.
    virtual void replace(const QString& text) = 0;
    virtual void setReadOnly(bool) = 0;
    virtual void setNotes(const std::vector<CodeNote>&) = 0;
    /// Returns the notes below a line, from 1, as they are shown.
    [[nodiscard]] virtual QString noteAt(int line) const = 0;
    virtual void setAppearance(const CodeColors&, const QFont&) = 0;
    /// Selects the next or last occurrence of `words`, without regard to case, from the cursor on and around the end.
    /// Returns whether there is one.
    virtual bool find(const QString& words, bool forward) = 0;
    [[nodiscard]] virtual QString selected() const = 0;
    /// Returns the line of the cursor, from 1.
    [[nodiscard]] virtual int line() const = 0;
    virtual void goTo(int line) = 0;
    [[nodiscard]] virtual bool can(Command) const = 0;
    virtual void perform(Command) = 0;

    std::function<void()> edited;  ///< Called after the visitor changed the text.
};

/// Opens the module `vitrine_editor`, the only one that uses QScintilla, and makes a view. Throws Failure if it cannot
/// be opened.
[[nodiscard]] std::unique_ptr<CodeView> openCodeView(QWidget* parent);

/// Entry point of the module; the caller owns the result. Returns null if `version` is not `codeViewVersion`.
constexpr int codeViewVersion = 1;
extern "C" vitrine::ui::CodeView* vitrineCodeView(int version, QWidget* parent);

}  // namespace vitrine::ui
