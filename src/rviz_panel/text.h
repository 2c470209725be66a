#pragma once

#include <QString>
#include <QStringList>
#include <string>
#include <vector>

/** Figures in words short enough for a narrow panel. */
namespace poinsot::rviz_panel::text {

inline const QString kUnknown = "–";

/** A running time in seconds, "12.35", without its unit; large ones with as many digits as doubles have. */
QString time(double value);

/** The same with its unit; "∞ s", "–" for NaN. */
QString seconds(double value);

/** The number that the user typed: a comma or a point, any minus sign, spaces around. */
double number(const QString& text, bool* ok);

/** With an SI prefix: "1.3 µs", "4.53 kJ"; "0 J". `unit` follows it. */
QString withPrefix(double value, const QString& unit, int digits = 3);

/** "1.2e−16", "0.0123"; "0". */
QString small(double value);

/** "×2", "×0.05", "×−1". */
QString speed(double value);

QStringList list(const std::vector<std::string>& texts);

/** Up to `digits` significant digits, a true minus sign. */
QString plain(double value, int digits = 6);

}  // namespace poinsot::rviz_panel::text
