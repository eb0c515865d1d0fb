// Editor module: all code that uses QScintilla.
#include "ui/editor/code_view.h"
#include "ui/editor/scintilla/glsl_words.h"

#include <QFontMetrics>
#include <QPointer>
#include <QStringList>

#include <Qsci/qscilexercpp.h>
#include <Qsci/qsciscintilla.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int numbers = 0, marks = 1;                   // Margins.
constexpr int errorMark = 1, remarkMark = 2;            // Markers.
constexpr int errorUnderline = 8, remarkUnderline = 9;  // Indicators.
constexpr int errorStyle = 100, remarkStyle = 101;      // Above those of the lexer.

/// Lexer of GLSL: that of C++ with other words.
class GlslLexer final : public QsciLexerCPP {
public:
    using QsciLexerCPP::QsciLexerCPP;
    [[nodiscard]] const char* keywords(int set) const override
    {
        switch (set) {
        case 1: return glslKeywords;
        case 2: return glslFunctions;
        case 4: return glslTypes;  // The set of global classes.
        default: return nullptr;
        }
    }
};

/// Returns the text in lines of at most `columns` characters, unless a word is longer.
QString wrapped(const QString& text, qsizetype columns)
{
    QStringList lines;
    for (const QString& paragraph : text.split(QLatin1Char('\n'))) {
        QString line;
        for (const QString& word : paragraph.split(QLatin1Char(' '))) {
            if (!line.isEmpty() && line.size() + 1 + word.size() > columns) lines << std::exchange(line, QString());
            line += (line.isEmpty() ? QString() : QStringLiteral(" ")) + word;
        }
        lines << line;
    }
    return lines.join(QLatin1Char('\n'));
}

class ScintillaView final : public CodeView {
public:
    explicit ScintillaView(QWidget* parent) : view_(new QsciScintilla(parent)), lexer_(new GlslLexer(view_))
    {
        view_->setUtf8(true);
        view_->setFrameShape(QFrame::NoFrame);
        view_->setLexer(lexer_);
        view_->SendScintilla(QsciScintilla::SCI_SETPROPERTY, "lexer.cpp.track.preprocessor", "0");
        view_->setTabWidth(4);
        view_->setIndentationsUseTabs(false);
        view_->setAutoIndent(true);
        view_->setBraceMatching(QsciScintilla::SloppyBraceMatch);
        view_->setCaretLineVisible(true);
        view_->setCaretWidth(2);
        view_->setMarginType(numbers, QsciScintilla::NumberMargin);
        view_->setMarginType(marks, QsciScintilla::SymbolMargin);
        view_->setMarginMarkerMask(marks, (1 << errorMark) | (1 << remarkMark));
        view_->setMarginWidth(2, 0);
        view_->markerDefine(QsciScintilla::RightTriangle, errorMark);
        view_->markerDefine(QsciScintilla::Circle, remarkMark);
        view_->indicatorDefine(QsciScintilla::SquiggleIndicator, errorUnderline);
        view_->indicatorDefine(QsciScintilla::DotsIndicator, remarkUnderline);
        view_->setAnnotationDisplay(QsciScintilla::AnnotationIndented);
        view_->setScrollWidthTracking(true);
        view_->setScrollWidth(1);
        view_->setContextMenuPolicy(Qt::CustomContextMenu);
        leaveKeysToTheWindow();
        QObject::connect(view_, &QsciScintilla::textChanged, view_, [this] { noteChange(); });
        fitNumbers();
    }
    ~ScintillaView() override { delete view_; }

    [[nodiscard]] QWidget& widget() override { return *view_; }
    [[nodiscard]] QString text() const override { return view_->text(); }
    void begin(const QString& text) override
    {
        quietly([&] {
            takeLineEndsOf(text);
            const bool readOnly = view_->isReadOnly();
            view_->setReadOnly(false);
            view_->setText(text);
            view_->SendScintilla(QsciScintilla::SCI_EMPTYUNDOBUFFER);
            view_->setReadOnly(readOnly);
            view_->setCursorPosition(0, 0);
        });
    }
    void replace(const QString& text) override
    {
        quietly([&] {
            takeLineEndsOf(text);
            int line = 0, column = 0;
            view_->getCursorPosition(&line, &column);
            const int first = view_->firstVisibleLine();
            view_->beginUndoAction();
            view_->selectAll();
            view_->replaceSelectedText(text);
            view_->endUndoAction();
            line = std::min(line, view_->lines() - 1);
            view_->setCursorPosition(line, std::min(column, view_->lineLength(line)));
            view_->setFirstVisibleLine(first);
        });
    }
    void setReadOnly(bool on) override
    {
        view_->setReadOnly(on);
        view_->setCaretLineVisible(!on);
    }

