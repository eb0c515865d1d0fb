#pragma once

#include <QDir>
#include <QImage>
#include <QPainter>
#include <QStringList>

#include <cmath>

namespace vitrine::test {

/// Writes a still life in front of a striped wall, seen from `count` places on a line, to `folder` in viewing order.
/// Returns the files.
inline QStringList paintedViews(const QString& folder, int count)
{
    QStringList files;
    for (int k = 0; k < count; ++k) {
        const double aside = count > 1 ? 2.0 * k / (count - 1) - 1 : 0;  // Position of the camera, -1 to 1.
        QImage image(960, 680, QImage::Format_RGB32);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        QLinearGradient wall(0, 0, 0, 680);
        wall.setColorAt(0, QColor(96, 110, 124));
        wall.setColorAt(1, QColor(190, 170, 140));
        painter.fillRect(image.rect(), wall);
        painter.setPen(Qt::NoPen);
        for (int i = -2; i < 14; ++i) {
            painter.setBrush(QColor(80, 92, 108, 120));
            painter.drawRect(QRectF(i * 90 + aside * 34, 0, 40, 470));
        }
        painter.setBrush(QColor(120, 84, 56));
        painter.drawRect(0, 470, 960, 210);
        const auto ball = [&](double x, double y, double radius, double nearness, const QColor& color) {
            const QPointF middle(x - aside * nearness, y);
            painter.setBrush(QColor(0, 0, 0, 70));
            painter.drawEllipse(QPointF(middle.x(), y + radius * 0.95), radius, radius * 0.2);
            QRadialGradient shade(middle + QPointF(-radius * 0.35, -radius * 0.4), radius * 1.5);
            shade.setColorAt(0, color.lighter(170));
            shade.setColorAt(0.5, color);
            shade.setColorAt(1, color.darker(300));
            painter.setBrush(shade);
            painter.drawEllipse(middle, radius, radius);
        };
        ball(300, 390, 110, -14, QColor(70, 120, 90));
        ball(520, 420, 130, 6, QColor(190, 80, 50));
        ball(690, 510, 80, 34, QColor(220, 170, 60));
        painter.end();
        files << QDir(folder).filePath(QStringLiteral("view%1.png").arg(k, 3, 10, QLatin1Char('0')));
        image.save(files.back());
    }
    return files;
}

}  // namespace vitrine::test
