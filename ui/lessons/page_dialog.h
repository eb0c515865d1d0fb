#pragma once

#include <QDialog>

#include <functional>

class QPushButton;
class QTextBrowser;

namespace vitrine {
class Parameters;
}

namespace vitrine::ui {

/// Window with a page about each exhibit: its technique with figures, formulas and sources, and a table of its
/// parameters. Shows assets/pages/NAME.html as Qt's rich text. Links lead to other pages, to the web, and to lessons
/// ("lesson:noise"). An exhibit without a page has the table alone.
class PageDialog final : public QDialog {
    Q_OBJECT

public:
    /// Returns the parameters of the exhibit (or hall) of this name; null if there is none.
    using FindParameters = std::function<const Parameters*(const QString& name)>;

    PageDialog(QWidget* window, FindParameters);

    /// Returns the path of the page of this name in the present language, or in English if there is none.
    [[nodiscard]] static QString pathOf(const QString& name);
    /// Shows the page of the subject of this name.
    void showPage(const QString& name);
    [[nodiscard]] QTextBrowser& browser() const { return *browser_; }

signals:
    /// Asks to open this exhibit's lesson.
    void lessonAsked(const QString& exhibit);

private:
    class Browser;
    void follow(const QUrl&);
    void noteSource(const QUrl& source);

    QTextBrowser* browser_;
    QPushButton* lesson_;
    QPushButton* back_;
};

}  // namespace vitrine::ui
