#pragma once

namespace vitrine::ui {

/// First pictures of the hall: the first shows no exhibit, and each further one adds an exhibit, until adding one is
/// quick. So the first picture comes soon although files are read and programs are compiled.
class Opening {
public:
    static constexpr double scale = 0.5;  ///< Resolution of these pictures, so that they come soon.
    /// Seconds. When one exhibit was added as fast as this, the next picture shows all of them.
    static constexpr double quick = 0.5;

    void setExhibits(int count) { exhibits_ = count; }
    [[nodiscard]] bool isUnderway() const { return isUnderway_; }
    /// Number of exhibits in the next picture.
    [[nodiscard]] int shown() const { return shown_; }
    /// Takes note of a picture that took this many seconds.
    void drawn(double seconds)
    {
        isUnderway_ = !(shown_ > 0 && seconds < quick) && shown_ < exhibits_;
        ++shown_;
    }

private:
    bool isUnderway_ = true;
    int exhibits_ = 0, shown_ = 0;
};

}  // namespace vitrine::ui
