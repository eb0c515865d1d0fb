#pragma once

#include "exhibits/lenticular/lenticular.h"
#include "exhibits/printing/sheet.h"
#include "tests/support/gallery.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <string>
#include <vector>

namespace vitrine::test {

/// Returns the linear light of view `k` of `count` solid ones: (k + 1) / (count + 1), rounded to an sRGB code.
[[nodiscard]] double solidLevel(int k, int count);

/// Folders of views with one color each; gray views have `solidLevel`. White and black ones separate the light that the
/// print reflects from that of the plastic.
class CardViews {
public:
    [[nodiscard]] std::string solid(int count);
    [[nodiscard]] std::string level(double linear);

private:
    TemporaryFolder folder_;
};

/// Shot of the card alone, upright with the center of its front at the origin, from far away with a narrow field of
/// view, and with strips for parallel view directions.
struct CardShot : ExhibitShot<lenticular::LenticularTable> {
    CardShot();

    /// Looks at the card's center from `angle` across and `rise` above (radians), `distance` meters away. A pixel is
    /// `pixel` meters wide there; the whole picture is at least 1 degree wide.
    CardShot& from(double angle, double distance, double pixel, double rise = 0);
    /// Returns the linear light of the print at every pixel, in one channel: relative to a black and a white print.
    [[nodiscard]] std::vector<double> printed(CardViews&, const std::string& views, int channel = 1);
};

inline const lenticular::LenticularTable& cardTable()
{
    return CardShot::table();
}

}  // namespace vitrine::test
