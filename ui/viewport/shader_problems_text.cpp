#include "ui/viewport/shader_problems_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace vitrine::ui {

QString shaderProblemsText(const std::vector<render::gl::ShaderProblem>& problems)
{
    QStringList lines;
    for (const render::gl::ShaderProblem& problem : problems)
        lines << QStringLiteral("%1:%2  %3")
                     .arg(QString::fromStdString(problem.file))
                     .arg(problem.line)
                     .arg(QString::fromStdString(problem.message).trimmed());
    if (!lines.isEmpty())
        lines.prepend(QCoreApplication::translate(
            "Viewport", "A shader failed to compile; the last good picture is kept. Save the file to try again."));
    return lines.join(QLatin1Char('\n'));
}

}  // namespace vitrine::ui
