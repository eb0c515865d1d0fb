#include "ui/lessons/page_dialog.h"

#include "render/files/assets.h"
#include "ui/kit/language.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/lessons/formula_text.h"
#include "ui/parameters/shown_text.h"

#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileInfo>
#include <QPushButton>
#include <QScreen>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

namespace vitrine::ui {
namespace {

QString pageFolder()
{
    return QString::fromStdString(render::asset("pages").string());
}

/// Returns the style sheet of the pages, in the colors of the window.
QString pageStyle()
{
    return QStringLiteral("h1 { font-size: x-large; margin-bottom: 4px; } h2 { font-size: large; margin-top: 16px; }"
                          "p, li { line-height: 130%; } a { color: %1; } .caption { color: %2; }"
                          ".formula { margin-left: 24px; } th { text-align: left; }")
        .arg(theme().accent.name(), theme().dim.name());
}

/// Returns a table of all parameters as HTML, in the present language: label, help, and initial value with range.
QString parameterTable(const Parameters& table)
{
    QString html =
        QStringLiteral("<h2>%1</h2><table cellspacing=\"0\" cellpadding=\"4\">").arg(PageDialog::tr("Parameters"));
    std::string_view group;
    for (const ParameterInfo& parameter : table.rows()) {
        if (parameter.group != group)
            html += QStringLiteral("<tr><td colspan=\"3\"><b>%1</b></td></tr>")
                        .arg(translatedText(parameter.group).toHtmlEscaped());
        group = parameter.group;
        QString values = PageDialog::tr("initially %1").arg(shownText(parameter, parameter.initial));
        if (parameter.isNumeric()) values += QStringLiteral("<br>") + legalRangeText(parameter).toHtmlEscaped();
        html += QStringLiteral("<tr><td>%1</td><td>%2</td><td class=\"caption\">%3</td></tr>")
                    .arg(translatedText(label(parameter)).toHtmlEscaped(),
                         translatedText(parameter.help).toHtmlEscaped(), values);
    }
    return html + QStringLiteral("</table>");
}

/// Returns the page's text followed by the table of parameters.
QString withTable(const QString& page, const Parameters& table)
{
    const qsizetype end = page.lastIndexOf(QStringLiteral("</body>"));
    QString whole = page;
    return whole.insert(end < 0 ? page.size() : end, parameterTable(table));
}

QString nameOfPage(const QUrl& source)
{
    return QFileInfo(source.path()).baseName();
}

}  // namespace

/// Browser whose pages show their formulas as text, and end with the table of the exhibit's parameters.
class PageDialog::Browser final : public QTextBrowser {
public:
    Browser(QWidget* parent, FindParameters find) : QTextBrowser(parent), find_(std::move(find)) {}

protected:
    QVariant loadResource(int type, const QUrl& name) override
    {
        // The pages' style sheet is for web browsers; here, `pageStyle` has the colors of the window.
        if (type == QTextDocument::StyleSheetResource) return QByteArray();
        if (type != QTextDocument::HtmlResource) return QTextBrowser::loadResource(type, name);
        QFile file(name.toLocalFile());
        const QString page =
            withFormulasAsText(file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString());
        const Parameters* table = find_(nameOfPage(name));
        return table ? withTable(page, *table) : page;
    }

private:
    FindParameters find_;
};

PageDialog::PageDialog(QWidget* window, FindParameters find)
    : QDialog(window), browser_(new Browser(this, std::move(find)))
{
    setAttribute(Qt::WA_DeleteOnClose);
    browser_->setAccessibleName(tr("How it works"));
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->setOpenLinks(false);
    browser_->document()->setDefaultStyleSheet(pageStyle());
    browser_->document()->setDocumentMargin(20);
    connect(browser_, &QTextBrowser::anchorClicked, this, &PageDialog::follow);
    connect(browser_, &QTextBrowser::sourceChanged, this, &PageDialog::noteSource);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    back_ = buttons->addButton(tr("&Back"), QDialogButtonBox::ActionRole);
    back_->setAutoDefault(false);
    back_->setEnabled(false);
    connect(back_, &QPushButton::clicked, browser_, &QTextBrowser::backward);
    connect(browser_, &QTextBrowser::backwardAvailable, back_, &QPushButton::setEnabled);
    lesson_ = buttons->addButton(tr("&Start the exhibit's lesson"), QDialogButtonBox::ActionRole);
    lesson_->setAutoDefault(false);
    connect(lesson_, &QPushButton::clicked, this, [this] { emit lessonAsked(nameOfPage(browser_->source())); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 8);
    layout->addWidget(browser_, 1);
    layout->addWidget(buttons);
    buttons->setContentsMargins(8, 0, 8, 0);
    resize(QSize(grown(760, *this), 760).boundedTo(screen()->availableSize() - QSize(32, 96)));
    browser_->setFocus();
}

QString PageDialog::pathOf(const QString& name)
{
    const QString file = QLatin1Char('/') + name + QStringLiteral(".html");
    const QString own = pageFolder() + QLatin1Char('/') + languageCode() + file;
    return QFileInfo::exists(own) ? own : pageFolder() + file;
}

void PageDialog::showPage(const QString& name)
{
    browser_->setSource(QUrl::fromLocalFile(pathOf(name)));
}

void PageDialog::follow(const QUrl& link)
{
    if (link.scheme() == QLatin1String("lesson"))
        emit lessonAsked(link.path());
    else if (link.scheme().startsWith(QLatin1String("http")))
        QDesktopServices::openUrl(link);
    else if (link.isRelative() && link.path().endsWith(QLatin1String(".html")))
        // Links lead to pages in the present language, even from a page in another one.
        showPage(QFileInfo(link.path()).baseName());
    else
        browser_->setSource(browser_->source().resolved(link));
}

void PageDialog::noteSource(const QUrl& source)
{
    const QString name = nameOfPage(source);  // The browser's own source() is still the page before.
    lesson_->setEnabled(
        QFileInfo::exists(pageFolder() + QStringLiteral("/../lessons/") + name + QStringLiteral(".md")));
    lesson_->setToolTip(lesson_->isEnabled() ? QString() : tr("There is no lesson about this exhibit."));
    const QString title = browser_->documentTitle();
    setWindowTitle(title.isEmpty() ? tr("About this exhibit") : title);
}

}  // namespace vitrine::ui

#include "moc_page_dialog.cpp"
