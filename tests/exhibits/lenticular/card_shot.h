#pragma once

#include "exhibits/lenticular/lenticular.h"
#include "exhibits/printing/sheet.h"
#include "tests/support/gallery.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <string>
#include <vector>

namespace vitrine::test {

inline const LenticularTable& cardTable()
{
    static const LenticularTable table;
    return table;
}

/// The linear light of view `k` of `count` solid ones: (k + 1) / (count + 1), rounded to a code of sRGB.
[[nodiscard]] double solidLevel(int k, int count);

/// Folders of views that each have one color; gray of `solidLevel`. White and black ones tell the light that falls on
/// the print from what the plastic mirrors.
class CardViews {
public:
    [[nodiscard]] std::string solid(int count);
    [[nodiscard]] std::string level(double linear);

private:
    TemporaryFolder folder_;
};

/// The card alone, from far away and through a narrow lens, its strips made for parallel eyes.
struct CardShot : Shot {
    CardShot();

    std::size_t card = 0;

    [[nodiscard]] ParameterValues& values() { return sceneState.values[card]; }
    /// Sees the card's middle from `angle` across and `rise` above (radians), `distance` meters away, so that a
    /// pixel is `pixel` meters wide there (the whole picture no less than 1 degree).
    CardShot& from(double angle, double distance, double pixel, double rise = 0);
    /// The printed linear light at every pixel, in the channel: what remains between a black and a white print.
    [[nodiscard]] std::vector<double> printed(CardViews&, const std::string& views, int channel = 1);
};

}  // namespace vitrine::test
