#include "ui/report/log_view.h"

#include <QPointer>
#include <QTime>

namespace vitrine::ui {
namespace {

QPointer<LogView> open;
QtMessageHandler before = nullptr;

void handle(QtMsgType type, const QMessageLogContext& context, const QString& text)
{
    if (before) before(type, context, text);
    if (type == QtDebugMsg || !open) return;
    // Messages may come from any thread, and at any point of other work.
    QMetaObject::invokeMethod(
        open.data(),
        [text] {
            if (open) open->add(text);
        },
        Qt::QueuedConnection);
}

}  // namespace

LogView::LogView(QWidget* parent) : QPlainTextEdit(parent)
{
    setReadOnly(true);
    setAccessibleName(tr("Log"));
    setFrameShape(QFrame::NoFrame);
    setMaximumBlockCount(2000);
    setLineWrapMode(QPlainTextEdit::NoWrap);
    setTabChangesFocus(true);
    open = this;
    before = qInstallMessageHandler(handle);
}

LogView::~LogView()
{
    qInstallMessageHandler(before);
}

void LogView::add(const QString& text)
{
    appendPlainText(QTime::currentTime().toString(QStringLiteral("HH:mm:ss")) + QStringLiteral("  ") + text);
}

}  // namespace vitrine::ui

#include "moc_log_view.cpp"
