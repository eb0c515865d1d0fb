// A guard by a macro: a compiler cache may hand out a precompiled header of the same code with other comments, and
// then `#pragma once`, which compares the file's bytes, does not recognize the file.
#ifndef VITRINE_TESTS_UI_PATIENCE_H
#define VITRINE_TESTS_UI_PATIENCE_H

// Qt Test's limit of five seconds is too short for slow or busy machines. Tests wait for events that will come; the
// limit is for those that never do. Precompiled into all programs of this folder.
#include <QSignalSpy>
#include <QTest>

namespace vitrine::test {
inline constexpr int patience = 300000;  ///< Limit in milliseconds.
}

#undef QTRY_VERIFY
#define QTRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, vitrine::test::patience)
#undef QTRY_COMPARE
#define QTRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, vitrine::test::patience)
#undef QTRY_VERIFY2
#define QTRY_VERIFY2(condition, message) QTRY_VERIFY2_WITH_TIMEOUT(condition, message, vitrine::test::patience)

#endif