    void setNotes(const std::vector<CodeNote>& notes) override
    {
        view_->clearAnnotations();
        view_->markerDeleteAll(errorMark);
        view_->markerDeleteAll(remarkMark);
        for (const int underline : {errorUnderline, remarkUnderline})
            view_->clearIndicatorRange(0, 0, view_->lines(), 0, underline);
        for (const CodeNote& note : notes) {
            const int line = std::clamp(note.line - 1, 0, view_->lines() - 1);
            const QString before = annotation(line);
            view_->annotate(line,
                            (before.isEmpty() ? QString() : before + QLatin1Char('\n')) + wrapped(note.text, columns()),
                            note.isError ? errorStyle : remarkStyle);
            view_->markerAdd(line, note.isError ? errorMark : remarkMark);
            underline(line, note.column, note.isError ? errorUnderline : remarkUnderline);
        }
    }
    [[nodiscard]] QString noteAt(int line) const override { return annotation(line - 1); }

    void setAppearance(const CodeColors& colors, const QFont& font) override
    {
        lexer_->setDefaultFont(font);
        lexer_->setDefaultColor(colors.text);
        lexer_->setDefaultPaper(colors.background);
        for (int style = 0; style < QsciScintillaBase::STYLE_DEFAULT; ++style) {
            lexer_->setFont(font, style);
            lexer_->setPaper(colors.background, style);
            lexer_->setColor(colorOf(style, colors), style);
        }
        view_->setPaper(colors.background);
        view_->setColor(colors.text);
        view_->setMarginsFont(font);
        view_->setMarginsBackgroundColor(colors.margin);
        view_->setMarginsForegroundColor(colors.marginText);
        view_->setCaretForegroundColor(colors.text);
        view_->setCaretLineBackgroundColor(colors.currentLine);
        view_->setSelectionBackgroundColor(colors.selection);
        view_->setSelectionForegroundColor(colors.selectionText);
        view_->setMatchedBraceBackgroundColor(colors.currentLine);
        view_->setMatchedBraceForegroundColor(colors.keyword);
        view_->setUnmatchedBraceBackgroundColor(colors.background);
        view_->setUnmatchedBraceForegroundColor(colors.error);
        for (const auto& [style, color] :
             {std::pair(errorStyle, colors.error), std::pair(remarkStyle, colors.remark)}) {
            view_->SendScintilla(QsciScintilla::SCI_STYLESETFORE, static_cast<unsigned long>(style), color);
            view_->SendScintilla(QsciScintilla::SCI_STYLESETBACK, static_cast<unsigned long>(style), colors.margin);
            view_->SendScintilla(QsciScintilla::SCI_STYLESETFONT, static_cast<unsigned long>(style),
                                 font.family().toUtf8().constData());
            view_->SendScintilla(
                QsciScintilla::SCI_STYLESETSIZEFRACTIONAL, static_cast<unsigned long>(style),
                static_cast<long>(font.pointSizeF() * static_cast<int>(QsciScintilla::SC_FONT_SIZE_MULTIPLIER)));
        }
        for (const auto& [mark, color] : {std::pair(errorMark, colors.error), std::pair(remarkMark, colors.remark)}) {
            view_->setMarkerBackgroundColor(color, mark);
            view_->setMarkerForegroundColor(color, mark);
        }
        view_->setIndicatorForegroundColor(colors.error, errorUnderline);
        view_->setIndicatorForegroundColor(colors.remark, remarkUnderline);
        view_->setMarginWidth(marks, view_->fontMetrics().height());
        fitNumbers();
    }

