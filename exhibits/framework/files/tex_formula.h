#pragma once

#include "render/text/message.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace vitrine {

/// Formula as MathML, or why it could not be read.
struct TexFormula {
    std::string mathMl;    ///< `<math>…</math>`; empty if there is a problem.
    Message problem = {};  ///< Empty: none.
    std::size_t at = 0;    ///< Place of the problem in the formula, in bytes.
};

/// Converts a formula in a small subset of TeX to MathML:
///
///  - letters, numbers, and + - = < > / ( ) [ ] | , . : ; ! ' *
///  - x^2, x_i, x_i^2, with {…} for more than one sign; \frac{a}{b}, \sqrt{a}
///  - \sum, \int, \prod with limits; \sin \cos \tan \exp \log \ln \min \max \lim
///  - Greek letters (\alpha … \omega, \Gamma … \Omega), and signs such as \cdot \times \pm \le \ge \ne \approx \to
///  \infty
///  - \text{words}, \mathrm{name}, \mathbf{v}; \left( and \right) as plain signs; \quad and \, as space
///
/// `isDisplayed`: the formula has a line of its own. Groups are nested at most 16 deep. Never throws.
[[nodiscard]] TexFormula mathMlOfTex(std::string_view tex, bool isDisplayed);

}  // namespace vitrine
