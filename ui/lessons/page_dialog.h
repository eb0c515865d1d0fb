#pragma once

#include <QDialog>

#include <functional>

class QPushButton;
class QTextBrowser;

namespace vitrine {
class Parameters;
}

namespace vitrine::ui {

/// Window with a page about each exhibit: how its technique works, with figures, formulas and sources, and the table of
/// its parameters. Shows assets/pages/NAME.html, in Qt's rich text; links lead to other pages, to the web, and to
/// lessons
/// ("lesson:noise"). An exhibit without a page has the table alone.
class PageDialog final : public QDialog {
    Q_OBJECT

public:
    /// Returns the parameters of the exhibit (or hall) of this name; null where there is none.
    using FindParameters = std::function<const Parameters*(const QString& name)>;

    PageDialog(QWidget* window, FindParameters);

    /// The page of the subject of this name.
    void showPage(const QString& name);
    [[nodiscard]] QTextBrowser& browser() const { return *browser_; }

signals:
    /// Somebody wants to walk through this exhibit's lesson.
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