    bool find(const QString& words, bool forward) override
    {
        if (words.isEmpty()) return false;
        int line = 0, column = 0, endLine = 0, endColumn = 0;
        view_->getSelection(&line, &column, &endLine, &endColumn);
        if (line < 0) {
            view_->getCursorPosition(&line, &column);
            endLine = line;
            endColumn = column;
        }
        return view_->findFirst(words, false, false, false, true, forward, forward ? endLine : line,
                                forward ? endColumn : column);
    }
    [[nodiscard]] QString selected() const override { return view_->selectedText(); }
    [[nodiscard]] int line() const override
    {
        int line = 0, column = 0;
        view_->getCursorPosition(&line, &column);
        return line + 1;
    }
    void goTo(int line) override
    {
        view_->setCursorPosition(std::clamp(line - 1, 0, view_->lines() - 1), 0);
        view_->ensureLineVisible(line - 1);
    }
    [[nodiscard]] bool can(Command command) const override
    {
        switch (command) {
        case Command::undo: return view_->isUndoAvailable();
        case Command::redo: return view_->isRedoAvailable();
        case Command::cut: return !view_->isReadOnly() && view_->hasSelectedText();
        case Command::copy: return view_->hasSelectedText();
        case Command::paste: return !view_->isReadOnly();
        case Command::selectAll: return true;
        }
        return false;
    }
    void perform(Command command) override
    {
        switch (command) {
        case Command::undo: return view_->undo();
        case Command::redo: return view_->redo();
        case Command::cut: return view_->cut();
        case Command::copy: return view_->copy();
        case Command::paste: return view_->paste();
        case Command::selectAll: return view_->selectAll();
        }
    }

private:
    /// Returns the note below a line, counted from 0. QsciScintilla::annotation of QScintilla 2.14.1 returns other
    /// bytes.
    [[nodiscard]] QString annotation(int line) const
    {
        const auto at = static_cast<unsigned long>(line);
        const long size =
            view_->SendScintilla(QsciScintillaBase::SCI_ANNOTATIONGETTEXT, at, static_cast<void*>(nullptr));
        QByteArray text(static_cast<qsizetype>(size), '\0');
        view_->SendScintilla(QsciScintillaBase::SCI_ANNOTATIONGETTEXT, at, static_cast<void*>(text.data()));
        return QString::fromUtf8(text);
    }
    /// Removes keys of Scintilla that the window uses: Ctrl+L would delete a line where a lesson is expected.
    void leaveKeysToTheWindow()
    {
        constexpr int control = QsciScintilla::SCMOD_CTRL, shift = QsciScintilla::SCMOD_SHIFT;
        for (const int key : {'L', 'T', 'U', 'D'})
            for (const int modifiers : {control, control | shift})
                view_->SendScintilla(QsciScintilla::SCI_CLEARCMDKEY,
                                     static_cast<unsigned long>(key | (modifiers << 16)));
    }
    /// Changes the text without a call of `edited`.
    template <typename Work> void quietly(const Work& work)
    {
        const bool before = std::exchange(quiet_, true);
        work();
        quiet_ = before;
    }
    void noteChange()
    {
        fitNumbers();
        if (!quiet_ && edited) edited();
    }
    void fitNumbers()
    {
        view_->setMarginWidth(
            numbers, QString(std::max<qsizetype>(3, QString::number(view_->lines()).size()) + 1, QLatin1Char('8')));
    }
    /// New lines end as those of the text do.
    void takeLineEndsOf(const QString& text)
    {
        const bool windows = text.contains(QLatin1String("\r\n"));
        view_->setEolMode(windows ? QsciScintilla::EolWindows : QsciScintilla::EolUnix);
    }
    /// Returns the number of characters that fit beside the margins.
    [[nodiscard]] qsizetype columns() const
    {
        const int width =
            std::max(1, QFontMetrics(lexer_->defaultFont(QsciLexerCPP::Default)).horizontalAdvance(QLatin1Char('0')));
        return std::max(32, (view_->width() - view_->marginWidth(numbers) - view_->marginWidth(marks)) / width - 8);
    }
    /// Underlines the word at a column, which counts bytes.
    void underline(int line, int column, int indicator)
    {
        const QString text = view_->text(line);
        const qsizetype start = QString::fromUtf8(text.toUtf8().left(column - 1)).size();
        qsizetype end = start;
        const auto isWord = [&](qsizetype i) { return text[i].isLetterOrNumber() || text[i] == QLatin1Char('_'); };
        while (end < text.size() && isWord(end)) ++end;
        if (end == start && end < text.size() && !text[end].isSpace()) ++end;
        if (end > start)
            view_->fillIndicatorRange(line, static_cast<int>(start), line, static_cast<int>(end), indicator);
    }
    [[nodiscard]] static QColor colorOf(int style, const CodeColors& colors)
    {
        switch (style) {
        case QsciLexerCPP::Comment:
        case QsciLexerCPP::CommentLine:
        case QsciLexerCPP::CommentDoc:
        case QsciLexerCPP::CommentLineDoc:
        case QsciLexerCPP::CommentDocKeyword:
        case QsciLexerCPP::CommentDocKeywordError: return colors.comment;
        case QsciLexerCPP::Number:
        case QsciLexerCPP::DoubleQuotedString:
        case QsciLexerCPP::SingleQuotedString:
        case QsciLexerCPP::UnclosedString: return colors.number;
        case QsciLexerCPP::Keyword: return colors.keyword;
        case QsciLexerCPP::KeywordSet2: return colors.function;
        case QsciLexerCPP::GlobalClass: return colors.type;
        case QsciLexerCPP::PreProcessor: return colors.directive;
        default: return colors.text;
        }
    }

    QPointer<QsciScintilla> view_;
    GlslLexer* lexer_;
    bool quiet_ = false;
};

}  // namespace
}  // namespace vitrine::ui

extern "C" __attribute__((visibility("default"))) vitrine::ui::CodeView* vitrineCodeView(int version, QWidget* parent)
{
    return version == vitrine::ui::codeViewVersion ? new vitrine::ui::ScintillaView(parent) : nullptr;
}
