#pragma once

#include "exhibits/printing/print_table.h"

namespace vitrine::printing::test {

/// Returns the values of the print table that give these settings, for descriptions of prints that a test lays out.
inline ParameterValues valuesOf(const PrintSettings& s)
{
    const PrintTable& table = printTable();
    ParameterValues values = withSheet(table.initial(), s.sheet);
    values.set(table.dotsPerInch, s.dpiX);
    values.set(table.dotsDown, s.dpiY == s.dpiX ? 0.0 : s.dpiY);
    values.set(table.width, s.width / 1000);
    values.set(table.height, s.height / 1000);
    values.set(table.bleed, s.bleed / 1000);
    values.set(table.distance, s.distance / 1000);
    values.set(table.visualPerInch, s.visualLpi);
    values.set(table.phase, s.phase);
    values.set(table.direction, s.direction * radiansPerDegree);
    values.set(table.reverse, s.reverse);
    values.set(table.mirror, s.mirror);
    values.set(table.method, s.method);
    values.set(table.guard, s.guard);
    values.set(table.border, s.border / 1000);
    values.set(table.inkSpread, s.inkSpread / 1000);
    values.set(table.compensate, s.compensate);
    values.set(table.dither, s.dither);
    return values;
}

}  // namespace vitrine::printing::test
