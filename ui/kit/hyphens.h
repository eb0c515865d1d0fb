#pragma once

#include <QString>

namespace vitrine::ui {

/// Soft hyphen (U+00AD): a line may break there, and only then shows a hyphen.
constexpr QChar softHyphen{0x00AD};

/// Returns the word with soft hyphens between its syllables, by rules that hold for most German and English words: a
/// syllable begins with the last consonant before a vowel, or with letters that are one sound. At least three letters
/// are before the first and after the last one.
[[nodiscard]] QString withSoftHyphens(const QString& word);

}  // namespace vitrine::ui
