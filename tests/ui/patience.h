#pragma once

// Qt Test's own limit of five seconds fails where the machine is slow or does something else as well. Tests wait for
// what will come; the limit is there for what never does. Precompiled into every program of this folder.
#include <QSignalSpy>
#include <QTest>

namespace vitrine::test {
inline constexpr int patience = 300000;  ///< Milliseconds.
}

#undef QTRY_VERIFY
#define QTRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, vitrine::test::patience)
#undef QTRY_COMPARE
#define QTRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, vitrine::test::patience)
#undef QTRY_VERIFY2
#define QTRY_VERIFY2(condition, message) QTRY_VERIFY2_WITH_TIMEOUT(condition, message, vitrine::test::patience)
