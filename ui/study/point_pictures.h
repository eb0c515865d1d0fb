#pragma once

#include "render/measure/metrics.h"
#include "ui/study/picture_panes.h"

#include <QWidget>

#include <string>
#include <vector>

class QComboBox;
class QLabel;

namespace vitrine::ui {

class LargePictures;
class StudyPictures;

/// Pictures of one setting of a study in one of its views, with a caption and the choice of the view. Hidden while
/// there is no caption.
class PointPictures final : public QWidget {
    Q_OBJECT

public:
    explicit PointPictures(QWidget* parent = nullptr);

    /// Offers these views and selects the first, without a signal.
    void setViews(const std::vector<std::string>& names);
    /// Returns the index of the selected view; 0 if there is none.
    [[nodiscard]] std::size_t view() const;
    /// Shows a picture, its reference, and their difference by the metric.
    void showPictures(render::Image picture, render::Image reference, render::Metric);
    void hidePictures();
    /// Sets the caption. Call it after the pictures are set: it updates the large view, too.
    void setCaption(const QString&);

signals:
    void viewChosen();

private:
    void layOut();
    void enlarge();
    void fillLarge();

    QComboBox* view_;
    StudyPictures* pictures_;
    QLabel* caption_;
    PictureTriple shown_;             ///< Content of `pictures_`.
    QString scale_;                   ///< Sentence on the range of the heat map.
    LargePictures* large_ = nullptr;  ///< Null until it is opened.
};

/// Label of several lines that can be narrower than its text.
[[nodiscard]] QLabel* wrappedLabel(QWidget* parent);

}  // namespace vitrine::ui
