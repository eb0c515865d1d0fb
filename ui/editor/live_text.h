#pragma once

#include "exhibits/framework/scene/text_document.h"

#include <QElapsedTimer>
#include <QMetaObject>
#include <QObject>
#include <QString>
#include <QTimer>

#include <cstddef>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::ui {

class Workbench;

/// Text of the visited exhibit's document while it is edited. Each key begins a check of the text on a thread of its
/// own; a pause after the last key, its result is taken. A text without errors becomes the shown one, as one step of
/// the window's history. A text with errors is kept beside the last good one, so that sessions store it.
class LiveText final : public QObject {
    Q_OBJECT

public:
    /// Milliseconds without a key before a text without errors is shown.
    static constexpr int pause = 80;
    /// Milliseconds without a key before errors are shown: most texts between two keys have some.
    static constexpr int errorPause = 300;

    /// The window must outlive this object.
    explicit LiveText(Workbench&, QObject* parent = nullptr);
    /// Waits for the end of a check.
    ~LiveText() override;

    void setSubject(std::size_t exhibit);
    /// Returns the exhibit's interface to its text; null if it has none.
    [[nodiscard]] const HasText* source() const { return source_; }
    [[nodiscard]] const QString& text() const { return text_; }
    [[nodiscard]] DocumentPlace place() const;

    /// Takes the text that the visitor typed.
    void edit(const QString& text);
    /// Keeps the typed text in the values at once, before it is checked.
    void flush();
    /// Shows another file: a template.
    void begin(const TextTemplate&);

    /// Errors and remarks of the text that was checked last.
    [[nodiscard]] const std::vector<TextFinding>& findings() const { return findings_; }
    /// True from a key to the end of the check of its text.
    [[nodiscard]] bool isChecking() const { return timer_.isActive() || running_ || checked_; }

signals:
    /// Emitted when the text was changed by something else than `edit`: undo, a preset, another program.
    void replaced();
    /// Emitted when a check began or ended.
    void checked();

private:
    /// A text, and what the check found in it.
    struct Checked {
        std::string text;
        std::vector<TextFinding> findings;
    };

    [[nodiscard]] const ParameterValues& values() const;
    void load();
    void check();
    void paused();
    void finishCheck(const std::string& text, std::vector<TextFinding> findings);
    void take(Checked);
    void apply(const std::string& text);
    void setDraft(const std::string& text);
    /// Copies the text of the file to the document parameter, and removes the draft.
    void beginDocument();

    Workbench& window_;
    const HasText* source_ = nullptr;
    std::size_t subject_ = 0;
    QMetaObject::Connection watched_;
    QString text_;
    std::vector<TextFinding> findings_;
    QTimer timer_;
    QElapsedTimer sinceKey_;
    std::optional<std::string> running_;  ///< Text that is being checked.
    std::optional<Checked> checked_;      ///< Result that waits for the pause.
    bool isTyped_ = false;                ///< The text was typed and is not in the values yet.
    bool applying_ = false;               ///< The present change of the history comes from here.
    std::future<void> check_;
};

/// Returns the text of a file as it is edited: UTF-8, or Latin-1 if it is no UTF-8.
[[nodiscard]] QString editedText(const std::string& bytes);

}  // namespace vitrine::ui
